// The ground around a model: waves through its boundaries, and damped ground that comes to rest.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"
#include "libdda/analysis/integrator_accuracy.h"
#include "libdda/block/block_step.h"

namespace voussoir::app::studies::stability
{
namespace
{

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double density = 2000, poisson = 0.25, peak = 0.01;  // kg/m3, -, m/s
constexpr int rows = 8, columns = 3;

/// How the ground ends sideways.
enum class Sides { tied, periodic, free_field };

/// Of P waves, or of S waves [m/s].
double speed_of(double young, bool pressure)
{
    const double shear = young / (2 * (1 + poisson));
    return std::sqrt((pressure ? shear * 2 * (1 - poisson) / (1 - 2 * poisson) : shear) / density);
}

Model empty_ground(double young)
{
    JointMaterial bond = scenes::dry_joint(0.5);
    bond.cohesion = bond.tensile_strength = 1e15;  // Pa: nothing breaks it
    return make_model(Kinematics::planar_deformable, {"ground", density, young, poisson}, bond);
}

/// The edge of a box that looks along `outwards`.
BlockFace edge_of(const Model& model, int block, const Vector2d& outwards)
{
    const auto& corners = model.blocks[static_cast<std::size_t>(block)].outlines[0].vertices;
    int best = 0;
    double most = -1;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vector2d along = (corners[(i + 1) % corners.size()] - corners[i]).normalized();
        const double towards = Vector2d(along.y(), -along.x()).dot(outwards);
        if (towards > most) best = static_cast<int>(i);
        most = std::max(most, towards);
    }
    return {block, 0, best};
}

/// A column of boxes of 1 m, from z = 0. @returns its lowest
int add_column(Model& model, double left)
{
    const int first = static_cast<int>(model.blocks.size());
    for (int j = 0; j < rows; ++j)
        scenes::add_box(model, "ground", {left, -0.5, 1.0 * j}, {left + 1, 0.5, j + 1.0});
    return first;
}

/// A grid of blocks of 1 m on a viscous base; one column whose sides are tied.
Model ground_with(Sides sides, double young)
{
    Model model = empty_ground(young);
    const int width = sides == Sides::tied ? 1 : columns;
    ViscousBoundary base{"base", {}, RestSupport::full, {}}, flanks{"flanks", {}, RestSupport::normal, {}};
    for (int i = 0; i < width; ++i) base.faces.push_back(edge_of(model, add_column(model, i), {0, -1}));
    const int last = rows * (width - 1);
    for (int j = 0; j < rows; ++j) {
        const BlockFace left = edge_of(model, j, {-1, 0}), right = edge_of(model, last + j, {1, 0});
        if (sides == Sides::tied) model.tied_sides.push_back(j);
        if (sides == Sides::periodic) model.side_ties.push_back({right, left, 300 * young, 300 * young});
        if (sides == Sides::free_field) flanks.faces.insert(flanks.faces.end(), {left, right});
    }
    if (sides == Sides::free_field) {
        const int left = add_column(model, -3), right = add_column(model, width + 2);
        for (const int column : {left, right}) base.faces.push_back(edge_of(model, column, {0, -1}));
        for (int j = 0; j < rows; ++j) flanks.free_field.insert(flanks.free_field.end(), {left + j, right + j});
        for (int j = 0; j < 2 * rows; ++j) model.tied_sides.push_back(left + j);
    }
    model.boundaries.push_back(base);
    if (sides == Sides::free_field) model.boundaries.push_back(flanks);
    return model;
}

/// One half wave of 1 - cos. @param length [s]
std::shared_ptr<const GroundMotion> pulse(double length)
{
    std::vector<double> samples;
    for (int i = 0; i <= 2000; ++i) samples.push_back(0.5 * peak * (1 - std::cos(2 * pi * i / 2000)));
    samples.push_back(0);
    return std::make_shared<const GroundMotion>(GroundMotion::from_velocity(samples, length / 2000, "pulse"));
}

/// A pulse of sixty blocks and sixty steps at least comes up, is doubled by the surface and leaves again.
CellRun run_pulse(Sides sides, double young, double time_step)
{
    const Model model = ground_with(sides, young);
    const bool pressure = sides != Sides::tied;
    const double speed = speed_of(young, pressure), length = 60 * std::max(time_step, 1 / speed);
    Stage stage = scenes::motion_stage(length + 3 * rows / speed, time_step, 0);
    stage.incoming_waves = {{0, pressure ? 2 : 0, pulse(length)}};
    const int width = sides == Sides::tied ? 1 : columns;
    std::vector<double> largest(static_cast<std::size_t>(width), 0);
    double most = 0, last = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport& report) {
        for (int i = 0; i < width; ++i) {
            const Vector3d velocity = velocity_of(model.kinematics, now, rows * (i + 1) - 1);
            double& here = largest[static_cast<std::size_t>(i)];
            here = std::max(here, velocity[pressure ? 2 : 0]);
        }
        last = report.energy.kinetic + report.energy.strain + report.energy.contact;
        most = std::max(most, last);
    };
    State state = initial_state(model);
    CellRun cell;
    if (!run_counted(model, {stage}, state, observer, cell)) return cell;
    double surface = 0;
    for (const double each : largest) surface = std::max(surface, std::abs(each / (2 * peak) - 1));
    cell.error = std::max({surface, last / most, cell.energy_residual});
    cell.note = fmt::format("surface off by {:.2e}, energy left {:.2e}", surface, last / most);
    return cell;
}

