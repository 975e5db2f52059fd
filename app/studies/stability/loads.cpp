// Extreme loads and joints: friction, gravity, shaking, impact.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/scenes/shapes.h"
#include "app/studies/stability/audit.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"
#include "app/studies/stability/run_down.h"
#include "libdda/analysis/energies.h"

namespace voussoir::app::studies::stability
{
namespace
{

using Eigen::Vector3d;

Model slab_on_incline(double friction)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(friction));
    scenes::hold(model, scenes::add_box(model, "base", {-2, -2, -1}, {60, 2, 0}));
    scenes::add_box(model, "slab", {-0.5, -0.5, 0}, {0.5, 0.5, 0.1});
    return model;
}

CellRun run_friction(double angle, double friction_angle, double time_step)
{
    const double friction = std::tan(friction_angle * std::numbers::pi / 180);
    CellRun cell;
    run_down(slab_on_incline(friction), angle, friction, scenes::papers_gravity, time_step, cell);
    return cell;
}

/// A brick without gravity, thrown and spinning about all axes.
CellRun run_flight(Kinematics kinematics, double time_step)
{
    Model model = make_model(kinematics, scenes::stone(), scenes::dry_joint(0.6));
    scenes::add_box(model, "brick", {0, 0, 0}, {0.5, 0.25, 0.1});
    State state = initial_state(model);
    const Vector3d velocity(3, -2, 1), spin(2, 5, -3);
    double* rates = state.velocities.data();
    Eigen::Map<Vector3d>{rates} = velocity;
    if (is_deformable(kinematics))
        for (int j = 0; j < 3; ++j) Eigen::Map<Vector3d>{rates + 3 * (1 + j)} = spin.cross(Vector3d::Unit(j));
    else
        Eigen::Map<Vector3d>{rates + 3} = spin;
    const Vector3d momentum = angular_momentum(model, state, 0);
    const double energy = kinetic_energy(model, state);
    CellRun cell;
    if (!run_counted(model, {scenes::motion_stage(10, time_step, 0)}, state, {}, cell)) return cell;
    const Vector3d start = Vector3d(0.25, 0.125, 0.05), end = pose_of(kinematics, state, 0).centroid;
    cell.error =
        std::max({(angular_momentum(model, state, 0) - momentum).norm() / momentum.norm(),
                  (end - start - 10 * velocity).norm() / velocity.norm() / 10,
                  std::abs(kinetic_energy(model, state) + strain_energy(model, state) - energy) / energy});
    return cell;
}

/// Ten cubes of 0.5 m on one another.
Model stack(double friction)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(friction));
    scenes::hold(model, scenes::add_box(model, "base", {-20, -20, -1}, {20, 20, 0}));
    for (int i = 0; i < 10; ++i)
        scenes::add_box(model, fmt::format("cube {}", i + 1), {-0.25, -0.25, 0.5 * i},
                        {0.25, 0.25, 0.5 * (i + 1)});
    return model;
}

CellRun run_stack_at_rest(double g, double time_step)
{
    CellRun cell;
    run_at_rest(stack(0.6), time_step, 1, g, cell);
    return cell;
}

CellRun run_shaken_stack(double shaking, double frequency, double time_step)
{
    const Model model = stack(0.6);
    State state = initial_state(model);
    CellRun cell;
    if (!run_counted(model, {scenes::rest_stage()}, state, {}, cell)) return cell;
    Stage motion = scenes::motion_stage(2, time_step);
    const auto wave = [&](double a, double f) {
        return std::make_shared<const GroundMotion>(GroundMotion::sine_acceleration(a, f, 0, 2));
    };
    motion.motions = {{0, 0, wave(shaking * scenes::papers_gravity, frequency)},
                      {0, 1, wave(0.8 * shaking * scenes::papers_gravity, 1.3 * frequency)},
                      {0, 2, wave(0.4 * shaking * scenes::papers_gravity, 1.7 * frequency)}};
    run_audited(model, motion, -0.5, state, cell);
    return cell;
}

/// A cube of 0.5 m hits the ground at `speed` [m/s], a corner first.
CellRun run_hit(double speed, double stiffness_factor, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6));
    model.joints[0].stiffness.factor = stiffness_factor;
    scenes::hold(model, scenes::add_box(model, "ground", {-200, -200, -1}, {200, 200, 0}));
    model.blocks.push_back(make_block("stone", 0, 0, {scenes::octahedron({0, 0, 0.6}, {0.5, 0.4, 0.5})}));
    State state = initial_state(model);
    scenes::set_velocity(model, state, 1, {0.2 * speed, 0.1 * speed, -speed});
    CellRun cell;
    run_audited(model, scenes::motion_stage(0.5, time_step), 0, state, cell);
    return cell;
}

