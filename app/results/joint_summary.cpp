#include "app/results/joint_summary.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "libdda/analysis/joints_now.h"

namespace voussoir::app::results
{

namespace
{

using Json = nlohmann::ordered_json;

Json time_or_null(const std::optional<double>& time)
{
    return time ? Json(*time) : Json(nullptr);
}

Json entry(const Model& model, const WatchedJoint& joint, const JointNow& now, const JointPeaks& peaks)
{
    return {{"blocks", {model.blocks[joint.block_a].name, model.blocks[joint.block_b].name}},
            {"area_m2", joint.area},
            {"facing_area_m2", joint.facing_area},
            {"area_in_use_m2", now.area_in_use},
            {"opening_m", now.motion.opening},
            {"mean_opening_m", now.motion.mean_opening},
            {"largest_opening_m", peaks.opening},
            {"opened_time_s", time_or_null(peaks.opened)},
            {"slip_m", now.motion.slip},
            {"largest_slip_m", peaks.slip},
            {"slid_time_s", time_or_null(peaks.slid)},
            {"normal_force_N", now.normal_force},
            {"shear_force_N", now.shear_force},
            {"eccentricity_m", now.eccentricity},
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

Json joint_summary(const Model& model, const std::vector<WatchedJoint>& joints, const State& state,
                   const RunReport& report)
{
    const std::vector<JointNow> now = joints_now(model, joints, state, joint_resultants(model, state));
    const std::vector<JointPeaks>& peaks = report.joints;
    const auto have = [&](const std::optional<double> JointPeaks::*time) {
        return std::count_if(peaks.begin(), peaks.end(),
                             [&](const JointPeaks& joint) { return (joint.*time).has_value(); });
    };
    Json list = Json::array();
    for (const std::size_t i : listed(peaks)) list.push_back(entry(model, joints[i], now[i], peaks[i]));
    return {{"count", joints.size()},
            {"opened", have(&JointPeaks::opened)},
            {"slid", have(&JointPeaks::slid)},
            {"broken", std::count_if(now.begin(), now.end(), [](const JointNow& joint) { return joint.broken; })},
            {"counts_from_m", noteworthy_opening},
            {"listed", list.size()},
            {"list", list}};
}

}  // namespace voussoir::app::results
