// A thousand blocks that stand, hundreds that fall.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

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

/// `columns` columns of flat stones of 1 x 1 x 0.3 m, side by side with a gap, 1,000 in all.
CellRun run_columns(Kinematics kinematics, int columns, double time_step)
{
    constexpr int stones = 1000;
    Model model = make_model(kinematics, scenes::stone(), scenes::dry_joint(0.6));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -2, -1}, {2.0 + 1.5 * columns, 3, 0}));
    const int courses = stones / columns;
    for (int c = 0; c < columns; ++c)
        for (int i = 0; i < courses; ++i)
            scenes::add_box(model, fmt::format("column {} stone {}", c + 1, i + 1), {1.5 * c, 0, 0.3 * i},
                            {1.5 * c + 1, 1, 0.3 * (i + 1)});
    CellRun cell;
    run_at_rest(model, time_step, 20 * time_step, scenes::papers_gravity, cell);
    return cell;
}

/// Running bond of 40 courses of 25 blocks, on ground it stands on.
CellRun run_large_wall(double time_step)
{
    constexpr double length = 0.6, height = 0.3, thickness = 0.4;  // m
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -1, -1}, {18, 2, 0}));
    for (int course = 0; course < 40; ++course) {
        double left = 0;
        for (int i = 0; i < 25; ++i) {
            const bool half = i == (course % 2 == 0 ? 24 : 0);
            const double right = left + (half ? 0.5 : 1) * length;
            scenes::add_box(model, fmt::format("course {} block {}", course + 1, i + 1),
                            {left, 0, course * height}, {right, thickness, (course + 1) * height});
            left = right;
        }
    }
    CellRun cell;
    run_at_rest(model, time_step, 20 * time_step, scenes::papers_gravity, cell);
    return cell;
}

/// Pseudo-random numbers in [-1, 1], the same everywhere: the distributions of the standard library differ.
class Numbers
{
 public:
    double next() { return 2 * static_cast<double>(engine_() >> 11U) / 9007199254740992.0 - 1; }

 private:
    std::mt19937_64 engine_{20090406};
};

/// Cubes, turned octahedra and bars of 0.3 to 0.5 m, layer above layer, that fall into a heap in a pit.
CellRun run_heap(int bodies, double time_step, double duration)
{
    constexpr double pit = 3, spacing = 1;  // m, half its width; between the bodies at the start
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6));
    scenes::hold(model, scenes::add_box(model, "ground", {-12, -12, -1}, {12, 12, 0}));
    Numbers numbers;
    const int across = static_cast<int>(2 * pit / spacing);
    for (int i = 0; i < bodies; ++i) {
        const int layer = i / (across * across), row = i / across % across, column = i % across;
        const Vector3d centre(-pit + spacing * (column + 0.5) + 0.05 * numbers.next(),
                              -pit + spacing * (row + 0.5) + 0.05 * numbers.next(), 0.5 + spacing * layer);
        const Vector3d half =
            Vector3d::Constant(0.2) + 0.05 * Vector3d(numbers.next(), numbers.next(), numbers.next());
        const Vector3d axis(numbers.next(), numbers.next(), numbers.next());
        const Eigen::AngleAxisd turn(std::numbers::pi * numbers.next(),
                                     (axis + 0.1 * Vector3d::UnitX()).normalized());
        ConvexPolyhedron body = i % 3 == 0 ? scenes::octahedron({0, 0, 0}, 1.4 * half) : make_box(-half, half);
        std::vector<Vector3d> corners;
        for (const Vector3d& corner : body.vertices) corners.push_back(centre + turn * corner);
        model.blocks.push_back(make_block(fmt::format("body {}", i + 1), 0, 0,
                                          {make_convex_polyhedron(corners, body.faces, "body")}));
    }
    State state = initial_state(model);
    CellRun cell;
    run_audited(model, scenes::motion_stage(duration, time_step), 0, state, cell);
    return cell;
}

}  // namespace

StabilityScene many_scene()
{
    StabilityScene scene;
    scene.name = "thousand";
    scene.title = "A thousand blocks stand";
    scene.quantity =
        "larger of the error of the force on the ground and the drift in 20 steps as a fraction of a block";
    scene.text =
        "1,000 stones of 1 x 1 x 0.3 m in 1, 10 and 50 columns, the highest 300 m; a wall in running bond of 40 "
        "courses of 25 blocks. Default contact stiffness, 1e10 Pa.";
    scene.reference = "equilibrium: force on the ground, no drift";
    scene.tolerance = 1e-3;
    for (const int columns : {1, 10, 50})
        for (const Kinematics kinematics : {Kinematics::spatial_rigid, Kinematics::spatial_deformable})
            add_cell(scene,
                     fmt::format("columns={}-{}", columns, is_deformable(kinematics) ? "deformable" : "rigid"),
                     {{is_deformable(kinematics) ? "deformable, columns" : "rigid, columns",
                       static_cast<double>(columns), ""}},
                     1e-3, [=] { return run_columns(kinematics, columns, 1e-3); })
                .budget = 300;
    add_cell(scene, "wall", {{"wall, courses", 40, ""}}, 1e-3, [] { return run_large_wall(1e-3); }).budget = 300;
    return scene;
}

StabilityScene heap_scene()
{
    StabilityScene scene;
    scene.name = "heap";
    scene.title = "Hundreds of bodies fall in a heap";
    scene.quantity =
        "largest of the fractions of the energy that are unaccounted for, appeared, or came from newly detected "
        "contacts";
    scene.text =
        "Boxes and octahedra of 0.3 to 0.7 m, rotated at random (a fixed seed), fall on one another for 2 s. None "
        "may end inside another or below the ground. Default contact stiffness, 1e10 Pa.";
    scene.reference = "energy audit; nothing passes through";
    scene.tolerance = 0.01;
    for (const int bodies : {100, 300})
        for (const double h : {1e-3, 5e-3})
            add_cell(scene, fmt::format("bodies={}", bodies), {{"bodies", static_cast<double>(bodies), ""}}, h,
                     [=] { return run_heap(bodies, h, 2); })
                .budget = 400;
    return scene;
}

}  // namespace voussoir::app::studies::stability
