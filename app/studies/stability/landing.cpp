// A rocking block comes down on its other edge, again and again.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/stability/audit.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"

namespace voussoir::app::studies::stability
{
namespace
{

using Eigen::Vector3d;

constexpr double lean = 0.1, height = 3, width = 1, thickness = 0.2;  // rad, m

/// A pier let go while it leans by 0.1 rad on one edge. The restitution of [Housner1963] at each landing, or any
/// other, must not give it more swing than it had.
CellRun run_landing(double stiffness, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(1.5, stiffness));
    scenes::hold(model, scenes::add_box(model, "base", {-20, -2, -2}, {20, 2, 0}));
    const Eigen::AngleAxisd turn(lean, Vector3d::UnitY());
    std::vector<Vector3d> corners;
    const ConvexPolyhedron box = make_box({-width, -thickness / 2, 0}, {0, thickness / 2, height});
    for (const Vector3d& corner : box.vertices) corners.push_back(turn * corner);
    model.blocks.push_back(make_block("pier", 0, 0, {make_convex_polyhedron(corners, box.faces, "pier")}));
    State state = initial_state(model);
    CellRun cell;
    run_audited(model, scenes::motion_stage(6, time_step), 0, state, cell);
    return cell;
}

}  // namespace

StabilityScene landing_scene()
{
    StabilityScene scene;
    scene.name = "landing";
    scene.title = "A pier rocks to rest";
    scene.quantity =
        "largest of the fractions of the energy that are unaccounted for, appeared, or came from newly detected "
        "contacts";
    scene.text =
        "The pier of the scene `rocking` is released at a rotation of 0.1 rad and lands repeatedly, 6 s. The "
        "energy lost in a landing depends on stiffness and time step; the check is that a landing never supplies "
        "energy.";
    scene.reference = "energy audit; nothing passes through";
    scene.tolerance = 0.01;
    for (const double k : {1e5, 1e7, 1e9, 1e11, 1e13})
        for (const double h : {1e-3, 5e-3, 2e-2})
            add_cell(scene, fmt::format("k={:.0e}", k), {{"contact stiffness", k, "N/m"}}, h,
                     [=] { return run_landing(k, h); });
    return scene;
}

}  // namespace voussoir::app::studies::stability
