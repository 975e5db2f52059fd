// What half stones bend and twist by, against beams; and the balance of slope and moment.
#include "libdda/contact/stone_bending.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using contact::HalfStone;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double young = 5e9, poisson = 0.2, per_area = 1e10;

ConvexPolyhedron prism(const std::vector<Vector2d>& section, double height)
{
    ConvexPolyhedron shape;
    const int n = static_cast<int>(section.size());
    for (const double z : {0., height})
        for (const Vector2d& corner : section) shape.vertices.emplace_back(corner.x(), corner.y(), z);
    shape.faces.resize(2);
    for (int i = 0; i < n; ++i) {
        shape.faces[0].push_back(n - 1 - i);
        shape.faces[1].push_back(n + i);
        shape.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    return shape;
}

/// Stones of a section and their heights along z, one on the other.
Model stones(const std::vector<Vector2d>& section, const std::vector<double>& heights, const JointMaterial& joint)
{
    Model model = make_model(Kinematics::spatial_deformable, stone(young), joint);
    model.materials[0].poisson = poisson;
    for (const double height : heights)
        model.blocks.push_back(make_block("stone", 0, 0, {prism(section, height)}));
    return model;
}

JointMaterial measured()
{
    JointMaterial joint = dry(30);
    joint.stiffness = {ContactStiffness::Kind::per_area, per_area};
    return joint;
}

std::vector<Vector2d> rectangle(double a, double b)
{
    return {{-a / 2, -b / 2}, {a / 2, -b / 2}, {a / 2, b / 2}, {-a / 2, b / 2}};
}

std::vector<Vector2d> circle(double radius, int sides)
{
    std::vector<Vector2d> outline;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return outline;
}

HalfStone<3> half(int block, bool held = false, const Matrix3d& map = Matrix3d::Identity())
{
    return {block, map, held};
}

Matrix3d bending(const Model& model, double area, bool lower_held = false)
{
    return contact::bending_flexibility<3>(model, half(1), half(0, lower_held), Vector3d(0, 0, 1), area);
}

double twist(const Model& model, double area)
{
    return contact::twist_flexibility<3>(model, half(1), half(0), Vector3d(0, 0, 1), area);
}

}  // namespace

TEST(StoneBending, OfHalfStonesIsThatOfABeam)
{
    const double a = 0.6, b = 0.4;
    const Model model = stones(rectangle(a, b), {0.5, 0.3}, measured());
    const double length = 0.4;  // half of the two
    const Matrix3d found = bending(model, a * b), upper = bending(model, a * b, true);
    EXPECT_NEAR(found(0, 0) * young * b * a * a * a / 12, length, 1e-12);
    EXPECT_NEAR(found(1, 1) * young * a * b * b * b / 12, length, 1e-12);
    EXPECT_NEAR(upper(0, 0) * young * b * a * a * a / 12, 0.15, 1e-12);
    EXPECT_LT(found.col(2).norm() + std::abs(found(0, 1)), 1e-15 * found.norm());
    // A face that is half of the section has half of its moment.
    EXPECT_NEAR(bending(model, 0.5 * a * b)(0, 0), 2 * found(0, 0), 1e-12 * found(0, 0));
}

TEST(StoneBending, TurnsWithTheStones)
{
    const Model model = stones(rectangle(0.6, 0.4), {0.5, 0.3}, measured());
    const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, -2, 3).normalized()).toRotationMatrix();
    const Matrix3d found = contact::bending_flexibility<3>(model, half(1, false, turn), half(0, false, turn),
                                                           Vector3d(turn.col(2)), 0.24);
    EXPECT_LT((found - turn * bending(model, 0.24) * turn.transpose()).norm(), 1e-12 * found.norm());
}

// With a joint of f E/L both together bend as the stones would.
TEST(StoneBending, LeavesOutWhatAJointOfARuleYields)
{
    for (const double f : {2., 30., 300.}) {
        JointMaterial joint = dry(30);
        joint.stiffness.value = f;
        const Model model = stones(rectangle(0.6, 0.4), {0.5, 0.5}, joint);
        const double second = 0.4 * 0.6 * 0.6 * 0.6 / 12, of_joint = 1 / (f * young / 0.5 * second);
        EXPECT_NEAR((bending(model, 0.24)(0, 0) + of_joint) * young * second, 0.5, 1e-12) << f;
    }
    JointMaterial soft = dry(30);
    soft.stiffness.value = 0.5;
    EXPECT_TRUE(bending(stones(rectangle(0.6, 0.4), {0.5, 0.5}, soft), 0.24).isZero(0));
}

TEST(StoneBending, OfRigidStonesAndOfCornersIsNone)
{
    Model model = stones(rectangle(0.6, 0.4), {0.5, 0.3}, measured());
    model.joints[0].face = FaceLaw::corners;
    EXPECT_TRUE(bending(model, 0.24).isZero(0));
    EXPECT_EQ(twist(model, 0.24), 0);
    model.joints[0].face = FaceLaw::points;
    model.kinematics = Kinematics::spatial_rigid;
    EXPECT_TRUE(bending(model, 0.24).isZero(0));
    EXPECT_EQ(twist(model, 0.24), 0);
}

// Torsion constants by Saint-Venant: 0.1406 a^4 of a square, 0.2287 and 0.2633 a b^3 of 1 : 2 and 1 : 3, pi r^4
// / 2.
TEST(StoneTwist, IsThatOfTheTorsionConstant)
{
    const double shear = young / (2 * (1 + poisson)), length = 0.4;
    const auto constant = [&](const std::vector<Vector2d>& section, double area) {
        return length / (twist(stones(section, {0.5, 0.3}, measured()), area) * shear);
    };
    EXPECT_NEAR(constant(rectangle(1, 1), 1) / 0.1406, 1, 0.005);
    EXPECT_NEAR(constant(rectangle(2, 1), 2) / 0.4574, 1, 0.005);
    EXPECT_NEAR(constant(rectangle(1, 3), 3) / 0.7899, 1, 0.005);
    const double round = 8 * std::sin(std::numbers::pi / 8);
    EXPECT_NEAR(constant(circle(1, 16), round) / (round * round / (2 * std::numbers::pi)), 1, 0.02);
}

// A strip of springs that do not pull, beside stones that bend: slope and moment at balance, from afar.
TEST(StoneBending, BalancesWhereAFaceIsOpenInPart)
{
    const Eigen::Matrix<double, 1, 1> flexibility(2e-7);
    for (const double lift : {-1e-3, 0., 3e-4}) {
        const auto pressure = [&](const Eigen::Matrix<double, 1, 1>& slope) {
            contact::MomentOf<1> sum;
            for (int i = 0; i < 50; ++i) {
                const double x = -0.5 + (i + 0.5) / 50, gap = lift + (1e-3 + slope[0]) * x;
                if (gap < 0) sum.add(-1e8 * gap * x, 1e8 * x * x);
            }
            return sum;
        };
        Eigen::Matrix<double, 1, 1> moment(1e6);
        contact::balance_moment<1>(flexibility, VectorIn<1>(VectorIn<1>::Zero()), 1, pressure, moment);
        EXPECT_NEAR(pressure(flexibility * moment).moment[0] / moment[0], 1, 1e-12) << lift;
        EXPECT_LT(moment[0], 0);
    }
}

}  // namespace voussoir::testing
