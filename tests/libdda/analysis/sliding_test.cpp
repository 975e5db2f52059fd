// Parts that nothing but used up friction holds.
#include "libdda/analysis/sliding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

constexpr double least = 1;  // N

/// Two boxes on one another and a third beside them, on a floor. @param rough friction of the floor [deg]
Model boxes(Kinematics kinematics, double rough)
{
    Model model = make_model(kinematics, {"stone", 2000, 1e10, 0.2}, dry(rough));
    hold(model, add_box(model, "floor", {-3, -1, -1}, {3, 1, 0}));
    add_box(model, "lower", {0, 0, 0}, {0.5, 0.5, 0.3});
    add_box(model, "upper", {0.1, 0.1, 0.3}, {0.4, 0.4, 0.5});
    add_box(model, "beside", {-1, 0, 0}, {-0.5, 0.5, 0.3});
    return model;
}

/// At rest under gravity that leans by a share of itself.
State at_rest(const Model& model, double lean)
{
    State state = initial_state(model);
    EXPECT_EQ(run_quietly(model, {static_stage(1, {lean * gravity, 0, -gravity})}, state).outcome,
              Outcome::completed);
    return state;
}

}  // namespace

TEST(Sliding, HoldsWhatHasUsedUpItsFriction)
{
    const double limit = std::tan(30 * std::numbers::pi / 180);
    for (const Kinematics kinematics : {Kinematics::planar_rigid, Kinematics::spatial_rigid}) {
        const Model model = boxes(kinematics, 30);
        EXPECT_TRUE(held_by_sliding_joints(model, at_rest(model, 0.9 * limit), least).empty());
        EXPECT_EQ(held_by_sliding_joints(model, at_rest(model, 0.995 * limit), least), (std::vector{1, 2, 3}));
    }
}

// A joint that slides does not matter where a bond or a bar holds as well.
TEST(Sliding, DoesNotCountWhereSomethingElseHolds)
{
    const double limit = std::tan(30 * std::numbers::pi / 180);
    Model model = boxes(Kinematics::spatial_rigid, 30);
    State state = at_rest(model, 0.995 * limit);
    for (ContactPatch& patch : state.contacts.patches) patch.intact = patch.block_a == 3 || patch.block_b == 3;
    EXPECT_EQ(held_by_sliding_joints(model, state, least), (std::vector{1, 2}));
    for (ContactPatch& patch : state.contacts.patches) patch.intact = false;
    EXPECT_TRUE(held_by_sliding_joints(model, state, 1e9).empty()) << "no joint bears as much";
    Bar bar;  // from the stone beside to the floor; it carries as soon as it is longer than it was
    bar.block_a = 3;
    bar.axial = 1e6;
    bar.length = (model.blocks[3].moments.centroid - model.blocks[0].moments.centroid).norm();
    for (const double longer : {0.0, 1e-3}) {
        Model tied = model;
        bar.length -= longer;
        tied.bars = {bar};
        State now = state;
        now.bars = initial_state(tied).bars;
        EXPECT_EQ(held_by_sliding_joints(tied, now, least),
                  longer > 0 ? (std::vector{1, 2}) : (std::vector{1, 2, 3}));
    }
}

}  // namespace voussoir::testing
