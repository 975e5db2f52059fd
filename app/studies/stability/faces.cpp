// Faces that rest on points inside: a plate that spins flat on a floor, a block beside the middle of its bed, and
// cubes that are shaken down.
#include <fmt/format.h>

#include <cmath>

#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/stability/audit.h"
#include "app/studies/stability/engine.h"
#include "app/studies/stability/families.h"

namespace voussoir::app::studies::stability
{
namespace
{

constexpr double friction = 0.5, spin = 4, duration = 0.1;  // -, rad/s, s

/// @param stiffness [Pa/m]; 0: by the rule
JointMaterial joint_of(FaceLaw face, double stiffness)
{
    JointMaterial joint = scenes::dry_joint(friction);
    if (stiffness > 0) joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
    joint.face = face;
    return joint;
}

/// A plate of 0.4 x 0.2 x 0.02 m that loses spin to friction under even pressure.
CellRun run_plate(FaceLaw face, double stiffness, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), joint_of(face, stiffness));
    scenes::hold(model, scenes::add_box(model, "floor", {-3, -3, -1}, {3, 3, 0}));
    scenes::add_box(model, "plate", {-0.2, -0.1, 0}, {0.2, 0.1, 0.02});
    State state = initial_state(model);
    CellRun cell;
    if (!run_counted(model, {scenes::rest_stage()}, state, {}, cell)) return cell;
    state.stage = 0;
    const Stage motion = scenes::motion_stage(duration, time_step);
    begin_stage(model, 0, state);
    state.velocities[6 + 5] = spin;  // about z
    if (!run_counted(model, {motion}, state, {}, cell)) return cell;
    // Even pressure: mu g times the mean distance from the middle of a rectangle of 2 a x 2 b, over its polar
    // moment.
    constexpr double a = 0.2, b = 0.1;
    const double distance =
        (std::hypot(a, b) + a * a / (2 * b) * std::asinh(b / a) + b * b / (2 * a) * std::asinh(a / b)) / 3;
    const double lost = friction * scenes::papers_gravity * distance / ((a * a + b * b) / 3) * duration;
    cell.error = std::abs((spin - angular_velocity_of(model, state, 1).z()) / lost - 1);
    return cell;
}

/// A block of 1 x 1 x 2 m at rest whose resultant bears at 0.35 m from the middle of its bed: half of it is open.
CellRun run_bed(double stiffness, double time_step)
{
    constexpr double lean = 0.35;  // friction is more
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), joint_of(FaceLaw::linear, stiffness));
    scenes::hold(model, scenes::add_box(model, "floor", {-3, -3, -1}, {3, 3, 0}));
    scenes::add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 2});
    State state = initial_state(model);
    CellRun cell;
    Stage rest = scenes::rest_stage();
    rest.gravity = scenes::papers_gravity * Eigen::Vector3d(lean, 0, -1);
    rest.control.time_step = time_step;
    if (!run_counted(model, {rest}, state, {}, cell)) return cell;
    const double weight = model.mass(1) * scenes::papers_gravity;
    double rotation = 0;
    for (int i = 0; i < 100; ++i) {
        const double to_edge = 0.5 - (lean + rotation) / (1 - lean * rotation);
        rotation = 2 * weight / (9 * stiffness * to_edge * to_edge);
    }
    cell.error = std::abs(-pose_of(model.kinematics, state, 1).map(2, 0) / rotation - 1);
    return cell;
}

/// Ten cubes of 0.5 m, shaken for 1 s.
CellRun run_cubes(FaceLaw face, double stiffness, double shaking, double time_step)
{
    Model model = make_model(Kinematics::spatial_rigid, scenes::stone(), joint_of(face, stiffness));
    scenes::hold(model, scenes::add_box(model, "base", {-20, -20, -1}, {20, 20, 0}));
    for (int i = 0; i < 10; ++i)
        scenes::add_box(model, fmt::format("cube {}", i + 1), {-0.25, -0.25, 0.5 * i},
                        {0.25, 0.25, 0.5 * (i + 1)});
    State state = initial_state(model);
    CellRun cell;
    if (!run_counted(model, {scenes::rest_stage()}, state, {}, cell)) return cell;
    Stage motion = scenes::motion_stage(1, time_step);
    const auto wave = [&](double share, double frequency) {
        return std::make_shared<const GroundMotion>(
            GroundMotion::sine_acceleration(share * shaking * scenes::papers_gravity, frequency, 0, 1));
    };
    motion.motions = {{0, 0, wave(1, 2)}, {0, 1, wave(0.8, 2.6)}, {0, 2, wave(0.4, 3.4)}};
    run_audited(model, motion, -0.5, state, cell);
    return cell;
}

}  // namespace

StabilityScene face_scene()
{
    StabilityScene scene;
    scene.name = "face";
    scene.title = "Faces on points: a plate spins flat, a block leans, cubes are shaken down";
    scene.quantity =
        "plate: |spin lost / what even pressure takes - 1|; bed: |rotation / closed form - 1|; cubes: largest of "
        "the "
        "fractions of the energy that are unaccounted for, appeared, or came from newly detected contacts";
    scene.text =
        "Joints with face: points and face: linear. A plate of 0.4 x 0.2 x 0.02 m spins at 4 rad/s flat on a "
        "floor, "
        "friction 0.5, for 0.1 s, over the stiffness of the joint; a block of 1 x 1 x 2 m comes to rest with its "
        "resultant 0.35 m beside the middle of its bed, which has opened by half; ten cubes of 0.5 m are shaken "
        "for "
        "1 s along all axes (1 : 0.8 : 0.4 at 2, 2.6 and 3.4 Hz). No cube may end inside another or below the "
        "ground.";
    scene.reference = "mu N times the mean distance from the centroid; a bed of springs; energy audit";
    scene.tolerance = 0.02;
    for (const FaceLaw face : {FaceLaw::points, FaceLaw::linear}) {
        const std::string law = face == FaceLaw::points ? "" : "linear ";
        const std::string label = face == FaceLaw::points ? "" : "linear-";
        for (const double k : {1e7, 1e9, 1e11, 1e13})
            for (const double h : {1e-3, 5e-3})
                add_cell(scene, fmt::format("{}plate-k={:.0e}", label, k),
                         {{law + "plate, contact stiffness", k, "Pa/m"}}, h,
                         [=] { return run_plate(face, k, h); });
        const double stiffness = face == FaceLaw::points ? 0 : 1e10;
        for (const double g : {0.5, 1., 3.})
            for (const double h : {1e-3, 5e-3})
                add_cell(scene, fmt::format("{}cubes={:g}", label, g), {{law + "cubes, shaking", g, "g"}}, h,
                         [=] { return run_cubes(face, stiffness, g, h); });
    }
    for (const double k : {1e8, 1e10, 1e12, 1e14})
        for (const double h : {1e-2, 1.})
            add_cell(scene, fmt::format("linear-bed-k={:.0e}", k), {{"linear bed, contact stiffness", k, "Pa/m"}},
                     h, [=] { return run_bed(k, h); });
    return scene;
}

}  // namespace voussoir::app::studies::stability
