// A shear wave that meets a slipping joint, as the program does it when it is told nothing.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/slipping_joint.h"
#include "app/studies/verify/waves.h"

namespace voussoir::app::studies::verify
{

namespace
{

// One cycle of 10 Hz climbs 26 stones to the joint and as many beyond, 40 of them to its length: what the surface
// and the base send back comes to the joint after all has been measured.
constexpr double frequency = 10, speed = 400, density = 2000;  // Hz, m/s, kg/m3
constexpr double wave_length = speed / frequency;              // m
constexpr int stones_in_wave = 40, below = 26, above = 26;
constexpr double measured = 1.85 / frequency;           // s, of the motion
constexpr double depth = wave_length / stones_in_wave;  // m, of a stone
constexpr double friction = 0.05;                       // of the joint: small, so that strains are
constexpr double strength = friction * density * scenes::papers_gravity * above * depth;  // Pa
constexpr int watched_below = below - 2, watched_above = below + 3;  // three stones from the joint

/// One cycle of v = peak sin(w t) of the base.
GroundMotion one_cycle(double peak)
{
    const double omega = 2 * std::numbers::pi * frequency, interval = 5e-4 / frequency;
    std::vector<double> samples;
    for (int i = 0; i <= 8000; ++i)
        samples.push_back(peak / omega * (1 - std::cos(omega * std::min(i * interval, 1 / frequency))));
    return GroundMotion::from_displacement(samples, interval, "one cycle of velocity");
}

/// The column: bonded but for one joint, under its weight. @param peak of the base's velocity [m/s]
scenes::StagedScene slipping_scene(const scenes::SceneSetting& setting, double peak)
{
    // Poisson's ratio 0: the weight does not spread the stones.
    const Column column{{{(below + above) * depth, speed, below + above}}, density, 0, 5000};
    scenes::StagedScene scene = column_scene(setting, column, one_cycle(peak), measured);
    Model& model = scene.model;
    model.groups = {"below", "above"};
    for (std::size_t b = below + 1; b < model.blocks.size(); ++b) model.blocks[b].group = 1;
    JointMaterial joint;
    joint.name = "joint";
    joint.friction_angle = std::atan(friction);
    joint.shear_to_normal_stiffness = model.joints[0].shear_to_normal_stiffness;
    joint.stiffness = model.joints[0].stiffness;
    model.joints.push_back(joint);
    model.joint_of_groups = {0, 1, 1, 0};
    scene.stages[0].gravity = {0, 0, -scenes::papers_gravity};
    scene.stages.insert(scene.stages.begin(), scenes::static_stage(setting));
    return scene;
}

/// The two waves of a stone: upwards (v - s / rho c) / 2 and downwards (v + s / rho c) / 2, with its velocity v
/// and its shear stress s.
struct Gate {
    int stone;
    double up = 0, down = 0;  // m2/s, their squares over time

    void add(const scenes::StagedScene& scene, const State& now, double time_step)
    {
        const double v = velocity_of(scene.model.kinematics, now, stone).x();
        const double s = stress_of(scene.model, now, stone)(0, 2) / (density * speed);
        up += 0.25 * (v - s) * (v - s) * time_step;
        down += 0.25 * (v + s) * (v + s) * time_step;
    }
};

/// Roots of the shares of the energy that pass and return.
references::SlipCoefficients pass_joint(const scenes::SceneSetting& setting, double strength_ratio,
                                        VerifyResult& result)
{
    const double peak = strength / strength_ratio / (density * speed);  // m/s
    const scenes::StagedScene scene = slipping_scene(setting, peak);
    Gate under{watched_below}, over{watched_above};
    std::vector<double> times, before, after;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport& step, const RunReport&) {
        if (now.stage == 0) return;
        under.add(scene, now, step.time_step);
        over.add(scene, now, step.time_step);
        times.push_back(now.stage_time);
        before.push_back(velocity_of(scene.model.kinematics, now, watched_below).x());
        after.push_back(velocity_of(scene.model.kinematics, now, watched_above).x());
    };
    State state = initial_state(scene.model);
    run_scene(scene, state, observer, result);
    result.picture =
        linear_diagram("time [s]", "velocity [m/s]",
                       {curve_of("above the joint", times, after), curve_of("below the joint", times, before)});
    return {std::sqrt(over.up / under.up), std::sqrt(under.down / under.up), 0};
}

VerifyResult run_slip(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "transmitted, reflected (closed form in brackets):";
    for (const double amplitude : {1.5, 2.0, 3.0, 5.0, 10.0}) {
        const references::SlipCoefficients exact = references::slip_coefficients(1 / amplitude);
        const references::SlipCoefficients ours = pass_joint(setting, 1 / amplitude, result);
        result.answer.insert(result.answer.end(), {ours.transmitted, ours.reflected});
        result.error = std::max({result.error, std::abs(ours.transmitted / exact.transmitted - 1),
                                 std::abs(ours.reflected / exact.reflected - 1)});
        result.note +=
            fmt::format(" {:.4f} ({:.4f}), {:.4f} ({:.4f}) at {:g} times the strength;", ours.transmitted,
                        exact.transmitted, ours.reflected, exact.reflected, amplitude);
    }
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> slip_rows()
{
    Benchmark row;
    row.name = "shear-wave-slip";
    row.title = "A shear wave through a joint that slips, five amplitudes, at defaults";
    row.source = "[Miller1978]; not from a paper on this method";
    row.quantity = "largest |coefficient / that of the closed form - 1|, of transmission and reflection";
    row.choices =
        "One cycle of 10 Hz, 40 stones to a wave, in a column so long that nothing returns from its ends. The "
        "joint has "
        "friction under the weight above it. "
        "Coefficients are roots of the energies of the waves that climb and descend three stones from it.";
    row.setting.kinematics = Kinematics::spatial_deformable;
    row.setting.time_step = 2e-3;
    row.tolerance = 0.03;
    row.sweep = sweep_of(row.setting, {4e-3, 2e-3, 1e-3, 5e-4});
    row.run = run_slip;
    return {row};
}

}  // namespace voussoir::app::studies::verify
