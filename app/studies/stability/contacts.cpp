// Contacts that are no faces: needles, corners, edges.
#include <fmt/format.h>

#include <cmath>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/scenes/shapes.h"
#include "app/studies/stability/audit.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"

namespace voussoir::app::studies::stability
{
namespace
{

using Eigen::Vector3d;

constexpr double stiffness = 1e8;  // N/m, per contact point: an area of next to nothing has none by the rule

/// A slab of 1 x 1 x 0.3 m with three needles under it whose tips are squares of side `tip` [m].
CellRun run_needles(double tip, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6, stiffness));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    std::vector<ConvexPolyhedron> parts{make_box({-0.5, -0.5, 0.2}, {0.5, 0.5, 0.5})};
    for (const Eigen::Vector2d& place :
         {Eigen::Vector2d(-0.4, -0.4), Eigen::Vector2d(0.4, -0.4), Eigen::Vector2d(0, 0.4)})
        parts.push_back(scenes::needle(place, tip, 0, 0.1, 0.2));
    model.blocks.push_back(make_block("stone", 0, 0, std::move(parts)));
    CellRun cell;
    run_at_rest(model, time_step, 1, scenes::papers_gravity, cell);
    return cell;
}

/// What falls, and what it falls on.
enum class Touch { vertex_on_vertex, edge_on_edge, edge_on_parallel_edge };

/// A stone dropped from 0.2 m on a held one, `beside` [m] its middle; then it rolls off onto the ground.
CellRun run_drop(Touch touch, double beside, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6));
    scenes::hold(model, scenes::add_box(model, "ground", {-8, -8, -1}, {8, 8, 0}));
    const Vector3d above(beside, beside / 2, 1.3);
    if (touch == Touch::vertex_on_vertex) {
        model.blocks.push_back(make_block("below", 0, 0, {scenes::octahedron({0, 0, 0.3}, {0.3, 0.3, 0.3})}));
        model.blocks.push_back(make_block("above", 0, 0, {scenes::octahedron(above, {0.5, 0.5, 0.5})}));
    } else {
        const int axis = touch == Touch::edge_on_edge ? 1 : 0;
        model.blocks.push_back(make_block("below", 0, 0, {scenes::bar_on_edge({0, 0, 0.3}, 0, 2, 0.6)}));
        model.blocks.push_back(make_block("above", 0, 0, {scenes::bar_on_edge(above, axis, 2, 1)}));
    }
    scenes::hold(model, 1);
    State state = initial_state(model);
    CellRun cell;
    run_audited(model, scenes::motion_stage(1.5, time_step), 0, state, cell);
    return cell;
}

}  // namespace

StabilityScene needle_scene()
{
    StabilityScene scene;
    scene.name = "needle";
    scene.title = "A stone stands on three needles";
    scene.quantity =
        "larger of the error of the force on the ground and the drift in 1 s as a fraction of the stone's size";
    scene.text =
        "A slab of 1 x 1 x 0.3 m on three pyramids that end in squares, down to 10 micrometres wide; 1e8 N/m per "
        "contact point.";
    scene.reference = "equilibrium: force on the ground, no drift";
    scene.tolerance = 1e-3;
    for (const double tip : {1e-2, 1e-3, 1e-4, 1e-5})
        add_cell(scene, fmt::format("tip={:.0e}", tip), {{"tip", tip, "m"}}, 1e-3,
                 [tip] { return run_needles(tip, 1e-3); });
    return scene;
}

StabilityScene point_scene()
{
    StabilityScene scene;
    scene.name = "point";
    scene.title = "Vertex on vertex, edge on edge";
    scene.quantity =
        "largest of the fractions of the energy that are unaccounted for, appeared, or came from newly detected "
        "contacts";
    scene.text =
        "A stone is dropped from 0.2 m with its lowest corner, or edge, on the highest one of a fixed stone, "
        "exactly or slightly to the side, and then rolls off onto the ground; 1.5 s. No stone may end inside "
        "another or below the ground.";
    scene.reference = "energy audit; nothing passes through";
    scene.tolerance = 0.01;
    const auto cells = [&](const char* label, const char* words, Touch touch) {
        for (const double beside : {0., 1e-3})
            for (const double h : {1e-4, 1e-3, 1e-2})
                add_cell(scene, fmt::format("{}-{:g}", label, beside), {{words, beside, "m"}}, h,
                         [=] { return run_drop(touch, beside, h); });
    };
    cells("vertices", "vertices, beside", Touch::vertex_on_vertex);
    cells("edges", "crossed edges, beside", Touch::edge_on_edge);
    cells("parallel", "parallel edges, beside", Touch::edge_on_parallel_edge);
    return scene;
}

}  // namespace voussoir::app::studies::stability
