#include "app/results/joint_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

namespace voussoir::app::results
{

namespace
{

using Json = nlohmann::ordered_json;

Json time_or_null(const std::optional<double>& time)
{
    return time ? Json(*time) : Json(nullptr);
}

/// As many digits as results.h5 has.
double short_number(double value)
{
    return std::strtod(fmt::format("{:.7g}", value).c_str(), nullptr);
}

Json entry(const Model& model, const WatchedJoint& joint, const JointNow& now, const JointPeaks& peaks)
{
    return {{"blocks", {model.blocks[joint.block_a].name, model.blocks[joint.block_b].name}},
            {"area_m2", short_number(joint.area)},
            {"facing_area_m2", short_number(joint.facing_area)},
            {"area_in_use_m2", short_number(now.area_in_use)},
            {"opening_m", short_number(now.motion.opening)},
            {"mean_opening_m", short_number(now.motion.mean_opening)},
            {"largest_opening_m", short_number(peaks.opening)},
            {"opened_time_s", time_or_null(peaks.opened)},
            {"slip_m", short_number(now.motion.slip)},
            {"largest_slip_m", short_number(peaks.slip)},
            {"slid_time_s", time_or_null(peaks.slid)},
            {"normal_force_N", short_number(now.normal_force)},
            {"shear_force_N", short_number(now.shear_force)},
            {"eccentricity_m", short_number(now.eccentricity)},
            {"broken", now.broken}};
}

/// Which joints are listed, in ascending order: all, or those that moved most.
std::vector<std::size_t> listed(const std::vector<JointPeaks>& peaks)
{
    std::vector<std::size_t> order(peaks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (order.size() <= most_listed_joints) return order;
    const auto moved = [&](std::size_t i) { return std::max(peaks[i].opening, peaks[i].slip); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return moved(i) > moved(j); });
    order.resize(most_listed_joints);
    std::sort(order.begin(), order.end());
    return order;
}

}  // namespace

std::string joint_counts(const std::vector<JointPeaks>& peaks, const std::vector<JointNow>& now)
{
    const auto have = [&](const std::optional<double> JointPeaks::*time) {
        return std::count_if(peaks.begin(), peaks.end(),
                             [&](const JointPeaks& joint) { return (joint.*time).has_value(); });
    };
    const Json json = {
        {"count", peaks.size()},
        {"opened", have(&JointPeaks::opened)},
        {"slid", have(&JointPeaks::slid)},
        {"broken", std::count_if(now.begin(), now.end(), [](const JointNow& joint) { return joint.broken; })},
        {"counts_from_m", noteworthy_opening},
        {"listed", std::min(peaks.size(), most_listed_joints)},
        {"list", Json::array()}};
    return json.dump();
}

std::string joint_lines(const Model& model, const std::vector<WatchedJoint>& joints,
                        const std::vector<JointPeaks>& peaks, const std::vector<JointNow>& now)
{
    std::string lines;
    for (const std::size_t i : listed(peaks)) {
        if (!lines.empty()) lines += ",";
        lines += "\n      " +
                 entry(model, joints[i], now[i], peaks[i]).dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    return lines;
}

}  // namespace voussoir::app::results
