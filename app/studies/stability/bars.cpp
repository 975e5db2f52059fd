// Rods and dowels over decades of stiffness and strength.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/scenes/metal.h"
#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"
#include "app/words/diagnosis_words.h"
#include "importers/process/thread_time.h"

namespace voussoir::app::studies::stability
{
namespace
{

using Eigen::Vector3d;

constexpr double density = 2000, gravity = scenes::papers_gravity;  // kg/m3, m/s2; cubes of 1 m
constexpr int steps_to_stop = 60;

/// A stone leaves a held one and is stopped by a rod in some sixty steps, elastic or yielding.
CellRun run_rod(double stiffness, double limit, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(density), scenes::dry_joint(0.6));
    scenes::hold(model, scenes::add_box(model, "held", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
    scenes::add_box(model, "stone", {2.5, -0.5, -0.5}, {3.5, 0.5, 0.5});
    model.bars = {scenes::rod_between(model, 0, 1, stiffness)};
    model.bars[0].tension = limit;
    const double stops = steps_to_stop * time_step, speed = limit * stops / density;
    State state = initial_state(model);
    scenes::set_velocity(model, state, 1, {speed, 0, 0});
    const double energy = 0.5 * density * speed * speed, elastic = 0.5 * limit * limit / stiffness;
    CellRun cell;
    RunObserver observer;
    double most = 0, yielding = 0;
    observer.step = [&](const State&, const StepReport&, const RunReport& report) {
        most = report.bars[0].tension;
        yielding = report.energy.yielding;
    };
    const double quarter = 0.5 * std::numbers::pi * std::sqrt(density / stiffness);
    const Stage stage = scenes::motion_stage(1.3 * std::max(stops, quarter), time_step, 0);
    if (!run_counted(model, {stage}, state, observer, cell)) return cell;
    if (energy > elastic) {
        cell.error = std::abs(yielding / (energy - elastic) - 1) * std::max(0.0, 1 - elastic / energy);
        cell.note = fmt::format("{:.4f} of the energy yields, closed form {:.4f}", yielding / energy,
                                1 - elastic / energy);
    } else {
        const double exact = speed * std::sqrt(stiffness * density);
        cell.error = std::abs(most / exact - 1);
        cell.note = fmt::format("largest tension {:.4g} N, closed form {:.4g} N", most, exact);
    }
    cell.error = std::max(cell.error, cell.energy_residual);
    return cell;
}

/// A block on a slope, held by friction and a dowel: it rests 1 % below what they hold, and not 1 % above.
CellRun run_dowel(double stiffness, double share, double time_step)
{
    constexpr double friction = 0.3;
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(density), scenes::dry_joint(friction));
    scenes::hold(model, scenes::add_box(model, "base", {-3, -3, -0.5}, {3, 3, 0}));
    scenes::add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 0.4});
    const double weight = model.mass(1) * gravity;
    model.bars = {scenes::dowel_in(model, 0, 1, Vector3d::Zero(), stiffness, share * weight)};
    CellRun cell;
    for (const double push : {0.99, 1.01}) {
        Stage stage = scenes::rest_stage(gravity);
        stage.control.time_step = time_step;
        stage.gravity.x() = push * (friction + share) * gravity;
        State state = initial_state(model);
        const double start = importers::process::thread_time();
        const RunReport report = voussoir::run(model, {stage}, state, {});
        cell.cpu_time += importers::process::thread_time() - start;
        cell.steps += report.steps;
        cell.step_cuts += report.step_cuts;
        cell.iterations += report.open_close_iterations;
        if (has_no_answer(report.outcome)) cell.diagnosis = words::message_of(report, model, {stage});
        const bool rests = report.outcome == Outcome::completed;
        if (rests != (push < 1)) cell.error = 1;
        cell.note += fmt::format("{}{:.2f}: {}", cell.note.empty() ? "" : ", ", push, rests ? "rests" : "slides");
    }
    return cell;
}

}  // namespace

StabilityScene bar_scene()
{
    StabilityScene scene;
    scene.name = "bars";
    scene.title = "Rods that stop stones, dowels that hold them";
    scene.quantity =
        "of rods |energy that yields / closed form - 1|, by its share of all, or |largest tension / closed form - "
        "1| "
        "of elastic ones, and energy unaccounted for; of dowels 1 where one of two verdicts is wrong";
    scene.text =
        "A cube of 2 t moves away from a held one, as fast as makes a rod that yields stop it in sixty steps. A "
        "block on a base is pushed by 0.99 and 1.01 times what its friction of 0.3 and a dowel hold, a share of "
        "its "
        "weight: it rests, and does not.";
    scene.reference = "closed form";
    scene.tolerance = 0.02;
    for (const double stiffness : {1e5, 1e7, 1e9, 1e11, 1e13})
        for (const double limit : {1e2, 1e4, 1e6})
            for (const double h : {1e-4, 1e-3, 1e-2})
                add_cell(scene, fmt::format("rod/k={:.0e}/N={:.0e}", stiffness, limit),
                         {{"stiffness", stiffness, "N/m"}, {"strength", limit, "N"}}, h,
                         [=] { return run_rod(stiffness, limit, h); });
    for (const double stiffness : {1e5, 1e7, 1e9, 1e11})
        for (const double share : {1e-2, 0.1, 0.5})
            for (const double h : {1e-3, 1e-2, 5e-2})
                add_cell(scene, fmt::format("dowel/k={:.0e}/V={:g}W", stiffness, share),
                         {{"stiffness", stiffness, "N/m"}, {"strength / weight", share, ""}}, h,
                         [=] { return run_dowel(stiffness, share, h); });
    return scene;
}

}  // namespace voussoir::app::studies::stability
