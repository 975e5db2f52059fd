// What the ground and the foot of a structure are, and from where displacements and openings count.
#include "libdda/analysis/ground.h"

#include <gtest/gtest.h>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Two stones side by side, on one or two blocks of another material, which is soil.
Model on_soil()
{
    Model model = make_model(Kinematics::spatial_deformable, stone(), dry(35));
    model.materials.push_back(stone());
    for (const double x : {-1., 0.}) {
        add_box(model, "soil", {x, -1, -1}, {x + 1, 1, 0});
        model.blocks.back().material = 1;
    }
    add_box(model, "left", {-0.9, -0.5, 0}, {-0.1, 0.5, 1});
    add_box(model, "right", {0.1, -0.5, 0}, {0.9, 0.5, 1});
    add_box(model, "lintel", {-0.9, -0.5, 1}, {0.9, 0.5, 1.5});
    model.boundaries.push_back({"base", {{0, 0, 0}}, RestSupport::full, {}});
    return model;
}

Foot foot_of(const Model& model)
{
    return {model, joints_at_start(model, initial_state(model))};
}

void shift(const Model& model, int block, const Vector3d& by, State& state)
{
    set_pose(model, state, block, model.blocks[block].moments.centroid + by, Matrix3d::Identity());
}

}  // namespace

TEST(FootOf, AStructureOnSoilIsTheStonesThatLieOnIt)
{
    const Model model = on_soil();
    const Foot foot = foot_of(model);
    EXPECT_TRUE(foot.is_on_soil());
    EXPECT_EQ(foot.blocks(), (std::vector<int>{2, 3}));
    EXPECT_EQ(ground_marks(model), (std::vector<bool>{true, true, false, false, false}));
    State state = initial_state(model);
    shift(model, 1, {9, 9, 9}, state);  // the soil goes its own way
    shift(model, 2, {0.02, 0, 0.01}, state);
    shift(model, 3, {0.04, 0, -0.01}, state);
    EXPECT_LT((foot.displacement(model, state) - Vector3d(0.03, 0, 0)).norm(), 1e-15);
}

TEST(FootOf, AStructureOnSupportsIsTheirMeanAlongTheAxesTheyHold)
{
    Model model = on_soil();
    model.boundaries.clear();
    hold(model, 0);
    hold(model, 1);
    model.foundations[1].translation_held = {false, true, true};
    const Foot foot = foot_of(model);
    EXPECT_FALSE(foot.is_on_soil());
    State state = initial_state(model);
    shift(model, 0, {0.02, 0.01, 0}, state);
    shift(model, 1, {0.5, 0.03, 0}, state);
    EXPECT_LT((foot.displacement(model, state) - Vector3d(0.02, 0.02, 0)).norm(), 1e-15);
}

TEST(FootOf, SoilAloneIsWhereTheModelEnds)
{
    Model model = on_soil();
    model.blocks.resize(2);
    EXPECT_FALSE(foot_of(model).is_on_soil());
    EXPECT_EQ(foot_of(model).blocks(), std::vector<int>{0});
}

// A stone that sinks and tilts on a soft bed under its own weight: none of that is told of the motion afterwards.
TEST(PeaksOfJoints, CountSinceTheFirstMotion)
{
    JointMaterial soft = dry(35);
    soft.stiffness = {ContactStiffness::Kind::per_area, 2e6};
    Model model = make_model(Kinematics::planar_rigid, stone(), soft);
    hold(model, add_box(model, "floor", {-5, -1, -1}, {5, 1, 0}));
    add_box(model, "stone", {0, -0.5, 0}, {1, 0.5, 1});
    const Vector3d leaning(1.5, 0, -gravity);
    Stage still = dynamic_stage(0.2, 2e-3, leaning);
    State state = initial_state(model);
    const RunReport at_rest = run_quietly(model, {static_stage(0.1, leaning)}, state);
    ASSERT_EQ(at_rest.joints.size(), 1U);
    EXPECT_GT(at_rest.joints[0].slip, 1e-3);
    EXPECT_TRUE(at_rest.joints[0].slid);
    state = initial_state(model);
    const RunReport moved = run_quietly(model, {static_stage(0.1, leaning), still}, state);
    EXPECT_LT(moved.joints[0].slip, 1e-6);
    EXPECT_LT(moved.joints[0].opening, 1e-6);
    EXPECT_FALSE(moved.joints[0].slid);
}

}  // namespace voussoir::testing
