#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/picture.h"
#include "app/studies/verify/rocking.h"

namespace voussoir::app::studies::verify
{

scenes::StagedScene rocking_scene(const scenes::SceneSetting& setting, const RockingCase& rocking, double duration)
{
    const references::RockingBlock& block = rocking.block;
    const double width = block.half_width, height = 2 * block.half_height;
    JointMaterial joint;
    joint.name = "rough";
    joint.friction_angle = rocking.friction * std::numbers::pi / 180;
    joint.stiffness = rocking.stiffness;
    if (setting.stiffness_factor) joint.stiffness = scenes::stiffness_by_rule(setting, height / rocking.young);
    joint.relaxation_time = rocking.relaxation_time;
    joint.face = FaceLaw::corners;  // the references have springs at the corners, or none that yield
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"stone", rocking.density, rocking.young, 0.2}, joint, 1);
    const double reach = 15 * width;
    scenes::hold(scene.model, scenes::add_box(scene.model, "base", {-reach, -0.5, -1}, {reach, 0.5, 0}));
    scenes::add_box(scene.model, "block", {-width, -0.5, 0}, {width, 0.5, height});
    Stage shaking = scenes::dynamic_stage(setting, duration);
    if (block.amplitude > 0) {
        const GroundMotion pulse =
            GroundMotion::sine_acceleration(block.amplitude, block.frequency, 0, 0.5 / block.frequency);
        shaking.motions = {{0, 0, std::make_shared<const GroundMotion>(pulse)}};
    }
    scene.stages = {scenes::static_stage(setting), shaking};
    return scene;
}

LeanRecord watch_rocking(const scenes::SceneSetting& setting, const RockingCase& rocking, double duration,
                         VerifyResult& result, const std::function<bool(double time, double lean)>& stop)
{
    const scenes::StagedScene scene = rocking_scene(setting, rocking, duration);
    State state = initial_state(scene.model);
    LeanRecord record;
    bool done = false;
    double rest = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const double lean = lean_of(scene.model, now, 1);
        if (now.stage == 0) {
            rest = lean;
            return;
        }
        record.times.push_back(now.stage_time);
        record.angles.push_back(lean - rest);
        done = stop && stop(now.stage_time, lean - rest);
    };
    observer.stop = [&] { return done; };
    run_scene(scene, state, observer, result);
    return record;
}

double lean_difference(const LeanRecord& record, const std::vector<double>& exact, double end)
{
    double worst = 0, peak = 0;
    for (std::size_t i = 0; i < exact.size() && record.times[i] <= end; ++i) {
        worst = std::max(worst, std::abs(record.angles[i] - exact[i]));
        peak = std::max(peak, std::abs(exact[i]));
    }
    return worst / peak;
}

plots::Diagram lean_picture(const LeanRecord& record, const std::vector<double>& exact)
{
    return linear_diagram(
        "time [s]", "rotation [rad]",
        {curve_of("reference", record.times, exact, true), curve_of("engine", record.times, record.angles)});
}

std::vector<double> apexes_after(const LeanRecord& record, double time)
{
    std::vector<double> found;
    double most = 0;
    bool right = record.angles.front() > 0;
    for (std::size_t i = 0; i < record.times.size(); ++i) {
        if (record.times[i] < time) continue;
        if ((record.angles[i] > 0) != right) {
            if (most > 1e-3) found.push_back(most);
            most = 0;
            right = !right;
        }
        most = std::max(most, std::abs(record.angles[i]));
    }
    return found;
}

}  // namespace voussoir::app::studies::verify
