// Blocks that fall: noticed once, in order, and no failure of the run.
#include "libdda/analysis/collapse.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

class Collapse : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Collapse, every_kinematics(), test_name);

/// A pillar, a stone on it, and two stones in the air, one above the other.
struct Ruin {
    Model model;
    State state;
    int resting = 0, low = 0, high = 0;

    explicit Ruin(Kinematics kinematics)
    {
        model = make_model(kinematics, stone(), dry(30));
        hold(model, add_box(model, "pillar", {-0.5, -0.5, -1}, {0.5, 0.5, 0}));
        resting = add_box(model, "resting", {-0.5, -0.5, 0}, {0.5, 0.5, 0.5});
        low = add_box(model, "low", {2, -0.5, 0}, {3, 0.5, 0.5});
        high = add_box(model, "high", {4, -0.25, 3}, {4.5, 0.25, 3.25});
        state = initial_state(model);
    }
};

}  // namespace

// A stone has fallen when it is lower by its size: at the step after sqrt(2 size / g).
TEST_P(Collapse, IsToldWithTimeAndOrder)
{
    Ruin ruin(GetParam());
    const RunReport report = run_quietly(ruin.model, {dynamic_stage(0.6, 1e-3)}, ruin.state);
    EXPECT_EQ(report.outcome, Outcome::collapsed) << "for good, though the stage goes on to its end";
    EXPECT_EQ(ruin.state.time, 0.6);
    ASSERT_EQ(report.fallen.size(), 2);
    EXPECT_EQ(report.fallen[0].block, ruin.high);  // the smaller one
    EXPECT_EQ(report.fallen[1].block, ruin.low);
    for (const FallenBlock& fallen : report.fallen) {
        const double exact = std::sqrt(2 * size_of(ruin.model, fallen.block) / gravity);
        EXPECT_NEAR(fallen.time, exact, 2e-3);
        EXPECT_FALSE(fallen.left);
    }
    EXPECT_TRUE(report.warnings.empty()) << report.warnings[0];
    ASSERT_TRUE(report.diagnosis);
    EXPECT_EQ(report.diagnosis->kind, DiagnosisKind::fallen) << *report.diagnosis;
    EXPECT_EQ(report.diagnosis->blocks, (std::vector{ruin.high, ruin.low}));
    EXPECT_EQ(report.diagnosis->values, (std::vector{report.fallen[0].time, report.fallen[1].time}));
}

// Where the numerics fail in the ruins, that is told beside the collapse, and the run is no failure.
TEST_P(Collapse, IsNotUndoneByNumericsThatFailAfterwards)
{
    Ruin ruin(GetParam());
    Stage impossible = dynamic_stage(1, 1e-3, {gravity, 0, -gravity});  // what rests has to slide
    impossible.control.max_open_close = 0;
    impossible.control.min_time_step = 1e-3;
    const RunReport report = run_quietly(ruin.model, {dynamic_stage(0.6, 1e-3), impossible}, ruin.state);
    EXPECT_EQ(report.outcome, Outcome::collapsed);
    ASSERT_TRUE(report.diagnosis);
    EXPECT_EQ(report.diagnosis->kind, DiagnosisKind::fallen) << *report.diagnosis;
    ASSERT_EQ(report.warnings.size(), 1);
    EXPECT_EQ(report.warnings[0].kind, DiagnosisKind::chatter) << report.warnings[0];
    EXPECT_NEAR(ruin.state.time, 0.6, 1e-12);
}

// A stone that is thrown, or let fall, and lands has fallen, but no structure has.
TEST_P(Collapse, IsNotTheLandingOfWhatFlewAtTheStart)
{
    for (const bool is_thrown : {false, true}) {
        SCOPED_TRACE(is_thrown);
        Model model = make_model(GetParam(), stone(), dry(30));
        hold(model, add_box(model, "ground", {-2, -0.5, -1}, {4, 0.5, 0}));
        add_box(model, "step", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
        const double x = is_thrown ? 0.3 : 1;  // m: on the step, or beside it
        const int flying = add_box(model, "flying", {x, -0.5, 1}, {x + 0.2, 0.5, 1.2});
        if (is_thrown) model.initial_motions = {{flying, {3, 0, 0}}};
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {dynamic_stage(2, 1e-3)}, state);
        ASSERT_EQ(report.fallen.size(), 1);
        EXPECT_EQ(report.fallen[0].block, flying);
        EXPECT_EQ(report.outcome, Outcome::completed);
        EXPECT_FALSE(report.diagnosis);
        ASSERT_EQ(report.warnings.size(), 1) << "that it fell is told";
        EXPECT_EQ(report.warnings[0].kind, DiagnosisKind::fallen) << report.warnings[0];
    }
}

