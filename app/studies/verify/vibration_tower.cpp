// A tower of rigid stones under its weight that vibrates on its joints: nothing lands, nothing is lost.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "app/studies/verify/picture.h"
#include "app/studies/verify/vibration.h"

namespace voussoir::app::studies::verify
{

RunReport run_moving(const scenes::StagedScene& scene, const std::function<void(State&)>& push,
                     const RunObserver& observer, VerifyResult& result)
{
    scenes::StagedScene part{scene.model, scene.stages};
    State state = initial_state(scene.model);
    const Stage last = part.stages.back();
    part.stages.pop_back();
    if (!part.stages.empty()) {
        const RunReport rest = run_scene(part, state, {}, result);
        if (!result.failure.empty()) return rest;
    }
    part.stages = {last};
    state.stage = 0;
    begin_stage(scene.model, 0, state);
    push(state);
    return run_scene(part, state, observer, result);
}

double frequency_of(const std::vector<double>& times, const std::vector<double>& values)
{
    double first = 0, last = 0;
    int passages = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (!(values[i - 1] < 0 && values[i] >= 0)) continue;
        const double share = values[i - 1] / (values[i - 1] - values[i]);
        last = times[i - 1] + share * (times[i] - times[i - 1]);
        if (passages++ == 0) first = last;
    }
    return passages < 2 ? 0 : (passages - 1) / (last - first);
}

double amplitude_of(const std::vector<double>& times, const std::vector<double>& values, double frequency)
{
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        sum += values[i] * std::polar(1.0, -2 * std::numbers::pi * frequency * times[i]);
    return 2 * std::abs(sum) / static_cast<double>(values.size());
}

namespace
{

constexpr int courses = 30, cycles = 20;
constexpr double width = 1, course = 1;  // m
constexpr double density = 2000, young = 2e9;
constexpr double push = 1e-3;  // m/s at the top

scenes::StagedScene tower_scene(const scenes::SceneSetting& setting, double duration)
{
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = 35 * std::numbers::pi / 180;
    joint.stiffness = scenes::stiffness_by_rule(setting, 2 * course / young);
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"stone", density, young, 0.2}, joint, width);
    scenes::hold(scene.model, scenes::add_box(scene.model, "base", {-width, -width, -1}, {width, width, 0}));
    for (int i = 0; i < courses; ++i)
        scenes::add_box(scene.model, fmt::format("course {}", i + 1), {-width / 2, -width / 2, i * course},
                        {width / 2, width / 2, (i + 1) * course});
    scene.stages = {scenes::static_stage(setting), scenes::dynamic_stage(setting, duration)};
    return scene;
}

/// Sideways like a cantilever, as the square of the height, each stone turning with the slope there.
void bend(const Model& model, State& state)
{
    const double height = courses * course;
    for (int i = 1; i <= courses; ++i) {
        const double z = (i - 0.5) * course;
        double* velocity = state.velocities.data() + i * unknowns_per_block(model.kinematics);
        velocity[0] = push * z * z / (height * height);
        const double slope = push * 2 * z / (height * height);
        if (is_planar(model.kinematics))
            velocity[2] = -slope;  // turns from x to z are positive
        else
            velocity[4] = slope;
    }
}

/// What the tower did.
struct Swing {
    std::vector<double> times, tops, kinetic;  // s, m, J
};

/// The largest kinetic energy of a stretch of the record [J].
double largest(const Swing& swing, double from, double to)
{
    double most = 0;
    for (std::size_t i = 0; i < swing.times.size(); ++i)
        if (swing.times[i] >= from && swing.times[i] <= to) most = std::max(most, swing.kinetic[i]);
    return most;
}

Swing swing_of(const scenes::SceneSetting& setting, double duration, VerifyResult& result, RunReport& report)
{
    const scenes::StagedScene scene = tower_scene(setting, duration);
    Swing swing;
    double rest = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport& so_far) {
        swing.times.push_back(now.stage_time);
        swing.tops.push_back(pose_of(scene.model.kinematics, now, courses).centroid.x() - rest);
        swing.kinetic.push_back(so_far.energy.kinetic);
    };
    report = run_moving(
        scene,
        [&](State& state) {
            rest = pose_of(scene.model.kinematics, state, courses).centroid.x();
            bend(scene.model, state);
        },
        observer, result);
    return swing;
}

VerifyResult run_tower_vibration(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    RunReport report;
    const Swing first = swing_of(setting, 6, result, report);
    const double frequency = frequency_of(first.times, first.tops), period = 1 / frequency;
    const Swing swing = swing_of(setting, cycles * period, result, report);
    if (!result.failure.empty()) return result;
    if (report.energy.impact != 0) {
        result.failure = fmt::format("impacts took {:.1e} J, and nothing lands", report.energy.impact);
        return result;
    }
    result.picture = linear_diagram("time [s]", "top [m]", {curve_of("engine", swing.times, swing.tops)});
    const double before = largest(swing, 0, period),
                 after = largest(swing, (cycles - 1) * period, cycles * period);
    const double omega = 2 * std::numbers::pi * frequency;
    const double expected = std::exp(-2 * own_damping(setting, omega) * omega * (cycles - 1) * period);
    result.error = std::abs(after / before - expected);
    result.note =
        fmt::format("{:.2f} Hz; after {} cycles {:.4f} of the energy, by the integrator's damping {:.4f}",
                    frequency, cycles, after / before, expected);
    return result;
}

}  // namespace

std::vector<Benchmark> tower_vibration_rows()
{
    Benchmark row;
    row.name = "tower-vibration";
    row.title = "A tower of rigid stones under its weight in free vibration, at defaults";
    row.source = "docs/method.md (Integrators): conservation of energy; not from a paper";
    row.quantity = "|kinetic energy of the last of 20 cycles / first - what the integrator's damping leaves|";
    row.choices =
        "30 stones of 1 m, 2 GPa, pushed as a cantilever by 1 mm/s at the top: no joint opens, so that none lands "
        "and "
        "the impact term stays zero.";
    row.tolerance = 0.01;
    row.setting.kinematics = Kinematics::spatial_rigid;
    row.setting.time_step = 2e-3;
    row.run = run_tower_vibration;
    return {row};
}

}  // namespace voussoir::app::studies::verify
