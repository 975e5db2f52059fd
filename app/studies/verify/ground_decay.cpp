// How fast a damped column, and a stone on damped joints, come to rest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/verify/ground.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/vibration.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/vibration.h"

namespace voussoir::app::studies::verify
{

using Eigen::Vector3d;
using std::numbers::pi;

/// Rayleigh's damping with the same ratio at two frequencies [Hz].
RayleighDamping rayleigh(double ratio, double low, double high)
{
    const double first = 2 * pi * low, second = 2 * pi * high;
    return {2 * ratio * first * second / (first + second), 2 * ratio / (first + second)};
}

namespace
{

constexpr double column_height = 20, peak = 0.01;  // m, m/s
constexpr int decay_blocks = 8, window = 6;

/// What damps the blocks of a column.
struct BlockDamping {
    RayleighDamping rayleigh = {};
    std::vector<MaxwellBranch> branches = {};
    double joints = 1;   // times the default stiffness: what joints store is not damped
    double cycles = 24;  // of the run: what is left must be far above what iterations leave
};

/// What a decaying vibration loses of the logarithm of its amplitude per radian: two windows of as many cycles, as
/// far apart as the others.
double loss_per_radian(const std::vector<double>& times, const std::vector<double>& values, double cycles)
{
    const double own = frequency_of(times, values);
    const auto part = [&](double from) {
        std::vector<double> t, x;
        for (std::size_t i = 0; i < times.size(); ++i)
            if (times[i] >= from / own && times[i] < (from + window) / own) {
                t.push_back(times[i]);
                x.push_back(values[i]);
            }
        return amplitude_of(t, x, own);
    };
    const double apart = cycles - window - 2;
    return std::log(part(1) / part(1 + apart)) / (2 * pi * apart);
}

/// What the lowest shear mode of a column on a held base loses of the logarithm of its amplitude per radian.
/// @param frequency of the mode [Hz], with what branches add to the stiffness
double decay_of(const scenes::SceneSetting& setting, double frequency, const BlockDamping& damping,
                VerifyResult& result)
{
    const double stiffer = std::abs(modulus_over_rest(damping.branches, 2 * pi * frequency));
    const double speed = 4 * column_height * frequency / std::sqrt(stiffer), depth = column_height / decay_blocks;
    GroundColumn column{
        {{depth, speed, 1}, {column_height, speed, decay_blocks, damping.rayleigh, damping.branches}}};
    column.joints = damping.joints;
    Model model = ground_model(setting, column);
    model.boundaries.clear();
    model.tied_sides.erase(model.tied_sides.begin());
    scenes::hold(model, 0);
    scenes::StagedScene scene{model,
                              {scenes::dynamic_stage(setting, damping.cycles / frequency, Vector3d::Zero())}};
    std::vector<double> times{0}, tops{0};
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        times.push_back(now.stage_time);
        tops.push_back(pose_of(model.kinematics, now, decay_blocks).centroid.x());
    };
    const auto push = [&](State& state) {
        const int dimension = dimension_of(model.kinematics);
        const auto node = [&](int j) { return peak * std::sin(j * pi / (2 * decay_blocks)); };
        for (int i = 1; i <= decay_blocks; ++i) {
            double* velocity = state.velocities.data() + i * unknowns_per_block(model.kinematics);
            velocity[0] = 0.5 * (node(i - 1) + node(i));
            velocity[dimension * dimension] = (node(i) - node(i - 1)) / depth;  // dx/dZ
        }
    };
    run_moving(scene, push, observer, result);
    if (result.picture.curves.empty())
        result.picture = linear_diagram("time [s]", "top [m]", {curve_of("engine", times, tops)});
    return loss_per_radian(times, tops, damping.cycles);
}

VerifyResult run_rayleigh_decay(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "damping ratio / that asked for:";
    for (const double ratio : {0.02, 0.05})
        for (const double frequency : {1.0, 2.5, 5.0}) {
            const RayleighDamping damping = rayleigh(ratio, 1, 5);
            const double omega = 2 * pi * frequency;
            const double asked = 0.5 * damping.of_mass / omega + 0.5 * damping.of_stiffness * omega;
            const double measured = decay_of(setting, frequency, {damping, {}, 1, 24}, result) / asked;
            result.error = std::max(result.error, std::abs(measured - 1));
            result.answer.push_back(measured);
            result.note += fmt::format(" {:.4f} ({:g} Hz, {:.2f} %),", measured, frequency, 100 * asked);
        }
    result.note.pop_back();
    return result;
}

/// What a stone that hangs and stands on a bonded joint loses per radian when it moves up and down.
/// @param frequency of the stone on its joint without dashpots [Hz]; @param ratio of the dashpots there
double joint_decay_of(const scenes::SceneSetting& setting, double frequency, double ratio, VerifyResult& result)
{
    constexpr double density = 2000, cycles = 24;
    const double omega = 2 * pi * frequency;
    JointMaterial joint;
    joint.stiffness = {ContactStiffness::Kind::per_area, density * 1 * omega * omega};  // of a metre of stone
    joint.cohesion = joint.tensile_strength = 1e9;
    joint.relaxation_time = 2 * ratio / omega;
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, {"stone", density, 1e10, 0.2}, joint, 1);
    scenes::hold(scene.model, scenes::add_box(scene.model, "base", {-0.5, -0.5, -1}, {0.5, 0.5, 0}));
    const int stone = scenes::add_box(scene.model, "stone", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
    scene.stages = {scenes::dynamic_stage(setting, cycles / frequency, Vector3d::Zero())};
    std::vector<double> times{0}, heights{0};
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        times.push_back(now.stage_time);
        heights.push_back(pose_of(scene.model.kinematics, now, stone).centroid.z() - 0.5);
    };
    const auto push = [&](State& state) { scenes::set_velocity(scene.model, state, stone, {0, 0, peak}); };
    run_moving(scene, push, observer, result);
    if (result.picture.curves.empty())
        result.picture = linear_diagram("time [s]", "height [m]", {curve_of("engine", times, heights)});
    return loss_per_radian(times, heights, cycles);
}