/// What damps a column.
enum class Damping { rayleigh, hysteretic };

/// Highest points of the swings of a history, and when they were.
struct Swing {
    double time = 0, size = 0;  // s, m
};
std::vector<Swing> swings_of(const std::vector<Swing>& history)
{
    std::vector<Swing> swings;
    for (std::size_t i = 1; i + 1 < history.size(); ++i) {
        const double before = history[i - 1].size, here = history[i].size, after = history[i + 1].size;
        if (here <= before || here < after || here <= 0) continue;
        // The parabola through three points.
        const double bend = before - 2 * here + after, rise = 0.5 * (after - before);
        swings.push_back({history[i].time, here - rise * rise / (2 * bend)});
    }
    return swings;
}

/// Four blocks whose sides are tied on a held one. Its lowest mode has a quarter of a wave in it, and a frequency
/// [Hz] that eighty steps make a swing.
constexpr double ratio = 0.05, steps_a_swing = 80;
constexpr int layers = 4, swings = 6;
struct DampedColumn {
    Model model;
    double omega = 0, height = 0;  // 1/s, m
};

DampedColumn damped_column(Damping damping, double young, double time_step)
{
    const double frequency = 1 / (steps_a_swing * time_step), omega = 2 * pi * frequency;
    DampedColumn column{empty_ground(young), omega, 0};
    BlockMaterial& material = column.model.materials[0];
    if (damping == Damping::rayleigh)
        material.rayleigh = {ratio * omega, ratio / omega};
    else
        material.branches = hysteretic_branches(ratio, frequency / 10, frequency * 10);
    const double stiffer = std::abs(modulus_over_rest(material.branches, omega));
    column.height = std::sqrt(stiffer) * speed_of(young, false) / (4 * frequency);
    const double depth = column.height / layers;
    scenes::hold(column.model, scenes::add_box(column.model, "base", {0, -0.5, -depth}, {depth, 0.5, 0}));
    for (int j = 0; j < layers; ++j)
        column.model.tied_sides.push_back(
            scenes::add_box(column.model, "ground", {0, -0.5, j * depth}, {depth, 0.5, (j + 1) * depth}));
    return column;
}

/// The lowest mode as velocities.
void push(const DampedColumn& column, State& state)
{
    const auto node = [&](int j) { return 1e-4 * column.omega * column.height * std::sin(j * pi / (2 * layers)); };
    for (int j = 0; j < layers; ++j) {
        double* velocity = state.velocities.data() + (j + 1) * unknowns_per_block(column.model.kinematics);
        velocity[0] = 0.5 * (node(j) + node(j + 1));
        velocity[4] = (node(j + 1) - node(j)) / (column.height / layers);  // dx/dZ
    }
}

