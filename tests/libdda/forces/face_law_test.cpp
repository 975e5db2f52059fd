// Faces that rest on points inside as well as at their corners: bending, torsion, and what must not change.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "libdda/analysis/energies.h"
#include "libdda/analysis/joint_resultants.h"
#include "libdda/analysis/modes.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double pi = std::numbers::pi;

JointMaterial on_points(double friction_degrees, double stiffness)
{
    JointMaterial joint = dry(friction_degrees);
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
    joint.face = FaceLaw::points;
    return joint;
}

// ---- A stack that vibrates -------------------------------------------------------------------------------------

struct Stack {
    int count = 10;
    double width = 1, depth = 1, height = 1;  // m, of a stone along x, y, z
    double stiffness = 1e10;                  // Pa/m
};

/// Adds a joint at the top of stone `below` (-1: the floor) of a chain whose stones have an offset and a rotation:
/// two springs, against shear and against turning. @param lever half the height of a stone [m]
void add_joint(int below, double shear, double turning, double lever, MatrixXd& stiffness)
{
    const int above = below + 1;
    const auto add = [&](double k, double of_below_x, double of_below_turn, double of_above_x,
                         double of_above_turn) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(stiffness.rows());
        if (below >= 0) {
            row[2 * below] = of_below_x;
            row[2 * below + 1] = of_below_turn;
        }
        row[2 * above] = of_above_x;
        row[2 * above + 1] = of_above_turn;
        stiffness += k * row * row.transpose();
    };
    add(shear, -1, -lever, 1, -lever);
    add(turning, 0, -1, 0, 1);
}

/// Frequencies [Hz] of a stack that sways along an axis on which its section is `extent` wide, rising.
std::vector<double> sway(const Stack& stack, double extent)
{
    const int n = stack.count;
    const double area = stack.width * stack.depth, mass = 2500 * area * stack.height;
    MatrixXd stiffness = MatrixXd::Zero(2 * n, 2 * n), masses = MatrixXd::Zero(2 * n, 2 * n);
    for (int i = 0; i < n; ++i) {
        add_joint(i - 1, 0.5 * stack.stiffness * area, stack.stiffness * area * extent * extent / 12,
                  0.5 * stack.height, stiffness);
        masses(2 * i, 2 * i) = mass;
        masses(2 * i + 1, 2 * i + 1) = mass / 12 * (extent * extent + stack.height * stack.height);
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness, masses);
    std::vector<double> frequencies;
    frequencies.reserve(2 * n);
    for (int i = 0; i < 2 * n; ++i) frequencies.push_back(std::sqrt(solver.eigenvalues()[i]) / (2 * pi));
    return frequencies;
}

Model model_of(const Stack& stack, Kinematics kinematics)
{
    Model model = make_model(kinematics, stone(1e14), on_points(35, stack.stiffness));
    model.thickness = stack.depth;
    const double x = 0.5 * stack.width, y = 0.5 * stack.depth;
    hold(model, add_box(model, "floor", {-2 * x, -2 * y, -1}, {2 * x, 2 * y, 0}));
    for (int i = 0; i < stack.count; ++i)
        add_box(model, "stone " + std::to_string(i + 1), {-x, -y, i * stack.height},
                {x, y, (i + 1) * stack.height});
    return model;
}

/// Smallest relative distance of a frequency from those found.
double nearest(double frequency, const NaturalModes& found)
{
    double least = 1;
    for (const NaturalMode& mode : found.modes) least = std::min(least, std::abs(mode.frequency / frequency - 1));
    return least;
}

// ---- An arch that vibrates -------------------------------------------------------------------------------------

using Eigen::Vector2d;

/// A segmental arch of equal voussoirs between two held ones.
struct Arch {
    int count = 15;
    double radius = 5, thickness = 0.5, depth = 0.8, opening = 100;  // m, m, m, degrees
    double stiffness = 1e10;                                         // Pa/m

