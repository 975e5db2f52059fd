#include "app/golden/scenes.h"

#include <Eigen/Geometry>
#include <memory>
#include <numbers>
#include <utility>

#include "libdda/geometry/plane.h"

namespace voussoir::app::golden
{

namespace
{

using Eigen::Vector3d;

constexpr double degrees = std::numbers::pi / 180;

JointMaterial dry(double friction_degrees, double stiffness)
{
    JointMaterial joint;
    joint.name = "dry";
    joint.friction_angle = friction_degrees * degrees;
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
    return joint;
}

/// Of a planar scene the section in x and z counts. @returns its index
int add_box(Model& model, const Vector3d& lower, const Vector3d& upper)
{
    if (is_planar(model.kinematics))
        model.blocks.push_back(make_planar_block(
            "box", 0, 0, {make_rectangle(from_space<2>(lower), from_space<2>(upper))}, model.thickness));
    else
        model.blocks.push_back(make_block("box", 0, 0, {make_box(lower, upper)}));
    return static_cast<int>(model.blocks.size()) - 1;
}

void hold(Model& model, int block)
{
    Foundation foundation;
    foundation.block = block;
    model.foundations.push_back(foundation);
}

/// Velocity of the centroid [m/s] of a block that does not turn.
void throw_block(const Model& model, int block, const Vector3d& velocity, State& state)
{
    double* rates = state.velocities.data() + block * unknowns_per_block(model.kinematics);
    for (const int axis : axes_of(model.kinematics)) *rates++ = velocity[axis];
}

Stage self_weight()
{
    Stage stage;
    stage.name = "self-weight";
    stage.type = StageType::static_equilibrium;
    stage.gravity_increments = 2;
    stage.control.time_step = 0.1;
    return stage;
}

Stage motion(double duration, double time_step)
{
    Stage stage;
    stage.name = "motion";
    stage.duration = duration;
    stage.control.time_step = time_step;
    return stage;
}

/// Foundation 0 shaken along all axes, with at most `acceleration` [m/s2].
void shake(double acceleration, Stage& stage)
{
    const auto wave = [](double amplitude, double frequency) {
        return std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(amplitude, frequency, 0.3, 10));
    };
    stage.motions = {
        {0, 0, wave(acceleration, 4)}, {0, 1, wave(acceleration / 2, 5)}, {0, 2, wave(acceleration / 2, 7)}};
}

Scene at_rest(Model model, std::vector<Stage> stages)
{
    State state = initial_state(model);
    return {std::move(model), std::move(stages), std::move(state)};
}

/// Boxes that slide, fall and knock against two stacked ones, in steps that are cut.
Scene knocks(Kinematics kinematics)
{
    Model model = make_model(kinematics, {"stone", 2500, 2e9, 0.2}, dry(25, 2e9));
    hold(model, add_box(model, {-4, -4, -1}, {4, 4, 0}));
    add_box(model, {0, 0, 0}, {1, 0.8, 0.5});
    add_box(model, {0.1, 0.05, 0.5}, {0.8, 0.7, 0.9});
    const int sliding = add_box(model, {-0.9, 0.1, 0}, {-0.1, 0.6, 0.4});
    const int falling = add_box(model, {0.2, 0, 1.0}, {0.7, 0.5, 1.3});
    Stage stage = motion(0.2, 1e-3);
    stage.control.max_open_close = 2;
    Scene scene = at_rest(std::move(model), {stage});
    throw_block(scene.model, sliding, {3, 0.5, 0}, scene.state);
    throw_block(scene.model, falling, {0.2, 0.1, -2}, scene.state);
    return scene;
}

/// A slender column of three drums that settles and is then shaken until it rocks.
Scene column(Kinematics kinematics, LinearSolverKind solver)
{
    Model model = make_model(kinematics, {"stone", 2200, 5e9, 0.2}, dry(35, 5e9));
    hold(model, add_box(model, {-1, -1, -0.5}, {1, 1, 0}));
    for (int i = 0; i < 3; ++i) add_box(model, {-0.2, -0.25, 0.6 * i}, {0.2, 0.25, 0.6 * (i + 1)});
    Stage shaking = motion(0.25, 1e-3);
    shake(8, shaking);
    shaking.control.integrator = Integrator::energy_decaying;
    shaking.control.linear_solver = solver;
    return at_rest(std::move(model), {self_weight(), shaking});
}

/// A column on soft joints that open from their edge on and close again.
Scene opening(Kinematics kinematics)
{
    JointMaterial joint = dry(35, 1e9);
    joint.face = FaceLaw::linear;
    Model model = make_model(kinematics, {"stone", 2200, 5e9, 0.2}, joint);
    hold(model, add_box(model, {-1, -1, -0.5}, {1, 1, 0}));
    for (int i = 0; i < 3; ++i) add_box(model, {-0.2, -0.25, 0.6 * i}, {0.2, 0.25, 0.6 * (i + 1)});
    Stage shaking = motion(0.25, 1e-3);
    shake(4, shaking);
    return at_rest(std::move(model), {self_weight(), shaking});
}

/// Two boxes, one on the other, that the ground shakes to and fro: they stick, slide, turn round and rock, by
/// Shi's own iteration and the papers' damping.
Scene published(Kinematics kinematics)
{
    JointMaterial joint = dry(22, 0);
    joint.stiffness = {ContactStiffness::Kind::per_point, 1e8};
    joint.face = FaceLaw::corners;
    Model model = make_model(kinematics, {"stone", 2500, 1e10, 0.2}, joint);
    hold(model, add_box(model, {-5, -5, -1}, {5, 5, 0}));
    add_box(model, {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    add_box(model, {-0.1, -0.1, 0.3}, {0.1, 0.15, 0.8});
    Stage shaking = motion(0.4, 2e-3);
    shake(8, shaking);
    shaking.control.open_close = OpenClose::published;
    shaking.control.max_open_close = 6;
    shaking.damping.factor_per_step = 0.99;
    return at_rest(std::move(model), {self_weight(), shaking});
}

/// A pile with mortar that breaks, stones that are crushed, a load on top, friction that falls with speed,
/// dashpots and uneven friction; a second foundation is free along z and carries its own acceleration.
Scene mortar(Kinematics kinematics)
{
    JointMaterial joint = dry(30, 4e9);
    joint.friction_at_speed = {{0.05, 24 * degrees}, {0.3, 20 * degrees}};
    joint.cohesion = 1e5;
    joint.tensile_strength = 1e5;
    joint.relaxation_time = 1e-4;
    Model model = make_model(kinematics, {"stone", 2000, 2e9, 0.25, 1e5}, joint);
    model.thickness = 0.4;
    model.plane = PlaneCondition::stress;
    hold(model, add_box(model, {-1, 0, -0.4}, {2, 0.4, 0}));
    for (int i = 0; i < 4; ++i) {
        const int block = add_box(model, {0, 0, 0.3 * i}, {0.6, 0.4, 0.3 * (i + 1)});
        model.blocks[block].friction_factor = 1 + 0.02 * i;
    }
    attach_mass(model, 4, 150, {0.35, 0.2, 1.25});
    const int pushed = add_box(model, {0.7, 0, 0}, {1.1, 0.4, 0.4});
    hold(model, pushed);
    model.foundations.back().translation_held = {false, true, false};
    model.foundations.back().rotation_held = false;
    Stage shaking = motion(0.3, 1e-3);
    shake(14, shaking);
    shaking.body_accelerations = {{pushed, 0, shaking.motions[1].motion}};
    shaking.damping.rate = 0.5;
    shaking.control.integrator = Integrator::energy_decaying;
    shaking.control.dissipation = 0;
    return at_rest(std::move(model), {self_weight(), shaking});
}

/// Eight faces, the corners at `radius` [m] along turned axes.
ConvexPolyhedron octahedron(const Vector3d& centre, double radius)
{
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    std::vector<Vector3d> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-radius, radius}) corners.push_back(centre + side * turned.col(axis));
    std::vector<std::vector<int>> faces;
    for (int octant = 0; octant < 8; ++octant) {
        const int x = octant & 1, y = 2 + ((octant >> 1) & 1), z = 4 + ((octant >> 2) & 1);
        const bool mirrored = (x + y + z) % 2 == 0;  // an odd number of negative sides: turned round
        faces.push_back(mirrored ? std::vector<int>{x, z, y} : std::vector<int>{x, y, z});
    }
    return make_convex_polyhedron(corners, faces);
}

/// An octahedron that falls askew on the ridge of a roof and tumbles down: edges against edges.
Scene tumbling(Kinematics kinematics)
{
    Model model = make_model(kinematics, {"stone", 2500, 5e9, 0.2}, dry(20, 2e10));
    const std::vector<Vector3d> prism{{-1, -0.5, 0}, {1, -0.5, 0}, {1, 0.5, 0},
                                      {-1, 0.5, 0},  {-1, 0, 0.4}, {1, 0, 0.4}};
    const std::vector<std::vector<int>> faces{{3, 2, 1, 0}, {0, 1, 5, 4}, {2, 3, 4, 5}, {1, 2, 5}, {3, 0, 4}};
    model.blocks.push_back(make_block("roof", 0, 0, {make_convex_polyhedron(prism, faces)}));
    hold(model, 0);
    hold(model, add_box(model, {-3, -3, -1}, {3, 3, 0}));
    model.blocks.push_back(make_block("octahedron", 0, 0, {octahedron({0.1, 0.06, 0.72}, 0.3)}));
    Scene scene = at_rest(std::move(model), {motion(0.5, 2e-3)});
    throw_block(scene.model, 2, {0.3, 0.2, -1}, scene.state);
    return scene;
}

/// A box that flies off a ledge and falls: the run ends before its time.
Scene ledge(Kinematics kinematics)
{
    Model model = make_model(kinematics, {"stone", 2500, 1e10, 0.2}, dry(30, 1e9));
    hold(model, add_box(model, {-1, -0.5, -0.5}, {1, 0.5, 0}));
    const int block = add_box(model, {0.5, -0.1, 0}, {0.8, 0.1, 0.2});
    Scene scene = at_rest(std::move(model), {motion(2, 4e-3)});
    scene.stages[0].stop_after_fallen = 1;
    throw_block(scene.model, block, {3, 0, 0}, scene.state);
    return scene;
}

/// A wall in running bond, wide enough for loops over its contacts to run on threads.
Scene wall()
{
    Model model = make_model(Kinematics::spatial_rigid, {"stone", 2000, 2e9, 0.2}, dry(31, 2e10));
    const int courses = 12, stones = 14;
    const double length = 0.6, height = 0.3, depth = 0.3;
    hold(model, add_box(model, {-1, 0, -0.3}, {stones * length + 1, depth, 0}));
    for (int course = 0; course < courses; ++course) {
        const bool shifted = course % 2 == 1;
        for (int i = 0; i < stones + shifted; ++i)
            add_box(model, {std::max(0.0, (i - 0.5 * shifted) * length), 0, course * height},
                    {std::min(stones * length, (i + 1 - 0.5 * shifted) * length), depth, (course + 1) * height});
    }
    Stage shaking = motion(0.02, 2e-3);
    shake(6, shaking);
    shaking.control.threads = 2;
    return at_rest(std::move(model), {shaking});
}

}  // namespace

