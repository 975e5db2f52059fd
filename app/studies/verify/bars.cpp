// Rods and dowels against closed forms: a stone that swings from a rod, one that a rod stops and yields, and a
// shaft whose dowels shear.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/scenes/metal.h"
#include "app/studies/verify/engine_run.h"
#include "app/studies/verify/families.h"
#include "app/studies/verify/limit_masonry.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/vibration.h"
#include "libdda/analysis/bar_forces.h"

namespace voussoir::app::studies::verify
{
namespace
{

using Eigen::Vector3d;
using std::numbers::pi;

constexpr double gravity = scenes::papers_gravity, density = 2000;  // m/s2, kg/m3; cubes of 1 m, of 2 t
constexpr double length = 3;                                        // m

Model cubes(const scenes::SceneSetting& setting, const Vector3d& second)
{
    Model model = scenes::make_scene_model(setting, scenes::stone(density), scenes::dry_joint(0.6), 1);
    const Vector3d half(0.5, 0.5, 0.5);
    scenes::add_box(model, "held", -half, half);
    scenes::add_box(model, "stone", second - half, second + half);
    scenes::hold(model, 0);
    return model;
}

/// One swing there and back, and where the stone is then.
VerifyResult run_pendulum(const scenes::SceneSetting& setting)
{
    constexpr double angle = 40 * pi / 180, stiffness = 1e9;
    const double stretched = length + density * gravity * std::cos(angle) / stiffness;
    const Vector3d start(stretched * std::sin(angle), 0, -stretched * std::cos(angle));
    scenes::StagedScene scene{cubes(setting, start), {}};
    scene.model.bars = {scenes::rod_between(scene.model, 0, 1, stiffness)};
    scene.model.bars[0].length = length;
    const double period = 4 * std::sqrt(length / gravity) * std::comp_ellint_1(std::sin(angle / 2));
    scene.stages = {scenes::dynamic_stage(setting, period)};
    std::vector<double> times, angles;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const Vector3d place = pose_of(scene.model.kinematics, now, 1).centroid;
        times.push_back(now.stage_time);
        angles.push_back(std::atan2(place.x(), -place.z()) * 180 / pi);
    };
    VerifyResult result;
    State state = initial_state(scene.model);
    const RunReport report = run_scene(scene, state, observer, result);
    const double off = (pose_of(scene.model.kinematics, state, 1).centroid - start).norm() / start.x();
    const double tension = density * gravity * (3 - 2 * std::cos(angle));
    const double most = report.bars.empty() ? 0 : report.bars[0].tension;
    result.error = std::max(off, std::abs(most / tension - 1));
    result.answer = {most / tension};
    result.note =
        fmt::format("after a swing {:.2e} of the way from where it began; largest tension {:.5f} of {:.1f} kN",
                    off, most / tension, tension / 1e3);
    result.picture = linear_diagram("time [s]", "angle [deg]", {curve_of("engine", times, angles)});
    return result;
}

/// A stone that moves away from a held one until a rod has stopped it.
VerifyResult run_yielding(const scenes::SceneSetting& setting)
{
    constexpr double stiffness = 2e7, limit = 2e4, speed = 1;
    scenes::StagedScene scene{cubes(setting, {length, 0, 0}), {}};
    scene.model.bars = {scenes::rod_between(scene.model, 0, 1, stiffness)};
    scene.model.bars[0].tension = limit;
    const double stops = density * speed / limit;  // s, at the yield force
    scene.stages = {scenes::dynamic_stage(setting, 1.2 * stops, Vector3d::Zero())};
    std::vector<double> times{0}, forces{0};
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        times.push_back(now.stage_time);
        forces.push_back(bars_now(scene.model, now)[0].axial / 1e3);
    };
    VerifyResult result;
    const auto push = [&](State& moving) { scenes::set_velocity(scene.model, moving, 1, {speed, 0, 0}); };
    const RunReport report = run_moving(scene, push, observer, result);
    const double energy = 0.5 * density * speed * speed, elastic = 0.5 * limit * limit / stiffness;
    const double longer = (energy - elastic) / limit;
    const double taken = report.energy.yielding / limit;
    result.error = std::abs(taken / longer - 1);
    result.answer = {taken};
    result.note = fmt::format("{:.3f} mm longer, closed form {:.3f} mm", 1e3 * taken, 1e3 * longer);
    result.picture = linear_diagram("time [s]", "tension [kN]", {curve_of("engine", times, forces)});
    return result;
}

