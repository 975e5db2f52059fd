// Steps that carry blocks farther than contacts were looked for: nothing goes through anything.
#include "libdda/step/missed_contacts.h"

#include <gtest/gtest.h>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

class MissedContacts : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, MissedContacts, every_kinematics(), test_name);

constexpr double side = 0.5;

/// A stone in the air above a held shelf, thinner than it falls in one step of a second.
Model stone_above_shelf(Kinematics kinematics, double gap)
{
    Model model = make_model(kinematics, stone(), dry(35));
    hold(model, add_box(model, "shelf", {-1, -1, -0.3}, {1, 1, 0}));
    add_box(model, "stone", {0, 0, gap}, {side, side, gap + side});
    add_box(model, "another", {-0.9, 0, 0}, {-0.4, side, side});  // its contact is no other's
    return model;
}

}  // namespace

TEST_P(MissedContacts, AStoneAboveAShelfComesToRestOnIt)
{
    for (const double gap : {1e-4, 1e-3, 5e-3, 0.04}) {
        const Model model = stone_above_shelf(GetParam(), gap);
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {static_stage(1)}, state);
        ASSERT_EQ(report.outcome, Outcome::completed) << gap << ": " << ::testing::PrintToString(report.diagnosis);
        EXPECT_NEAR(centroid(model, state, 1).z(), side / 2, 1e-5) << gap;
        EXPECT_LT(report.deepest.share, 0.01) << gap;
    }
}

// What goes farther than a tenth of its size before it meets something does not settle, it falls: a static stage
// says so, a dynamic one lets it land, however many shelves deep one of its steps reaches.
TEST_P(MissedContacts, AStoneHighAboveAShelfFallsAndLandsOnIt)
{
    for (const double gap : {0.2, 3.0}) {
        const Model model = stone_above_shelf(GetParam(), gap);
        State state = initial_state(model);
        const RunReport resting = run_quietly(model, {static_stage(1)}, state);
        EXPECT_EQ(resting.outcome, Outcome::collapsed) << gap;
        ASSERT_TRUE(resting.diagnosis.has_value());
        EXPECT_EQ(resting.diagnosis->blocks, std::vector<int>{1}) << gap;
        EXPECT_GT(centroid(model, state, 1).z(), side / 2) << gap << ": nothing met it yet";

        for (const double step : {0.01, 0.25}) {
            state = initial_state(model);
            const RunReport landing = run_quietly(model, {dynamic_stage(2, step), static_stage(1)}, state);
            // It touched nothing at the start: that it lies lower now is no collapse.
            ASSERT_EQ(landing.outcome, Outcome::completed)
                << gap << ": " << ::testing::PrintToString(landing.diagnosis);
            EXPECT_NEAR(centroid(model, state, 1).z(), side / 2, 1e-5) << gap << ", step " << step;
            EXPECT_LT(landing.deepest.share, 0.01) << gap << ", step " << step;
        }
    }
}

// A ball shot at a thin wall by a force that acts within the step: its velocity at the start does not tell.
TEST_P(MissedContacts, AStoneThatIsPushedHardStopsAtAThinWall)
{
    Model model = make_model(GetParam(), stone(), dry(0));
    hold(model, add_box(model, "wall", {1, -2, -2}, {1.01, 2, 2}));
    const int ball = add_box(model, "ball", {0, 0, 0}, {0.2, 0.2, 0.2});
    add_box(model, "bystander", {-9, 0, 0}, {-8, 1, 1});
    add_box(model, "another", {-8, 0, 0}, {-7, 1, 1});
    Stage stage = dynamic_stage(0.2, 0.05, Eigen::Vector3d::Zero());
    const auto push = std::make_shared<GroundMotion>(
        GroundMotion::from_acceleration(std::vector<double>(11, 2000.0), 0.02, "a steady push"));
    stage.body_accelerations = {{ball, 0, push}};
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {stage}, state);
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_LT(centroid(model, state, ball).x(), 1) << "on the near side";
}

}  // namespace voussoir::testing
