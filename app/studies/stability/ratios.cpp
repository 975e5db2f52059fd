// Extreme ratios: of modulus, density, size and shape.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/scenes/shapes.h"
#include "app/studies/stability/audit.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"
#include "app/studies/stability/one_block.h"
#include "app/studies/stability/run_down.h"
#include "libdda/contact/normal_stiffness.h"

namespace voussoir::app::studies::stability
{
namespace
{

using Eigen::Vector3d;

constexpr double rigid = std::numeric_limits<double>::infinity();  // a modulus, Pa
constexpr const char* at_rest = "equilibrium: force on the ground, no drift";

constexpr double cube = 0.5;  // m
constexpr int cubes = 10;

/// Uniaxial St Venant-Kirchhoff stretch a of each cube under the weight above it and half its own,
/// E a (a^2 - 1) / 2 = -p, and the joints k = 2 f / (L/E + L/E), f of the default rule, twice that on the base.
double settlement(double young, double density)
{
    const double factor = contact::default_stiffness_factor(Kinematics::spatial_deformable, {});
    double sum = 0;
    for (int i = 0; i < cubes; ++i) {
        const double above = (cubes - 1 - i) * density * scenes::papers_gravity * cube,
                     own = density * scenes::papers_gravity * cube;
        const double p = above + own / 2;
        double a = 1;
        for (int n = 0; n < 50; ++n) a -= (a * (a * a - 1) / 2 + p / young) / ((3 * a * a - 1) / 2);
        sum += (1 - a) * cube * (i + 1 == cubes ? 0.5 : 1);
        sum += (above + own) / (factor * young / cube * (i == 0 ? 2 : 1));
    }
    return sum;
}

CellRun run_column(double young)
{
    Model model = make_model(Kinematics::spatial_deformable, {"stone", 2000, young, 0.0}, scenes::dry_joint(0.7));
    scenes::hold(model, scenes::add_box(model, "base", {-1, -1, -1}, {1, 1, 0}));
    for (int i = 0; i < cubes; ++i)
        scenes::add_box(model, fmt::format("cube {}", i + 1), {-cube / 2, -cube / 2, i * cube},
                        {cube / 2, cube / 2, (i + 1) * cube});
    State state = initial_state(model);
    CellRun cell;
    if (!run_counted(model, {scenes::rest_stage()}, state, {}, cell)) return cell;
    const double moved = (cubes - 0.5) * cube - pose_of(model.kinematics, state, cubes).centroid.z();
    const double exact = settlement(young, 2000);
    cell.error = std::abs(moved - exact) / exact;
    return cell;
}

/// A cube of 0.3 m on another.
CellRun run_density(double upper, double lower, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(lower), scenes::dry_joint(0.6));
    model.materials.push_back(scenes::stone(upper));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    scenes::add_box(model, "lower", {-0.15, -0.15, 0}, {0.15, 0.15, 0.3});
    scenes::add_box(model, "upper", {-0.15, -0.15, 0.3}, {0.15, 0.15, 0.6});
    model.blocks.back().material = 1;
    CellRun cell;
    run_at_rest(model, time_step, 1, scenes::papers_gravity, cell);
    return cell;
}

/// A cube of `size` in the middle of one of 1 m.
CellRun run_small_on_large(double size, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    scenes::add_box(model, "large", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
    scenes::add_box(model, "small", {-size / 2, -size / 2, 1}, {size / 2, size / 2, 1 + size});
    CellRun cell;
    run_at_rest(model, time_step, 1, scenes::papers_gravity, cell);
    return cell;
}

/// A cube of 1 m on four cubes of `size` near its corners.
CellRun run_large_on_small(double size, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    const Vector3d half(size / 2, size / 2, 0), up(0, 0, size);
    for (const double x : {-0.4, 0.4})
        for (const double y : {-0.4, 0.4})
            scenes::add_box(model, fmt::format("pad {} {}", x, y), Vector3d(x, y, 0) - half,
                            Vector3d(x, y, 0) + half + up);
    scenes::add_box(model, "large", {-0.5, -0.5, size}, {0.5, 0.5, 1 + size});
    CellRun cell;
    run_at_rest(model, time_step, 1, scenes::papers_gravity, cell);
    return cell;
}

/// A pillar as high as 1 m x slenderness / 10.
CellRun run_slender(double slenderness, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    scenes::add_box(model, "pillar", {-0.05, -0.05, 0}, {0.05, 0.05, 0.1 * slenderness});
    CellRun cell;
    run_at_rest(model, time_step, 1, scenes::papers_gravity, cell);
    return cell;
}

/// A slab of 1 x 1 m slides down 30 degrees with friction coefficient 0.2, in the frame of the incline.
CellRun run_flat(double flatness, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.2));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -2, -1}, {20, 2, 0}));
    scenes::add_box(model, "slab", {-0.5, -0.5, 0}, {0.5, 0.5, 1 / flatness});
    CellRun cell;
    run_down(model, 30, 0.2, scenes::papers_gravity, time_step, cell);
    return cell;
}

}  // namespace

