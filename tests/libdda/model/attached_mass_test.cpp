// Masses that ride on blocks, and friction that differs from block to block.
#include <gtest/gtest.h>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(AttachedMass, MovesTheCentreOfMassAndAddsTheInertiaOfAPoint)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    add_box(model, "block", {0, 0, 0}, {1, 2, 4});
    const double own = 2500 * 8;
    const std::vector<std::pair<double, Vector3d>> masses{{own, {0.5, 1, 4}}, {own / 2, {0, 0, 2}}};
    for (const auto& [mass, point] : masses) attach_mass(model, 0, mass, point);
    EXPECT_DOUBLE_EQ(model.mass(0), 2.5 * own);
    const Vector3d box_centre(0.5, 1, 2);
    const Vector3d centre = (own * box_centre + own * masses[0].second + own / 2 * masses[1].second) / (2.5 * own);
    EXPECT_LT((model.blocks[0].moments.centroid - centre).norm(), 1e-12);
    Matrix3d second = own / 12 * Vector3d(1, 4, 16).asDiagonal();
    second += own * (box_centre - centre) * (box_centre - centre).transpose();
    for (const auto& [mass, point] : masses) second += mass * (point - centre) * (point - centre).transpose();
    EXPECT_LT((model.mass_second(0) - second).norm(), 1e-10 * second.norm());
    Vector3d corner = model.blocks[0].parts[0].vertices[0] + model.blocks[0].moments.centroid;
    EXPECT_LT(corner.norm(), 1e-12) << "the stone itself stays where it is";
}

/// Seen from a plane inclined so that gravity pulls sideways with tan(angle): a block tips when the line of its
/// weight leaves its foot.
bool tips(double tangent, double mass_on_top, Kinematics kinematics)
{
    Model model = make_model(kinematics, stone(), dry(60));
    hold(model, add_box(model, "floor", {-5, -5, -1}, {5, 5, 0}));
    add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
    const double own = model.mass(1);
    if (mass_on_top > 0) attach_mass(model, 1, mass_on_top * own, {0, 0, 1});
    State state = initial_state(model);
    run_quietly(model, {dynamic_stage(0.5, 2e-3, inclined_gravity(std::atan(tangent) / degrees))}, state);
    return std::abs(pose_of(model.kinematics, state, 1).map(0, 2)) > 0.01;
}

TEST(AttachedMass, LowersTheThresholdOfOverturning)
{
    for (const Kinematics kinematics : {Kinematics::spatial_rigid, Kinematics::planar_rigid}) {
        // The centre of mass of the block alone is 0.5 m high and half a metre from the edge; with its own mass
        // again on top it is 0.75 m high.
        EXPECT_FALSE(tips(0.97, 0, kinematics));
        EXPECT_TRUE(tips(1.03, 0, kinematics));
        EXPECT_FALSE(tips(0.97 * 2 / 3, 1, kinematics));
        EXPECT_TRUE(tips(1.03 * 2 / 3, 1, kinematics));
    }
}

TEST(FrictionFactor, IsTheMeanOfTheTwoBlocks)
{
    for (const double factor : {0.5, 1.5}) {
        Model model = block_on_plane(Kinematics::spatial_rigid, 30);
        model.blocks[1].friction_factor = factor;
        const double coefficient = (1 + factor) / 2 * std::tan(30 * degrees), angle = 50;
        State state = initial_state(model);
        const double start = centroid(model, state, 1).x();
        run_quietly(model, {dynamic_stage(0.5, 1e-3, inclined_gravity(angle))}, state);
        const double expected =
            0.125 * gravity * (std::sin(angle * degrees) - coefficient * std::cos(angle * degrees));
        EXPECT_NEAR(centroid(model, state, 1).x() - start, expected, 2e-3 * expected);
    }
}

}  // namespace
}  // namespace voussoir::testing
