// Joints that rest on points inside their faces: what they resist bending and torsion with.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "app/studies/scenes/shapes.h"
#include "app/studies/verify/families.h"
#include "app/studies/verify/picture.h"
#include "app/studies/verify/references/faces.h"
#include "app/studies/verify/settings.h"
#include "app/studies/verify/vibration.h"

namespace voussoir::app::studies::verify
{

namespace
{

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

JointMaterial joint_on_points(double friction, double stiffness)
{
    JointMaterial joint = scenes::dry_joint(friction);
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
    joint.face = FaceLaw::points;
    return joint;
}

// ---- Stacks that sway ------------------------------------------------------------------------------------------

constexpr double push = 1e-5;  // m/s at the top: no joint opens
constexpr int sway_cycles = 10;

scenes::StagedScene stack_scene(const scenes::SceneSetting& setting, const references::Stack& stack,
                                double duration)
{
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, scenes::stone(stack.density, 1e14),
                                           joint_on_points(0.7, stack.normal), 1);
    const double half = 0.5 * stack.width;
    scenes::hold(scene.model, scenes::add_box(scene.model, "base", {-2 * half, -1, -1}, {2 * half, 1, 0}));
    for (int i = 0; i < stack.stones; ++i)
        scenes::add_box(scene.model, fmt::format("stone {}", i + 1), {-half, -0.5, i * stack.height},
                        {half, 0.5, (i + 1) * stack.height});
    scene.stages = {scenes::static_stage(setting), scenes::dynamic_stage(setting, duration)};
    return scene;
}

/// Sideways like a cantilever, as the square of the height, each stone turning with the slope there.
void bend(const Model& model, const references::Stack& stack, State& state)
{
    const double whole = stack.stones * stack.height;
    for (int i = 1; i <= stack.stones; ++i) {
        const double z = (i - 0.5) * stack.height / whole, slope = 2 * push * z / whole;
        double* velocity = state.velocities.data() + i * unknowns_per_block(model.kinematics);
        velocity[0] = push * z * z;
        if (is_planar(model.kinematics))
            velocity[2] = -slope;  // turns from x to z are positive
        else
            velocity[4] = slope;
    }
}

double sway_of(const scenes::SceneSetting& setting, const references::Stack& stack, double expected,
               VerifyResult& result)
{
    const scenes::StagedScene scene = stack_scene(setting, stack, (sway_cycles + 0.5) / expected);
    std::vector<double> times, tops;
    double rest = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        times.push_back(now.stage_time);
        tops.push_back(pose_of(scene.model.kinematics, now, stack.stones).centroid.x() - rest);
    };
    const auto start = [&](State& state) {
        rest = pose_of(scene.model.kinematics, state, stack.stones).centroid.x();
        bend(scene.model, stack, state);
    };
    run_moving(scene, start, observer, result);
    result.picture = linear_diagram("time [s]", "top [m]", {curve_of("engine", times, tops)});
    return frequency_of(times, tops);
}

VerifyResult run_bending(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "frequency / that of b^3/12 in each joint:";
    // Stiff enough for the height that the weight, which makes it softer, does not count.
    for (const auto& [stones, width, height, stiffness] :
         {std::tuple{4, 1., 1., 1e10}, {10, 1., 1., 1e11}, {20, 1., 1., 1e12}, {8, 0.5, 0.25, 1e10}}) {
        const references::Stack stack{stones, width,     height,
                                      2400,   stiffness, JointMaterial{}.shear_to_normal_stiffness * stiffness};
        const double exact = references::sway_frequency(stack);
        const double ratio = sway_of(setting, stack, exact, result) / exact;
        result.answer.push_back(ratio);
        result.error = std::max(result.error, std::abs(ratio - 1));
        result.note += fmt::format(" {:.4f} ({} x {:g} m, {:.2f} Hz),", ratio, stack.stones, stack.height, exact);
    }
    result.note.pop_back();
    return result;
}

// ---- Weight beside the middle ----------------------------------------------------------------------------------

constexpr double lean_stiffness = 1e9, lean_density = 2000;  // Pa/m, kg/m3, of a block of 1 x 2 m

/// Rotation of the block when its weight leans by `lean`, its resultant at this distance from the middle of its
/// bed [m].
double rotation_of(const scenes::SceneSetting& setting, double lean, VerifyResult& result)
{
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, scenes::stone(lean_density, 1e14),
                                           joint_on_points(2, lean_stiffness), 1);
    scenes::hold(scene.model, scenes::add_box(scene.model, "base", {-2, -1, -1}, {2, 1, 0}));
    scenes::add_box(scene.model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 2});
    scene.stages = {scenes::static_stage(setting, scenes::papers_gravity * Vector3d(lean, 0, -1))};
    State state = initial_state(scene.model);
    run_scene(scene, state, {}, result);
    return lean_of(scene.model, state, 1);
}

/// The same by the closed form: the block that turns takes its weight along, 1 m above its bed.
double expected_rotation(double lean)
{
    const double weight = lean_density * 2 * scenes::papers_gravity;
    double rotation = 0;
    for (int i = 0; i < 100; ++i)
        rotation = references::rotation_under(weight, lean_stiffness, 1, lean + rotation);
    return rotation;
}

VerifyResult run_eccentric(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "rotation / that of an even bed, the resultant within the middle third:";
    for (const double lean : {0.05, 0.1, 0.16}) {
        const double ratio = rotation_of(setting, lean, result) / expected_rotation(lean);
        result.answer.push_back(ratio);
        result.error = std::max(result.error, std::abs(ratio - 1));
        result.note += fmt::format(" {:.4f} ({:g} b),", ratio, lean);
    }
    result.note += " and beyond, not judged:";
    for (const double lean : {0.2, 0.25, 0.3, 0.35, 0.4, 0.45})
        result.note +=
            fmt::format(" {:.2f} ({:g} b),", rotation_of(setting, lean, result) / expected_rotation(lean), lean);
    result.note.pop_back();
    return result;
}