    double angle(int joint) const { return (90 + opening * (0.5 - double(joint) / count)) * degrees; }
    Vector2d at(double angle, double from_centre) const
    {
        return from_centre * Vector2d(std::cos(angle), std::sin(angle));
    }
    /// Between two angles, counter-clockwise in the plane of x and z.
    std::vector<Vector2d> outline(double left, double right) const
    {
        const double inner = radius - 0.5 * thickness, outer = radius + 0.5 * thickness;
        return {at(left, inner), at(right, inner), at(right, outer), at(left, outer)};
    }
};

int add_prism(Model& model, const std::string& name, const std::vector<Vector2d>& outline, double depth)
{
    if (is_planar(model.kinematics)) {
        model.blocks.push_back(make_planar_block(name, 0, 0, {make_convex_polygon(outline)}, model.thickness));
    } else {
        const int n = static_cast<int>(outline.size());
        std::vector<Vector3d> vertices;
        for (const double y : {-0.5 * depth, 0.5 * depth})
            for (const Vector2d& corner : outline) vertices.emplace_back(corner.x(), y, corner.y());
        std::vector<std::vector<int>> faces(2);
        for (int i = 0; i < n; ++i) {
            faces[0].push_back(i);
            faces[1].push_back(2 * n - 1 - i);
            const int next = (i + 1) % n;
            faces.push_back({i, n + i, n + next, next});
        }
        model.blocks.push_back(make_block(name, 0, 0, {make_convex_polyhedron(vertices, faces)}));
    }
    return static_cast<int>(model.blocks.size()) - 1;
}

Model model_of(const Arch& arch, Kinematics kinematics)
{
    Model model = make_model(kinematics, stone(1e14), on_points(35, arch.stiffness));
    model.thickness = arch.depth;
    const double step = arch.opening / arch.count * degrees;
    hold(model, add_prism(model, "left", arch.outline(arch.angle(0) + step, arch.angle(0)), arch.depth));
    for (int i = 0; i < arch.count; ++i)
        add_prism(model, "stone " + std::to_string(i + 1), arch.outline(arch.angle(i), arch.angle(i + 1)),
                  arch.depth);
    const double end = arch.angle(arch.count);
    hold(model, add_prism(model, "right", arch.outline(end, end - step), arch.depth));
    return model;
}

/// Frequencies [Hz] in its plane, rising: three unknowns a stone, and joints with k A, r k A and k b^3 t / 12 in
/// their middle.
std::vector<double> in_plane(const Arch& arch, const Model& model)
{
    const int n = arch.count;
    MatrixXd stiffness = MatrixXd::Zero(3 * n, 3 * n);
    Eigen::VectorXd masses(3 * n);
    const double area = arch.thickness * arch.depth;
    for (int joint = 0; joint <= n; ++joint) {
        const Vector2d middle = arch.at(arch.angle(joint), arch.radius), radial = middle.normalized(),
                       along(radial.y(), -radial.x());
        const auto add = [&](double k, const Vector2d& direction, double turning) {
            Eigen::VectorXd row = Eigen::VectorXd::Zero(3 * n);
            for (const auto& [block, sign] : {std::pair{joint, -1.0}, {joint + 1, 1.0}}) {
                if (block < 1 || block > n) continue;
                const Vector3d c = model.blocks[block].moments.centroid;
                const Vector2d lever = middle - Vector2d(c.x(), c.z());
                row.segment<2>(3 * (block - 1)) = sign * direction;
                row[3 * (block - 1) + 2] = sign * (direction.dot(Vector2d(-lever.y(), lever.x())) + turning);
            }
            stiffness += k * row * row.transpose();
        };
        add(arch.stiffness * area, along, 0);
        add(0.5 * arch.stiffness * area, radial, 0);
        add(arch.stiffness * area * arch.thickness * arch.thickness / 12, Vector2d::Zero(), 1);
    }
    for (int i = 1; i <= n; ++i) {
        const double mass = model.mass(i);
        const Eigen::Matrix3d& second = model.blocks[i].moments.second;
        masses.segment<3>(3 * (i - 1)) << mass, mass, 2500 * (second(0, 0) + second(2, 2));
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness, MatrixXd(masses.asDiagonal()));
    std::vector<double> frequencies;
    frequencies.reserve(3 * static_cast<std::size_t>(n));
    for (int i = 0; i < 3 * n; ++i) frequencies.push_back(std::sqrt(solver.eigenvalues()[i]) / (2 * pi));
    return frequencies;
}