std::vector<NamedScene> scenes()
{
    std::vector<NamedScene> all;
    const auto add = [&](const std::string& name, Kinematics kinematics, auto make) {
        all.push_back({name + ", " + std::string(name_of(kinematics)), [=] { return make(kinematics); }});
    };
    using enum Kinematics;
    const auto solved_by = [](LinearSolverKind solver) {
        return [=](Kinematics kinematics) { return column(kinematics, solver); };
    };
    for (const Kinematics kinematics : {spatial_deformable, spatial_rigid, planar_deformable, planar_rigid}) {
        add("knocks", kinematics, knocks);
        add("column", kinematics, solved_by(LinearSolverKind::automatic));
        add("mortar", kinematics, mortar);
        add("opening", kinematics, opening);
    }
    for (const Kinematics kinematics : {spatial_deformable, planar_rigid}) {
        add("column by cholmod", kinematics, solved_by(LinearSolverKind::cholmod));
        add("column by conjugate gradients", kinematics, solved_by(LinearSolverKind::conjugate_gradients));
        add("published", kinematics, published);
    }
    for (const Kinematics kinematics : {spatial_deformable, spatial_rigid}) add("tumbling", kinematics, tumbling);
    for (const Kinematics kinematics : {spatial_rigid, planar_rigid}) add("ledge", kinematics, ledge);
    all.push_back({"wall, spatial rigid", wall});
    return all;
}

}  // namespace voussoir::app::golden