// Pushed off, without a velocity of its own, the same stone has fallen from the structure.
TEST_P(Collapse, IsALandingOfWhatStoodAtTheStart)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "ground", {-2, -0.5, -1}, {4, 0.5, 0}));
    hold(model, add_box(model, "step", {-0.5, -0.5, 0}, {0.5, 0.5, 1}));
    const int over_edge = add_box(model, "over the edge", {0.4, -0.5, 1}, {0.9, 0.5, 1.2});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {dynamic_stage(3, 1e-3)}, state);
    EXPECT_EQ(report.outcome, Outcome::collapsed);
    ASSERT_EQ(report.fallen.size(), 1);
    EXPECT_EQ(report.fallen[0].block, over_edge);
}

TEST_P(Collapse, EndsTheRunWhenTheStageSaysSo)
{
    Ruin ruin(GetParam());
    Stage stage = dynamic_stage(5, 1e-3);
    stage.stop_after_fallen = 1;
    const RunReport report = run_quietly(ruin.model, {stage, dynamic_stage(1, 1e-3)}, ruin.state);
    EXPECT_EQ(report.outcome, Outcome::collapsed);
    EXPECT_EQ(report.fallen.size(), 1);
    EXPECT_LT(ruin.state.time, 0.5);
    EXPECT_EQ(report.unconverged_steps, 0);
    ASSERT_TRUE(report.diagnosis);
    EXPECT_EQ(report.diagnosis->kind, DiagnosisKind::fallen) << *report.diagnosis;
    EXPECT_EQ(report.diagnosis->blocks, std::vector{ruin.high});
    EXPECT_TRUE(report.warnings.empty()) << "what ended the run is not told twice";
}

TEST_P(Collapse, EndsTheRunWhenEverythingHasLeft)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "floor", {-0.5, -0.5, -1}, {0.5, 0.5, 0}));
    add_box(model, "stone", {2, -0.5, 0}, {3, 0.5, 0.5});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {dynamic_stage(100, 1e-3)}, state);
    EXPECT_EQ(report.outcome, Outcome::collapsed);
    ASSERT_EQ(report.fallen.size(), 1);  // fell, and later left
    EXPECT_TRUE(report.fallen[0].left);
    EXPECT_LT(report.fallen[0].time, 0.5);
    EXPECT_LT(state.time, 3);
}

TEST_P(Collapse, IsNoWordForBodiesInFreeSpace)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "comet", {2, -0.5, 0}, {3, 0.5, 0.5});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {dynamic_stage(3, 1e-2)}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_TRUE(report.fallen.empty());
}

// Low is not fallen while something carries it: a lift takes the stone down with it.
TEST_P(Collapse, IsNotWhatGoesDownWithTheGround)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "lift", {-0.5, -0.5, -1}, {0.5, 0.5, 0}));
    const int carried = add_box(model, "carried", {-0.4, -0.4, 0}, {0.4, 0.4, 0.4});
    State state = initial_state(model);
    Stage down = dynamic_stage(2, 2e-3);
    down.motions = {{0, 2, std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(-2, 0.5, 0, 2))}};
    const RunReport report = run_quietly(model, {static_stage(0.1), down}, state);
    ASSERT_LT(pose_of(model.kinematics, state, carried).centroid.z(), -size_of(model, carried));
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_TRUE(report.fallen.empty());
}

// Without gravity nothing falls, but a block can leave.
// The ground sinks by more than the stone's size and comes to rest with a jolt that makes the stone hop.
TEST_P(Collapse, IsNotAHopOnGroundThatHasSunk)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "ground", {-2, -2, -1}, {2, 2, 0}));
    add_box(model, "pebble", {0, 0, 0}, {0.1, 0.1, 0.1});
    std::vector<double> sinking;
    for (int i = 0; i <= 30; ++i) sinking.push_back(-0.15 * i / 30);
    Stage stage = dynamic_stage(0.6, 1e-3);
    stage.motions = {
        {0, 2, std::make_shared<GroundMotion>(GroundMotion::from_displacement(sinking, 0.01, "sinks and stops"))}};
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(1), stage}, state);
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_TRUE(report.fallen.empty());
}

TEST_P(Collapse, IsToldOfBlocksThatLeave)
{
    Ruin ruin(GetParam());
    set_velocity(ruin.model, ruin.state, ruin.low, {50, 0, 0});
    const RunReport report =
        run_quietly(ruin.model, {dynamic_stage(0.5, 1e-3, Eigen::Vector3d::Zero())}, ruin.state);
    ASSERT_EQ(report.fallen.size(), 1);
    EXPECT_EQ(report.fallen[0].block, ruin.low);
    EXPECT_TRUE(report.fallen[0].left);
}

}  // namespace voussoir::testing