class Faces : public ::testing::TestWithParam<Kinematics>
{
};

}  // namespace

TEST_P(Faces, AnArchBendsLikeTheirArea)
{
    const Arch arch;
    const Model model = model_of(arch, GetParam());
    const NaturalModes found = natural_modes(model, initial_state(model), {24});
    const std::vector<double> exact = in_plane(arch, model);
    for (int i = 0; i < 3; ++i) EXPECT_LT(nearest(exact[i], found), 1e-3) << "mode " << i + 1;
}

// b^3 t / 12 for each joint, and not the b^3 t / 4 of its corners.
TEST_P(Faces, BendLikeTheirArea)
{
    for (const Stack& stack : {Stack{4}, Stack{10}, Stack{20}, Stack{6, 2, 0.5, 0.5}}) {
        const Model model = model_of(stack, GetParam());
        const NaturalModes found = natural_modes(model, initial_state(model), {24});
        const std::vector<double> exact = sway(stack, stack.width);
        ASSERT_FALSE(found.modes.empty());
        for (int i = 0; i < 3; ++i)
            EXPECT_LT(nearest(exact[i], found), 2e-4) << stack.count << " stones, mode " << i + 1;
        if (stack.width <= stack.depth) {
            EXPECT_NEAR(found.modes[0].frequency / exact[0], 1, 2e-4);
        }
    }
}