/// Two cubes meet face to face at `speed` [m/s] each, without gravity and not quite in line. Then they turn about
/// each other; that either has gone its diameter by the end is the same at any speed.
CellRun run_meeting(double speed, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), scenes::dry_joint(0.6));
    scenes::add_box(model, "left", {-1, 0, 0}, {-0.5, 0.5, 0.5});
    scenes::add_box(model, "right", {0.5, 0.1, 0.2}, {1, 0.6, 0.7});
    State state = initial_state(model);
    scenes::set_velocity(model, state, 0, {speed, 0, 0});
    scenes::set_velocity(model, state, 1, {-speed, 0, 0});
    CellRun cell;
    run_audited(model, scenes::motion_stage(1 / speed, time_step, 0), -1e3, state, cell);
    if (!cell.diagnosis.empty()) return cell;
    const Vector3d momentum = velocity_of(model.kinematics, state, 0) + velocity_of(model.kinematics, state, 1);
    const bool passed_through =
        pose_of(model.kinematics, state, 0).centroid.x() > pose_of(model.kinematics, state, 1).centroid.x();
    cell.error = passed_through ? INFINITY : std::max(cell.error, momentum.norm() / speed);
    return cell;
}

}  // namespace

StabilityScene friction_scene()
{
    StabilityScene scene;
    scene.name = "friction";
    scene.title = "Friction of 0, 80 and 89 degrees on an incline";
    scene.quantity =
        "sliding: distance from the closed form / distance slid; otherwise displacement / size of the slab";
    scene.text =
        "A slab of 1 x 1 x 0.1 m without friction on 5 and 30 degrees, for 1 s; with 80 and 89 degrees of "
        "friction on 60 and 75 degrees, where it must not move.";
    scene.reference = "closed form of sliding; rest";
    scene.tolerance = 1e-3;
    for (const double h : {1e-3, 1e-2}) {
        for (const double dip : {5., 30.})
            add_cell(scene, fmt::format("phi=0-dip={:g}", dip), {{"friction", 0, "deg"}, {"dip", dip, "deg"}}, h,
                     [=] { return run_friction(dip, 0, h); });
        for (const double phi : {80., 89.})
            for (const double dip : {60., 75.})
                add_cell(scene, fmt::format("phi={:g}-dip={:g}", phi, dip),
                         {{"friction", phi, "deg"}, {"dip", dip, "deg"}}, h,
                         [=] { return run_friction(dip, phi, h); });
    }
    return scene;
}

StabilityScene gravity_scene()
{
    StabilityScene scene;
    scene.name = "gravity";
    scene.title = "No gravity, and up to ten times gravity";
    scene.quantity =
        "flight: largest error of position, angular momentum and energy; stack: larger of the error of the force "
        "on the ground and the drift in 1 s as a fraction of a block";
    scene.text =
        "Without gravity a brick flies and spins for 10 s, and a stack of ten cubes does not move; the stack "
        "under 1, 3 and 10 g.";
    scene.reference = "conservation; equilibrium";
    scene.tolerance = 1e-3;
    for (const double h : {1e-3, 1e-2}) {
        add_cell(scene, "flight-rigid", {{"flight, rigid", 0, "g"}}, h,
                 [h] { return run_flight(Kinematics::spatial_rigid, h); });
        add_cell(scene, "flight-deformable", {{"flight, deformable", 0, "g"}}, h,
                 [h] { return run_flight(Kinematics::spatial_deformable, h); });
        for (const double g : {0., 1., 3., 10.})
            add_cell(scene, fmt::format("stack={:g}", g), {{"stack", g, "g"}}, h,
                     [=] { return run_stack_at_rest(g * scenes::papers_gravity, h); });
    }
    return scene;
}

StabilityScene shaking_scene()
{
    StabilityScene scene;
    scene.name = "shaking";
    scene.title = "A stack of ten cubes is shaken down";
    scene.quantity =
        "largest of the fractions of the energy that are unaccounted for, appeared, or came from newly detected "
        "contacts";
    scene.text =
        "Ten cubes of 0.5 m, shaken for 2 s along all axes (1 : 0.8 : 0.4 at frequencies 1 : 1.3 : 1.7), up to 3 "
        "g. No cube may end inside another or below the ground.";
    scene.reference = "energy audit; nothing passes through";
    scene.tolerance = 0.01;
    for (const double g : {0.5, 1., 3.})
        for (const double frequency : {2., 10.})
            for (const double h : {1e-3, 5e-3})
                add_cell(scene, fmt::format("a={:g}-f={:g}", g, frequency),
                         {{"acceleration", g, "g"}, {"frequency", frequency, "Hz"}}, h,
                         [=] { return run_shaken_stack(g, frequency, h); });
    return scene;
}

StabilityScene impact_scene()
{
    StabilityScene scene;
    scene.name = "impact";
    scene.title = "Impacts at 5 and 50 m/s";
    scene.quantity =
        "largest of the fractions of the energy that are unaccounted for, appeared, or came from newly detected "
        "contacts; meeting: momentum too";
    scene.text =
        "A stone of 1 x 0.8 x 1 m hits the ground obliquely with a corner; two cubes of 0.5 m collide slightly "
        "off-centre, without gravity. Nothing may pass through.";
    scene.reference = "energy audit, momentum; nothing passes through";
    scene.tolerance = 0.01;
    for (const double speed : {5., 50.})
        for (const double h : {1e-5, 1e-4, 1e-3, 1e-2}) {
            add_cell(scene, fmt::format("hit={:g}", speed), {{"on the ground", speed, "m/s"}}, h,
                     [=] { return run_hit(speed, 1, h); });
            add_cell(scene, fmt::format("meet={:g}", speed), {{"meeting", speed, "m/s"}}, h,
                     [=] { return run_meeting(speed, h); });
        }
    return scene;
}

}  // namespace voussoir::app::studies::stability
