#include "app/report/onset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "libdda/model/gravity_ramp.h"
#include "libdda/model/standard_gravity.h"

namespace voussoir::app::report
{
namespace
{

using Eigen::Vector3d;
using Json = nlohmann::json;

/// A vector as the settings have it: x, y, z, or x, z of a planar scene.
Vector3d vector_of(const Json& list)
{
    const auto values = list.get<std::vector<double>>();
    if (values.size() == 2) return {values[0], 0, values[1]};
    return values.size() == 3 ? Vector3d(values[0], values[1], values[2]) : Vector3d::Zero().eval();
}

/// A stage in which gravity turns or grows.
struct RampedStage {
    int index = 0;
    double start = 0;  // s of the run
    GravityRamp ramp;
    Vector3d gravity = Vector3d::Zero();  // m/s2, that it comes to

    Vector3d at(double time) const
    {
        const double since = std::max(0.0, time - start);
        return mean_gravity(ramp, gravity, since, since);
    }
};

std::optional<RampedStage> ramped_stage_in(const RunRecord& record)
{
    RampedStage stage;
    for (const Json& one : Json::parse(record.settings)) {
        if (one.contains("gravity_ramp")) {
            const Json& ramp = one.at("gravity_ramp");
            stage.gravity = vector_of(one.at("gravity_m_s2"));
            stage.ramp = {ramp.at("duration_s").get<double>(), vector_of(ramp.at("from_m_s2")),
                          ramp.at("turns").get<bool>()};
            return stage;
        }
        stage.start += one.value("duration_s", 0.0);
        ++stage.index;
    }
    return std::nullopt;
}

double tilt(const Vector3d& gravity)
{
    return std::atan2(gravity.head<2>().norm(), -gravity.z()) * 180 / std::numbers::pi;
}

/// "12.1°" of gravity that turns; else "0.31 g sideways and 1 g down".
std::string gravity_in_words(const RampedStage& stage, double time)
{
    const Vector3d gravity = stage.at(time);
    if (stage.ramp.turns) return fmt::format("{:.3g}°", tilt(gravity));
    const double sideways = gravity.head<2>().norm() / standard_gravity, down = -gravity.z() / standard_gravity;
    return sideways > 0 ? fmt::format("{:.3g} g sideways and {:.3g} g down", sideways, down)
                        : fmt::format("{:.3g} g", down);
}

/// A joint that moves first, between two stored moments.
struct FirstMove {
    double before = 0, after = 0;  // s
    std::size_t joint = 0;
};

double moved_since(const JointNow& then, const JointNow& now)
{
    return std::max(now.motion.opening - then.motion.opening, now.motion.largest_slip - then.motion.largest_slip);
}

std::optional<FirstMove> first_move(const RunRecord& record, const RampedStage& stage)
{
    std::optional<results::RecordedFrame> begin;
    double before = stage.start;
    for (std::size_t i = 0; i < record.results.times.size(); ++i) {
        if (record.results.stages[i] > stage.index) break;
        results::RecordedFrame frame = record.results.frame(i);
        if (record.results.stages[i] < stage.index || frame.time <= stage.start || !begin) {
            results::begin_motion(frame);  // what the stones did as they came to rest is no onset
            begin = std::move(frame);
            continue;
        }
        FirstMove first{before, frame.time, 0};
        double most = noteworthy_opening;
        for (std::size_t j = 0; j < frame.joints.size(); ++j)
            if (const double moved = moved_since(begin->joints[j], frame.joints[j]); moved > most)
                most = moved, first.joint = j;
        if (most > noteworthy_opening) return first;
        before = frame.time;
    }
    return std::nullopt;
}

}  // namespace

std::vector<std::string> onset_row(const RunRecord& record)
{
    const std::optional<RampedStage> stage = ramped_stage_in(record);
    if (!stage || record.results.model.joints.empty()) return {};
    const char* what = stage->ramp.turns ? "tilt at the onset of motion" : "gravity at the onset of motion";
    const std::optional<FirstMove> first = first_move(record, *stage);
    if (!first) {
        const double last = std::min(record.course.times.back(), stage->start + stage->ramp.duration);
        return {what,
                fmt::format("none up to {}: no joint opened or slid by 0.1 mm", gravity_in_words(*stage, last)),
                ""};
    }
    const WatchedJoint& joint = record.results.model.joints[first->joint];
    const std::vector<std::string>& names = record.results.model.block_names;
    return {
        what,
        fmt::format("{} to {}, between the stored moments t = {:.4g} and {:.4g} s: a joint opens or slides by "
                    "0.1 mm",
                    gravity_in_words(*stage, first->before), gravity_in_words(*stage, first->after), first->before,
                    first->after),
        names[static_cast<std::size_t>(joint.block_a)] + " and " + names[static_cast<std::size_t>(joint.block_b)]};
}

}  // namespace voussoir::app::report