// A block of 1 x 2 m whose weight is leaned: phi = 12 N e / (k b^3 t) as long as all of its bed presses.
TEST_P(Faces, TiltLikeTheirArea)
{
    Model model = make_model(GetParam(), stone(1e14), on_points(45, 1e8));
    hold(model, add_box(model, "floor", {-2, -2, -1}, {2, 2, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 2});
    const double weight = model.mass(block) * gravity;
    for (const double e : {0.05, 0.1, 0.16}) {
        State state = initial_state(model);
        const Vector3d leaned = gravity * Vector3d(e, 0, -1);
        run_quietly(model, {static_stage(1, leaned)}, state);
        const Eigen::Matrix3d map = pose_of(model.kinematics, state, block).map;
        // The lever of what leans is one metre, and the bed turns under it.
        const double stiffness = 1e8 / 12, turn = std::asin(map(0, 2));
        EXPECT_NEAR(turn, weight * e / (stiffness - weight), 1e-3 * weight * e / stiffness) << "e = " << e << " m";
    }
}

// The same beyond the middle third, where the bed opens: phi = 2 N / (9 k t (b/2 - e)^2), and the half stone above
// it bends by N e h / (E I).
TEST_P(Faces, OpenLinearly)
{
    const double young = is_deformable(GetParam()) ? 5e9 : 1e14, stiffness = 1e9;
    JointMaterial joint = on_points(60, stiffness);
    joint.face = FaceLaw::linear;
    Model model = make_model(GetParam(), stone(young), joint);
    model.plane = PlaneCondition::stress;
    hold(model, add_box(model, "floor", {-2, -2, -1}, {2, 2, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 2});
    const double weight = model.mass(block) * gravity;
    for (const double lean : {0.1, 0.25, 0.4}) {
        State state = initial_state(model);
        run_quietly(model, {static_stage(1, gravity * Vector3d(lean, 0, -1))}, state);
        const Eigen::Matrix3d map = pose_of(model.kinematics, state, block).map;
        const double sunk = -map(2, 0), e = (lean + map(0, 2)) / (1 - lean * sunk);
        const double springs =
            e < 1.0 / 6 ? 12 * weight * e / stiffness : 2 * weight / (9 * stiffness * (0.5 - e) * (0.5 - e));
        const double of_strain = is_deformable(GetParam()) ? 12 * weight * e / young : 0;
        EXPECT_NEAR(sunk, springs + of_strain, 3e-3 * (springs + of_strain)) << "lean " << lean;
    }
}

// As the line between what presses and what is apart moves to and fro, contacts that are found anew give no
// energy.
TEST_P(Faces, OpenAndCloseWithoutGainOfEnergy)
{
    JointMaterial joint = on_points(40, 1e8);
    joint.face = FaceLaw::linear;
    joint.restitution.reset();
    Model model = make_model(GetParam(), stone(1e14), joint);
    hold(model, add_box(model, "floor", {-2, -2, -1}, {2, 2, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 2});
    State state = initial_state(model);
    run_quietly(model, {static_stage(1)}, state);
    begin_stage(model, 0, state);
    set_velocity(model, state, block, {0.08, 0, 0}, {0, 0.08, 0});
    const double put_in = kinetic_energy(model, state);
    const RunReport report = run_quietly(model, {dynamic_stage(2, 1e-3)}, state);
    EXPECT_LT(report.energy.relative_residual(), 1e-5);
    EXPECT_LT(report.energy.peak_given, 0.01 * put_in);
    EXPECT_LT(std::abs(report.energy.redetection), 0.1 * put_in);
}

INSTANTIATE_TEST_SUITE_P(Every, Faces, every_kinematics(), test_name);

// ---- Plates that spin ------------------------------------------------------------------------------------------

namespace
{

/// Mean distance from the middle of a rectangle of 2 a x 2 b [m].
double mean_distance(double a, double b)
{
    return (std::hypot(a, b) + a * a / (2 * b) * std::asinh(b / a) + b * b / (2 * a) * std::asinh(a / b)) / 3;
}

struct Spinning {
    Model model;
    State state;

    /// A plate of 2 a x 2 b.
    Spinning(double a, double b)
        : model(make_model(Kinematics::spatial_rigid, stone(), on_points(std::atan(0.5) / degrees, 1e10)))
    {
        hold(model, add_box(model, "floor", {-5, -5, -1}, {5, 5, 0}));
        add_box(model, "plate", {-a, -b, 0}, {a, b, 0.02});
        state = initial_state(model);
        run_quietly(model, {static_stage(1)}, state);
    }
    /// @returns the angular velocity that is left [rad/s]
    double run(double spin, double duration, const Vector3d& velocity = Vector3d::Zero())
    {
        state = [&] {
            State moving = state;
            moving.stage = 0;
            begin_stage(model, 0, moving);
            set_velocity(model, moving, 1, velocity, {0, 0, spin});
            return moving;
        }();
        run_quietly(model, {dynamic_stage(duration, 1e-3)}, state);
        return angular_velocity_of(model, state, 1).z();
    }
};

}  // namespace

// Even pressure holds a plate with mu N times the mean distance from its centroid; other outlines: voussoir verify
// face-torsion.
TEST(FaceTorsion, StopsASpinningPlateAsEvenPressureDoes)
{
    for (const double a : {0.3, 0.6, 0.9}) {
        const double b = 0.3, spin = 4, duration = 0.1;
        Spinning plate(a, b);
        const double lost = 0.5 * gravity * mean_distance(a, b) * duration / ((a * a + b * b) / 3);
        EXPECT_NEAR((spin - plate.run(spin, duration)) / lost, 1, 0.01) << a << " x " << b << " m";
    }
}

// A plate that slides in a straight line does not turn, whichever way it goes, and friction is the same.
TEST(FaceTorsion, OfAStraightSlideIsNone)
{
    for (const double towards : {0., 0.3, 0.9}) {
        Spinning plate(0.5, 0.5);
        const Vector3d along(std::cos(towards), std::sin(towards), 0);
        const double turned = plate.run(0, 0.1, along);
        EXPECT_NEAR(turned, 0, 1e-6);
        EXPECT_NEAR(velocity_of(plate.model.kinematics, plate.state, 1).dot(along), 1 - 0.5 * gravity * 0.1, 2e-3);
    }
}

}  // namespace voussoir::testing
