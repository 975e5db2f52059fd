// The plain iteration: right by itself, and the measure of the fast one.
#include "libdda/iterate/plain.h"

#include <gtest/gtest.h>

#include "libdda/step/advance.h"
#include "libdda/step/workspace.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

class Plain : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Plain, every_kinematics(), test_name);

Stage by(OpenClose iteration, Stage stage)
{
    stage.control.open_close = iteration;
    if (iteration == OpenClose::plain) stage.control.max_open_close = plain_open_close;
    return stage;
}

}  // namespace

TEST_P(Plain, ABlockSlidesDownAnIncline)
{
    const Model model = block_on_plane(GetParam(), 20);
    State state = initial_state(model);
    const Stage stage = by(OpenClose::plain, dynamic_stage(0.5, 2e-3, inclined_gravity(45)));
    const RunReport report = run_quietly(model, {stage}, state);
    const double exact =
        0.5 * 0.25 * gravity * (std::sin(45 * degrees) - std::cos(45 * degrees) * std::tan(20 * degrees));
    EXPECT_EQ(report.step_cuts, 0);
    EXPECT_NEAR(centroid(model, state, 1).x(), exact, 1e-3 * exact);
}

// A stack that is shaken, rocks, slides and lands: solved a hundred times as closely as by default, step after
// step both leave it where the other does, within the default tolerance. Each step of the plain one begins where
// the fast one came to.
TEST_P(Plain, MakesTheStepsOfTheFastOne)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "floor", {-3, -1, -1}, {3, 1, 0}));
    for (int i = 0; i < 3; ++i) add_box(model, "b", {-0.2, -0.3, 0.5 * i}, {0.2, 0.3, 0.5 * (i + 1)});
    add_box(model, "falls", {0.3, -0.2, 0.02}, {0.7, 0.2, 0.4});
    State state = initial_state(model);
    Stage fast = by(OpenClose::newton, dynamic_stage(0, 2e-3)), plain = by(OpenClose::plain, fast);
    const auto shaking = std::make_shared<const GroundMotion>(GroundMotion::sine_acceleration(5, 3, 0, 1));
    const double tolerance = fast.control.force_tolerance;
    for (Stage* stage : {&fast, &plain}) {
        stage->motions.push_back({0, 0, shaking});
        stage->control.force_tolerance = tolerance / 100;
    }
    begin_stage(model, 0, state);
    EnergyLedger of_fast = open_ledger(model, state);
    Workspace work_fast(model), work_plain(model);
    const double h = fast.control.time_step;
    double worst = 0;
    for (int step = 0; step < 200; ++step) {
        State other = state;
        EnergyLedger of_plain = of_fast;
        const StepReport one = advance(model, fast, h, state, of_fast, work_fast);
        const StepReport two = advance(model, plain, h, other, of_plain, work_plain);
        ASSERT_EQ(one.outcome, StepOutcome::converged);
        ASSERT_EQ(two.outcome, StepOutcome::converged);
        if (one.cuts + two.cuts > 0 || one.time_step != two.time_step) continue;
        for (int b = 1; b < static_cast<int>(model.blocks.size()); ++b) {
            const double apart = (centroid(model, state, b) - centroid(model, other, b)).norm();
            worst = std::max(worst, 2 * apart / (h * h * gravity * tolerance));
        }
    }
    std::printf("the two steps differ by %.2g tolerances\n", worst);
    EXPECT_LT(worst, 1);
}

}  // namespace voussoir::testing
