// Steps that the program chooses: the longest that leaves vibrations alone, halved where steps take too much.
#include "libdda/run/automatic_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "libdda/analysis/integrator_accuracy.h"
#include "libdda/analysis/longest_step.h"
#include "libdda/analysis/trust.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

NaturalModes of_frequency(double frequency)
{
    NaturalModes modes;
    modes.outcome = ModesOutcome::found;
    modes.modes.resize(1);
    modes.modes[0].frequency = frequency;
    modes.modes[0].mass_share = {1, 0, 0};
    return modes;
}

/// Whether a step leaves a vibration alone, by the limits as they are written.
bool is_within(double frequency, const Stage& stage, double step)
{
    StepControl control = stage.control;
    control.time_step = step;
    const IntegratorAccuracy accuracy =
        integrator_accuracy(2 * std::numbers::pi * frequency * step, control.dissipation_used());
    return accuracy.damping <= 0.002 && accuracy.period_error <= 0.01;
}

Stage shaken(double duration, double frequency, double acceleration)
{
    Stage stage = dynamic_stage(duration, 1e-3);
    stage.motions.push_back(
        {0, 0,
         std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(acceleration, frequency, 0, duration))});
    return stage;
}

/// A column of drums on a floor.
struct Column {
    Model model = make_model(Kinematics::planar_rigid, stone(), dry(35));
    State state;

    Column()
    {
        hold(model, add_box(model, "floor", {-3, -1, -1}, {3, 1, 0}));
        for (int drum = 0; drum < 6; ++drum)
            add_box(model, "drum", {-0.5, -0.5, 0.5 * drum}, {0.5, 0.5, 0.5 * drum + 0.5});
        state = initial_state(model);
    }
};

}  // namespace

TEST(LongestStep, IsTheFirstOfTheUsualOnesWithinTheLimits)
{
    const Stage stage = dynamic_stage(10, 1e-3);
    for (const double frequency : {1.0, 3.0, 8.0, 15.0, 25.0, 32.0}) {
        const double step = longest_step(of_frequency(frequency), stage);
        EXPECT_TRUE(is_within(frequency, stage, step)) << frequency;
        if (step < usual_steps.front()) {
            EXPECT_FALSE(is_within(frequency, stage, 2 * step)) << frequency;
        }
    }
    EXPECT_GT(longest_step(of_frequency(1), stage), longest_step(of_frequency(25), stage));
    NaturalModes unknown;
    unknown.outcome = ModesOutcome::too_costly;
    EXPECT_EQ(longest_step(unknown, stage), step_of_unknown_modes);
}

TEST(LongestStep, FollowsTheMotion)
{
    // A line between two points of a sine is off in its middle by 1 - cos(omega h / 2) of it.
    for (const double frequency : {2.0, 10.0, 20.0, 40.0}) {
        const double step = longest_step({}, shaken(2, frequency, 1));
        EXPECT_LE(1 - std::cos(std::numbers::pi * frequency * step), 0.051) << frequency;
    }
    EXPECT_LT(longest_step({}, shaken(2, 40, 1)), longest_step({}, shaken(2, 2, 1)));
}

TEST(AutomaticStep, OfWhatDoesNotLandStays)
{
    Column scene;
    Stage stage = shaken(1, 2, 0.1 * standard_gravity);  // it rocks from g / 3 on
    stage.control.time_step = 4e-3;
    stage.control.automatic = true;
    const RunReport report = run(scene.model, {static_stage(0.1), stage}, scene.state, {});
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_TRUE(report.shorter_steps.empty());
}

// The same column, by 8 ms for good and by 8 ms that may become shorter: only the latter stays within the limits.
TEST(AutomaticStep, IsHalvedUntilTheRunIsWithinItsLimits)
{
    const auto ended = [](bool automatic) {
        Column scene;
        Stage stage = shaken(3, 1.5, 0.7 * standard_gravity);
        stage.control.time_step = 8e-3;
        stage.control.automatic = automatic;
        stage.control.divide_up_to_blocks = 0;
        return run(scene.model, {static_stage(0.1), stage}, scene.state, {});
    };
    const RunReport fixed = ended(false), halved = ended(true);
    const auto taken = [](const RunReport& report) {
        const EnergyShares shares = shares_of(report.energy, {}, false);
        return std::max(shares.integrator / most_taken_by_integrator, shares.closing / most_taken_by_closing);
    };
    EXPECT_GT(taken(fixed), 1);
    EXPECT_LT(taken(halved), 1);
    ASSERT_FALSE(halved.shorter_steps.empty());
    double before = 8e-3;
    for (const ShorterSteps& shorter : halved.shorter_steps) {
        EXPECT_DOUBLE_EQ(shorter.time_step, before / 2);
        EXPECT_FALSE(shorter.at_start);
        before = shorter.time_step;
    }
    EXPECT_GT(halved.steps, fixed.steps);
}

TEST(AutomaticStep, IsHalvedAtTheStartForWhatVibratesAtRest)
{
    // 25 Hz on springs: 8 ms damp it by 2 % of critical.
    JointMaterial joint = dry(35);
    joint.stiffness = {ContactStiffness::Kind::per_area, 2500 * 0.3 * std::pow(2 * std::numbers::pi * 25, 2)};
    Model model = make_model(Kinematics::planar_rigid, stone(), joint);
    hold(model, add_box(model, "floor", {-2, 0, -1}, {2, 1, 0}));
    add_box(model, "block", {-0.3, 0, 0}, {0.3, 1, 0.3});
    State state = initial_state(model);
    Stage stage = shaken(0.5, 2, 0.1);
    stage.control.time_step = 8e-3;
    stage.control.automatic = true;
    const RunReport report = run(model, {static_stage(0.1), stage}, state, {});
    ASSERT_FALSE(report.shorter_steps.empty());
    EXPECT_TRUE(report.shorter_steps.front().at_start);
    const std::vector<Stage> begun = as_begun({static_stage(0.1), stage}, report.shorter_steps);
    EXPECT_LE(begun[1].control.time_step, 2e-3);
    EXPECT_GE(begun[1].control.time_step, 1e-3);
}

}  // namespace voussoir::testing