StabilityScene modulus_scene()
{
    StabilityScene scene;
    scene.name = "modulus";
    scene.title = "The sliding block, deformable";
    scene.quantity = "largest distance from the reference over all times / largest sliding";
    scene.text =
        "The block and the ground motion of the scene `sliding` with a contact stiffness of 1e8 N/m per point and "
        "twelve unknowns, from a stone as soft as rubber to one stiffer than steel, and rigid. The block's own "
        "shear adds at most 0.1 mm to the motion.";
    scene.reference = "block on elastic-frictional springs (ODE)";
    scene.tolerance = 0.02;
    for (const double young : {1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, rigid})
        for (const double h : {1e-3, 1e-2})
            add_cell(scene, young < rigid ? fmt::format("E={:.0e}", young) : "rigid", {{"modulus", young, "Pa"}},
                     h, [young, h] {
                         OneBlock block = sliding_block(1e8);
                         if (young < rigid) block.kinematics = Kinematics::spatial_deformable;
                         if (young < rigid) block.young = young;
                         return run_sliding(block, h);
                     });
    return scene;
}

StabilityScene column_scene()
{
    StabilityScene scene;
    scene.name = "column";
    scene.title = "Ten deformable cubes settle under their weight";
    scene.quantity = "|settlement of the topmost centroid - reference| / reference";
    scene.text =
        "Cubes of 0.5 m, 2000 kg/m3, Poisson's ratio 0, default contact stiffness; static. The reference sums the "
        "stretch of each cube by the St Venant-Kirchhoff law and the shortening of each joint.";
    scene.reference = "closed form";
    scene.tolerance = 0.01;
    for (const double young : {1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12})
        add_cell(scene, fmt::format("E={:.0e}", young), {{"modulus", young, "Pa"}}, 0,
                 [young] { return run_column(young); });
    return scene;
}

StabilityScene density_scene()
{
    StabilityScene scene;
    scene.name = "density";
    scene.title = "A heavy cube on a light one, a light one on a heavy one";
    scene.quantity =
        "larger of the error of the force on the ground and the drift in 1 s as a fraction of a block";
    scene.text = "Two cubes of 0.3 m; the heavier one has ratio x 200 kg/m3. Default contact stiffness, 1e10 Pa.";
    scene.reference = at_rest;
    scene.tolerance = 1e-3;
    for (const double ratio : {1e1, 1e2, 1e3, 1e4}) {
        add_cell(scene, fmt::format("above={:.0e}", ratio), {{"density above / below", ratio, ""}}, 1e-3,
                 [ratio] { return run_density(200 * ratio, 200, 1e-3); });
        add_cell(scene, fmt::format("below={:.0e}", ratio), {{"density above / below", 1 / ratio, ""}}, 1e-3,
                 [ratio] { return run_density(200, 200 * ratio, 1e-3); });
    }
    return scene;
}

StabilityScene size_scene()
{
    StabilityScene scene;
    scene.name = "size";
    scene.title = "A small cube on a large one, a large one on four small ones";
    scene.quantity =
        "larger of the error of the force on the ground and the drift in 1 s as a fraction of a small cube";
    scene.text = "The large cube measures 1 m. Default contact stiffness, 1e10 Pa.";
    scene.reference = at_rest;
    scene.tolerance = 1e-3;
    for (const double ratio : {1e1, 1e2, 1e3}) {
        add_cell(scene, fmt::format("small-above={:.0e}", ratio), {{"size above / below", 1 / ratio, ""}}, 1e-3,
                 [ratio] { return run_small_on_large(1 / ratio, 1e-3); });
        add_cell(scene, fmt::format("small-below={:.0e}", ratio), {{"size above / below", ratio, ""}}, 1e-3,
                 [ratio] { return run_large_on_small(1 / ratio, 1e-3); });
    }
    return scene;
}

StabilityScene shape_scene()
{
    StabilityScene scene;
    scene.name = "shape";
    scene.title = "Slender pillars stand, flat slabs slide";
    scene.quantity =
        "pillars: larger of the error of the force on the ground and the drift in 1 s as a fraction of the "
        "block's size; slabs: distance from the closed form / distance slid";
    scene.text =
        "Pillars of 0.1 x 0.1 m, the highest 10 m; slabs of 1 x 1 m, the thinnest 1 mm, down an incline of 30 "
        "degrees with friction coefficient 0.2 for 1 s. Default contact stiffness, 1e10 Pa.";
    scene.reference = at_rest;
    scene.tolerance = 1e-3;
    for (const double ratio : {10., 100.})
        add_cell(scene, fmt::format("pillar={:g}", ratio), {{"pillar, height / width", ratio, ""}}, 1e-3,
                 [ratio] { return run_slender(ratio, 1e-3); });
    for (const double ratio : {10., 100., 1000.})
        for (const double h : {1e-3, 1e-2})
            add_cell(scene, fmt::format("slab={:g}", ratio), {{"slab, length / thickness", ratio, ""}}, h,
                     [ratio, h] { return run_flat(ratio, h); })
                .reference = "closed form of sliding";
    return scene;
}

}  // namespace voussoir::app::studies::stability