/// Five drums and their dowels, pushed by a share of their weight: the lowest joint slides first.
VerifyResult run_doweled(const scenes::SceneSetting& setting)
{
    constexpr int drums = 5;
    constexpr double friction = 0.2, height = 0.4, shear = 8e3;
    Model model = scenes::make_scene_model(setting, scenes::stone(density), scenes::dry_joint(friction), 1);
    scenes::hold(model, scenes::add_box(model, "base", {-1.5, -1, -0.5}, {1.5, 1, 0}));
    for (int i = 0; i < drums; ++i) {
        scenes::add_box(model, "drum", {-0.5, -0.5, i * height}, {0.5, 0.5, (i + 1) * height});
        model.bars.push_back(scenes::dowel_in(model, i, i + 1, {0, 0, i * height}, 1e8, shear));
    }
    const double weight = density * height * drums * gravity;
    const double reference = friction + shear / weight;
    constexpr double width = 2e-4;
    const EngineThreshold found = engine_threshold(model, 0.5 * reference, 1.1 * reference, width, setting);
    const double threshold = (found.stands + found.falls) / 2;
    VerifyResult result;
    result.error = std::abs(threshold / reference - 1);
    result.answer = {threshold / reference};
    result.steps = found.steps;
    result.step_cuts = found.step_cuts;
    result.iterations = found.iterations;
    result.cpu_time = found.cpu_time;
    result.note = fmt::format("{:.5f} of the weight, friction and dowel {:.5f}, friction alone {:.1f}", threshold,
                              reference, friction);
    return result;
}

}  // namespace

std::vector<Benchmark> bar_benchmarks()
{
    std::vector<Benchmark> rows;
    Benchmark row;
    row.setting.time_step = 5e-3;
    row.also = {Kinematics::spatial_deformable, Kinematics::planar_rigid};
    row.name = "rod-pendulum";
    row.title = "A stone swings from a rod";
    row.source = "docs/method.md (Bars): closed form of a pendulum; not from a paper";
    row.quantity = "largest of distance after a period / amplitude, and |largest tension / closed form - 1|";
    row.choices =
        "A cube of 1 m and 2 t on a rod of 3 m and 1e9 N/m between the centroids, let go at 40 degrees with the "
        "stretch it has there. Period by the complete elliptic integral, largest tension m g (3 - 2 cos 40).";
    row.tolerance = 0.005;
    row.sweep = sweep_of(row.setting, {2e-2, 1e-2, 5e-3, 2.5e-3, 1.25e-3});
    row.run = run_pendulum;
    rows.push_back(row);

    row.name = "rod-yields";
    row.title = "A rod yields until it has stopped a stone";
    row.source = "docs/method.md (Bars): balance of energy; not from a paper";
    row.quantity = "|plastic elongation / closed form - 1|";
    row.choices =
        "A cube of 2 t leaves a held one at 1 m/s; the rod has 2e7 N/m and yields at 20 kN. It grows by what "
        "kinetic energy there is beyond its elastic limit over that force.";
    row.setting.time_step = 1e-3;
    row.sweep = sweep_of(row.setting, {4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4});
    row.tolerance = 0.005;
    row.run = run_yielding;
    rows.push_back(row);

    row.name = "doweled-shaft";
    row.title = "Lateral capacity of a shaft whose joints are doweled";
    row.source = "docs/method.md (Bars): statics; not from a paper";
    row.quantity = "|threshold / (friction + shear of a dowel / weight) - 1|";
    row.choices =
        "Five drums of 1 x 1 x 0.4 m, friction 0.2, a dowel in each joint that yields at 8 kN; the push is a "
        "share "
        "of the weight, found by bisection to 2e-4.";
    row.setting.time_step = 1e-2;
    row.sweep = sweep_of(row.setting, {4e-2, 2e-2, 1e-2, 5e-3});
    row.tolerance = 0.005;
    row.run = run_doweled;
    rows.push_back(row);
    return rows;
}

}  // namespace voussoir::app::studies::verify
