// Faces that rest on points inside as well as at their corners: bending, torsion, and what must not change.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

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

class Faces : public ::testing::TestWithParam<Kinematics>
{
};

}  // namespace

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