// ---- Plates that spin ------------------------------------------------------------------------------------------

using Outline = std::vector<Vector2d>;

constexpr double plate_friction = 0.5, plate_spin = 4, plate_time = 0.1, plate_height = 0.02;  // -, rad/s, s, m

Outline regular(int corners)
{
    Outline outline;
    for (int i = 0; i < corners; ++i)
        outline.emplace_back(0.5 * std::cos(2 * pi * i / corners), 0.5 * std::sin(2 * pi * i / corners));
    return outline;
}

Outline rectangle(double longer)
{
    const double a = 0.2 * longer, b = 0.2;
    return {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
}

/// A prism that stands on its outline.
ConvexPolyhedron plate(const Outline& outline)
{
    ConvexPolyhedron shape = scenes::prism(outline, 0, plate_height);  // along x
    for (Vector3d& vertex : shape.vertices) vertex = Vector3d(vertex.y(), vertex.z(), vertex.x());
    return shape;
}

/// What a plate loses of its spin, over what even pressure takes.
double lost_spin_of(const scenes::SceneSetting& setting, const Outline& outline, VerifyResult& result)
{
    scenes::StagedScene scene;
    scene.model = scenes::make_scene_model(setting, scenes::stone(), joint_on_points(plate_friction, 1e10), 1);
    scenes::hold(scene.model, scenes::add_box(scene.model, "floor", {-3, -3, -1}, {3, 3, 0}));
    scene.model.blocks.push_back(make_block("plate", 0, 0, {plate(outline)}));
    scene.stages = {scenes::static_stage(setting), scenes::dynamic_stage(setting, plate_time)};
    std::vector<double> times{0}, spins{plate_spin};
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        times.push_back(now.stage_time);
        spins.push_back(angular_velocity_of(scene.model, now, 1).z());
    };
    const auto start = [](State& state) { state.velocities[6 + 5] = plate_spin; };  // about z
    run_moving(scene, start, observer, result);
    result.picture = linear_diagram("time [s]", "spin [rad/s]", {curve_of("engine", times, spins)});
    const double even = plate_friction * scenes::papers_gravity * references::mean_distance(outline) /
                        references::polar_moment(outline) * plate_time;
    return (plate_spin - spins.back()) / even;
}

VerifyResult run_torsion(const scenes::SceneSetting& setting)
{
    VerifyResult result;
    result.note = "couple / that of even pressure:";
    const std::pair<const char*, Outline> plates[] = {{"triangle", regular(3)}, {"square", rectangle(1)},
                                                      {"hexagon", regular(6)},  {"1 : 2", rectangle(2)},
                                                      {"1 : 3", rectangle(3)},  {"1 : 5", rectangle(5)}};
    for (const auto& [name, outline] : plates) {
        const double ratio = lost_spin_of(setting, outline, result);
        result.error = std::max(result.error, std::abs(ratio - 1));
        result.note += fmt::format(" {:.4f} ({}),", ratio, name);
    }
    result.note.pop_back();
    return result;
}

}  // namespace

std::vector<Benchmark> face_benchmarks()
{
    Benchmark bending;
    bending.setting.kinematics = Kinematics::spatial_rigid;
    bending.setting.time_step = 5e-4;
    bending.name = "face-bending";
    bending.title = "Stacks of rigid stones that sway on joints of a given stiffness, face: points";
    bending.source = "docs/faces.md: a chain of rigid bodies on joints of k b^3/12; not from a paper";
    bending.quantity = "largest |frequency / that of the chain - 1|";
    bending.choices =
        "4, 10 and 20 cubes of 1 m on 10, 100 and 1000 GPa/m and eight stones of 0.5 x 0.25 m on 10 GPa/m, under "
        "their weight, which "
        "the reference leaves out, pushed by 0.01 mm/s at the top. With springs at the corners the ratio is 1.72.";
    bending.tolerance = 0.01;
    bending.run = run_bending;

    Benchmark eccentric = bending;
    eccentric.name = "face-eccentric";
    eccentric.title = "A block whose weight bears beside the middle of its bed, face: points";
    eccentric.source = "docs/faces.md: springs all over a strip that do not pull; not from a paper";
    eccentric.quantity = "largest |rotation / closed form - 1| within the middle third";
    eccentric.choices =
        "1 x 2 m on 1 GPa/m, gravity leaned. Beyond the middle third a face on points errs, as the note says; "
        "with springs "
        "at the corners it turns by a third of this within it and by an eighth at 0.35 b.";
    eccentric.tolerance = 0.01;
    eccentric.run = run_eccentric;
    std::vector<Benchmark> rows = with_planar({bending, eccentric});

    Benchmark torsion = bending;
    torsion.setting.time_step = 2.5e-4;
    torsion.name = "face-torsion";
    torsion.title = "Plates that spin flat on a floor, face: points";
    torsion.source = "docs/faces.md: mu N times the mean distance from the centroid; not from a paper";
    torsion.quantity = "largest |spin lost in 0.1 s / what even pressure takes - 1|";
    torsion.choices =
        "Triangle, square, hexagon and rectangles of 1 : 2, 1 : 3 and 1 : 5, 2 cm thick, from 4 rad/s, friction "
        "0.5. With "
        "springs at the corners a square loses 1.85 times as much.";
    torsion.tolerance = 0.02;
    torsion.run = run_torsion;
    rows.push_back(torsion);
    return rows;
}

}  // namespace voussoir::app::studies::verify
