// When the numerics fail: no exception, no repair, the last good state and a diagnosis that names the block.
#include <gtest/gtest.h>

#include "libdda/step/advance.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

class GivingUp : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, GivingUp, every_kinematics(), test_name);

/// A block that knocks against a floor within the first step.
struct Knock {
    Model model;
    State state;

    explicit Knock(Kinematics kinematics)
    {
        model = make_model(kinematics, stone(), dry(30));
        hold(model, add_box(model, "floor", {-2, -2, -1}, {2, 2, 0}));
        add_box(model, "keystone", {-0.5, -0.5, 0.001}, {0.5, 0.5, 0.3});
        state = initial_state(model);
        set_velocity(model, state, 1, {1, 0.5, -5}, {0.3, 2, 0.1});
    }
};

/// A step that may not iterate and may not be cut.
Stage impossible()
{
    Stage stage = dynamic_stage(0.1, 1e-3);
    stage.control.max_open_close = 0;
    stage.control.min_time_step = 1e-3;
    stage.control.divide_up_to_blocks = 0;  // free flight up to the knock needs no iteration
    return stage;
}

}  // namespace

TEST_P(GivingUp, LeavesTheStateUntouchedAndNamesTheBlock)
{
    Knock knock(GetParam());
    const std::uint64_t before = hash_of(knock.state);
    const RunReport report = run_quietly(knock.model, {impossible()}, knock.state);
    EXPECT_EQ(report.outcome, Outcome::gave_up);
    EXPECT_EQ(hash_of(knock.state), before);
    EXPECT_EQ(report.unconverged_steps, 1);
    EXPECT_EQ(report.steps, 0);
    ASSERT_TRUE(report.diagnosis);
    EXPECT_EQ(report.diagnosis->kind, DiagnosisKind::chatter) << *report.diagnosis;
    EXPECT_EQ(report.diagnosis->blocks, std::vector{1});
    EXPECT_EQ(value_of(*report.diagnosis, "cuts"), 1);
    EXPECT_EQ(report.energy.gravity_work, 0);
}

TEST_P(GivingUp, KeepsTheLastGoodStateInTheMiddleOfARun)
{
    FewBlocks scene(GetParam(), {});
    Stage good = shaking(0.02, 1e-3), bad = shaking(0.02, 1e-3);
    good.control.divide_up_to_blocks = bad.control.divide_up_to_blocks = 0;  // every step is a nominal one
    bad.control.max_open_close = 0;
    bad.control.min_time_step = 1e-3;
    State reference = scene.state;
    run_quietly(scene.model, {good}, reference);
    begin_stage(scene.model, 1, reference);
    const RunReport report = run_quietly(scene.model, {good, bad}, scene.state);
    EXPECT_EQ(report.outcome, Outcome::gave_up);
    EXPECT_EQ(report.steps, 20);
    EXPECT_EQ(hash_of(scene.state), hash_of(reference));
}

// Cutting is the last resort, and counted: with a smaller least step the same scene gets through.
TEST_P(GivingUp, DoesNotHappenWhileTheStepCanBeCut)
{
    FewBlocks scene(GetParam(), {});
    Stage stage = shaking(0.02, 1e-3);
    stage.control.max_open_close = 1;
    stage.control.divide_up_to_blocks = 0;
    const RunReport report = run_quietly(scene.model, {stage}, scene.state);
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_GT(report.step_cuts, 0);
    EXPECT_GT(report.steps, 20);
    EXPECT_EQ(scene.state.grid, 20);
    EXPECT_EQ(scene.state.stage_time, 0.02);
    EXPECT_EQ(report.unconverged_steps, 0);
}

// A stage that may not make the steps that it needs says so; that its stones fall it does not say without seeing
// it.
TEST_P(GivingUp, StaticStageThatIsNotAtRest)
{
    const Model model = block_on_plane(GetParam(), 20);
    State state = initial_state(model);
    Stage stage = static_stage(0.01, inclined_gravity(45));
    stage.max_static_steps = 2;
    const RunReport report = run_quietly(model, {stage}, state);
    EXPECT_EQ(report.outcome, Outcome::gave_up);
    ASSERT_TRUE(report.diagnosis);
    EXPECT_EQ(report.diagnosis->kind, DiagnosisKind::no_equilibrium) << *report.diagnosis;
    EXPECT_EQ(value_of(*report.diagnosis, "steps"), 2);
    EXPECT_EQ(value_of(*report.diagnosis, "unbalanced"), report.static_unbalanced);
    EXPECT_EQ(report.unconverged_steps, 1);
    EXPECT_GT(report.static_unbalanced, 0.1);
}

// One in which stones fall has collapsed, and those that fall are named, not those that stand.
TEST_P(GivingUp, IsNotWhatAStaticStageOfAMechanismDoes)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "ground", {-1, -1, -1}, {3, 1, 0}));
    add_box(model, "pier", {0, -0.5, 0}, {0.5, 0.5, 1});
    add_box(model, "beam", {0.3, -0.5, 1}, {1.6, 0.5, 1.2});  // its middle lies 45 cm beside the pier
    add_box(model, "sound", {2, -0.5, 0}, {2.5, 0.5, 1});
    add_box(model, "loose", {2.6, -0.5, 4}, {3.1, 0.5, 4.5});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.02), dynamic_stage(1, 0.01)}, state);
    EXPECT_EQ(report.outcome, Outcome::collapsed);
    ASSERT_TRUE(report.diagnosis);
    EXPECT_EQ(report.diagnosis->kind, DiagnosisKind::mechanism) << *report.diagnosis;
    std::vector<int> falling = report.diagnosis->blocks;
    std::sort(falling.begin(), falling.end());
    EXPECT_EQ(falling, (std::vector{2, 4})) << *report.diagnosis;
    EXPECT_EQ(report.unconverged_steps, 0);
    EXPECT_EQ(report.simulated_time, 0) << "no stage follows";
    EXPECT_TRUE(is_whole(*report.diagnosis));
}

TEST_P(GivingUp, IsNotWhatARequestToStopIs)
{
    Knock knock(GetParam());
    RunObserver observer;
    observer.stop = [] { return true; };
    const RunReport report = run(knock.model, {dynamic_stage(0.02, 1e-3)}, knock.state, observer);
    EXPECT_EQ(report.outcome, Outcome::interrupted);
    ASSERT_TRUE(report.diagnosis);
    EXPECT_EQ(report.diagnosis->kind, DiagnosisKind::interrupted) << *report.diagnosis;
    EXPECT_EQ(report.steps, 1);
    EXPECT_EQ(report.unconverged_steps, 0);
}

}  // namespace voussoir::testing