/// What the logarithm of the amplitude loses in a swing. Source: docs/method.md (Damping of blocks).
double exact_loss(Damping damping, double omega, const Stage& stage)
{
    const double own = integrator_accuracy(omega * stage.control.time_step, step::end_share(stage)).damping;
    const double g = std::atan(2 * ratio) / pi;
    return 2 * pi *
           (own + (damping == Damping::rayleigh ? ratio / std::sqrt(1 - ratio * ratio)
                                                : std::tan(0.5 * pi * g / (1 - g))));
}

/// A damped column shears freely.
CellRun run_decay(Damping damping, double young, double time_step)
{
    const DampedColumn column = damped_column(damping, young, time_step);
    const Kinematics kinematics = column.model.kinematics;
    const Stage stage = scenes::motion_stage((swings + 1) * steps_a_swing * time_step, time_step, 0);
    State state = initial_state(column.model);
    push(column, state);
    const double start = pose_of(kinematics, state, layers).centroid.x();
    std::vector<Swing> history;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        history.push_back({now.stage_time, pose_of(kinematics, now, layers).centroid.x() - start});
    };
    CellRun cell;
    if (!run_counted(column.model, {stage}, state, observer, cell)) return cell;
    const std::vector<Swing> found = swings_of(history);
    cell.error = std::numeric_limits<double>::infinity();
    if (found.size() < swings) return cell;
    const double loss = std::log(found[1].size / found[swings - 1].size) / (swings - 2);
    const double exact = exact_loss(damping, column.omega, stage);
    cell.error = std::max(std::abs(loss / exact - 1), cell.energy_residual);
    cell.note = fmt::format("loss a swing {:.4f}, closed form {:.4f}", loss, exact);
    return cell;
}

}  // namespace

StabilityScene ground_scene()
{
    StabilityScene scene;
    scene.name = "ground";
    scene.title = "Waves through boundaries, and damped ground that comes to rest";
    scene.quantity =
        "largest of |surface / twice the wave - 1|, energy left / largest energy, and energy unaccounted for; of "
        "damped ground |loss a swing / closed form - 1|";
    scene.text =
        "A pulse comes through a viscous base into bonded planar blocks of 1 m, eight high, sixty steps long and "
        "at "
        "least sixty blocks: an S wave in a column whose sides are tied, P waves in three columns with periodic "
        "sides or a free field. Where ground is stiff the pulse passes all of it in less than a step. Damped by "
        "5 % (Rayleigh, hysteretic), a bonded column as high as makes its lowest mode eighty steps long swings "
        "freely; the closed form has the integrator's own damping too.";
    scene.reference = "closed form";
    scene.tolerance = 0.01;
    const std::array<std::pair<const char*, Sides>, 3> sides{
        {{"viscous", Sides::tied}, {"periodic", Sides::periodic}, {"free-field", Sides::free_field}}};
    const std::array<std::pair<const char*, Damping>, 2> dampings{
        {{"rayleigh", Damping::rayleigh}, {"hysteretic", Damping::hysteretic}}};
    for (const double young : {1e6, 1e8, 1e10, 1e12})
        for (const double h : {1e-3, 5e-3, 2e-2}) {
            for (const auto& [name, kind] : sides)
                add_cell(scene, fmt::format("{}/E={:.0e}", name, young), {{"modulus", young, "Pa"}}, h,
                         [=, side = kind] { return run_pulse(side, young, h); });
            for (const auto& [name, kind] : dampings)
                add_cell(scene, fmt::format("{}/E={:.0e}", name, young), {{"modulus", young, "Pa"}}, h,
                         [=, damping = kind] { return run_decay(damping, young, h); });
        }
    return scene;
}

}  // namespace voussoir::app::studies::stability