VerifyResult run_joint_decay(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "loss per radian / closed form:";
    for (const double ratio : {0.02, 0.05, 0.1})
        for (const double frequency : {1.0, 2.5, 5.0}) {
            const double exact = ratio / std::sqrt(1 - ratio * ratio);
            const double measured = joint_decay_of(setting, frequency, ratio, result) / exact;
            result.error = std::max(result.error, std::abs(measured - 1));
            result.answer.push_back(measured);
            result.note += fmt::format(" {:.4f} ({:g} Hz, {:g} %),", measured, frequency, 100 * ratio);
        }
    result.note.pop_back();
    return result;
}

/// Loss of the logarithm of the amplitude per radian of a free vibration whose damping ratio is the same at all
/// frequencies: its modulus grows as (i omega)^(2 g). Source: docs/method.md (Damping of blocks).
double loss_at_any_frequency(double ratio)
{
    const double g = std::atan(2 * ratio) / pi;
    return std::tan(0.5 * pi * g / (1 - g));
}

VerifyResult run_hysteretic_decay(const scenes::SceneSetting& setting)
{
    constexpr double lowest = 0.5, highest = 20;  // Hz
    VerifyResult result;
    result.note = "loss per radian / closed form:";
    const auto add = [&](double ratio, double frequency, double steps) {
        scenes::SceneSetting own = setting;
        own.time_step *= steps;
        const BlockDamping damping{
            {}, hysteretic_branches(ratio, lowest, highest), 10, std::min(24.0, 1.2 / ratio)};
        const double measured = decay_of(own, frequency, damping, result) / loss_at_any_frequency(ratio);
        result.error = std::max(result.error, std::abs(measured - 1));
        result.answer.push_back(measured);
        result.note += fmt::format(" {:.4f} ({:g} Hz, {:g} %, {:g} ms),", measured, frequency, 100 * ratio,
                                   1e3 * own.time_step);
    };
    for (const double ratio : {0.02, 0.05, 0.1})
        for (const double frequency : {1.0, 3.0, 10.0}) add(ratio, frequency, 1);
    for (const double steps : {0.5, 2.0}) add(0.05, 3, steps);
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> ground_decay_rows()
{
    Benchmark row;
    row.setting.kinematics = Kinematics::spatial_deformable;
    row.setting.time_step = 1e-3;
    std::vector<Benchmark> rows;

    row.name = "rayleigh-decay";
    row.title = "Free vibration with Rayleigh's damping of 2 and 5 %";
    row.source = "docs/method.md (Damping of blocks): closed form of an oscillator; not from a paper";
    row.quantity = "largest |damping ratio / that asked for - 1|";
    row.choices =
        "Lowest shear mode of 20 m in 8 bonded blocks without sides on a held base, 1, 2.5 and 5 Hz, from the "
        "amplitudes of two windows of six cycles, 16 cycles apart.";
    row.tolerance = 0.01;
    row.run = run_rayleigh_decay;
    rows.push_back(row);

    row.name = "hysteretic-decay";
    row.title = "Free vibration with a damping of 2, 5 and 10 % at all frequencies of a band";
    row.source = "docs/method.md (Damping of blocks): closed form of an oscillator; not from a paper";
    row.quantity = "largest |loss of the logarithm of the amplitude per radian / closed form - 1|";
    row.choices =
        "The column of rayleigh-decay, of a material that is damped alike from 0.5 to 20 Hz, at 1, 3 and 10 Hz; "
        "one "
        "of them at half and twice the step as well. Joints of 3000 E/L: the default ones store 0.3 % of the "
        "energy, undamped. The closed form has that damping at all frequencies.";
    row.tolerance = 0.01;
    row.run = run_hysteretic_decay;
    rows.push_back(row);

    row.name = "dashpot-decay";
    row.title = "Free vibration of a stone on a joint with dashpots of 2, 5 and 10 %";
    row.source = "docs/ground.md (Damping): closed form of an oscillator; not from a paper";
    row.quantity = "largest |loss of the logarithm of the amplitude per radian / closed form - 1|";
    row.choices =
        "A rigid cube of 1 m bonded to a held one, 1, 2.5 and 5 Hz by the stiffness of the joint, without weight; "
        "windows as in rayleigh-decay. The closed form is ratio / sqrt(1 - ratio^2).";
    row.setting.kinematics = Kinematics::spatial_rigid;
    row.run = run_joint_decay;
    rows.push_back(row);
    return with_planar(std::move(rows));
}

}  // namespace voussoir::app::studies::verify
