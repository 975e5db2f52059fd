// Kinetic damping as a rate, and dashpots in contacts.
#include <gtest/gtest.h>

#include <memory>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

class Damped : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Damped, every_kinematics(), test_name);

Model lone_block(Kinematics kinematics)
{
    Model model = make_model(kinematics, stone(), dry(30));
    add_box(model, "block", {-0.5, -0.4, -0.3}, {0.5, 0.4, 0.3});
    return model;
}

/// Speed ratio of a block that hits a held plane at 1 m/s without gravity, from `gap` above it.
double restitution(Kinematics kinematics, double damping_ratio, double omega_h, double gap)
{
    JointMaterial joint = dry(30);
    joint.stiffness = {ContactStiffness::Kind::per_area, 1e8};
    Model model = make_model(kinematics, stone(1e13), joint);
    hold(model, add_box(model, "plane", {-2, -2, -1}, {2, 2, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, gap}, {0.5, 0.5, 0.3 + gap});
    const double omega = std::sqrt(1e8 / model.mass(block));
    model.joints[0].relaxation_time = 2 * damping_ratio / omega;
    State state = initial_state(model);
    set_velocity(model, state, block, {0, 0, -1});
    Stage stage = dynamic_stage(gap + 10 / omega, omega_h / omega, Vector3d::Zero());
    const RunReport report = run_quietly(model, {stage}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_GT(report.energy.damping_contact, 0);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
    return velocity_of(kinematics, state, block).z();
}

}  // namespace

// v = v0 exp(-c t), whatever the step; spin alike.
TEST_P(Damped, RateSlowsAFreeFlightByItsExponential)
{
    const double rate = 2, duration = 0.7;
    for (const double h : {1e-3, 7e-3, 35e-3}) {
        const Model model = lone_block(GetParam());
        State state = initial_state(model);
        const Vector3d v0(3, is_planar(GetParam()) ? 0 : -1, 2);
        set_velocity(model, state, 0, v0, {0, 1.5, 0});
        Stage stage = dynamic_stage(duration, h, Vector3d::Zero());
        stage.damping.rate = rate;
        const double start = kinetic_energy(model, state);
        const RunReport report = run_quietly(model, {stage}, state);
        const double factor = std::exp(-rate * duration);
        EXPECT_LT((velocity_of(model.kinematics, state, 0) - factor * v0).norm(), 1e-12);
        EXPECT_NEAR(angular_velocity_of(model, state, 0).y(), 1.5 * factor, 1e-6);
        EXPECT_NEAR(report.energy.damping_kinetic, start * (1 - factor * factor), 1e-5 * start);
        EXPECT_LT(report.energy.relative_residual(), 1e-9);
        // Displacement: v0 (1 - exp(-c t)) / c up to the step in which each velocity still acts.
        EXPECT_NEAR(centroid(model, state, 0).x(), 3 * (1 - factor) / rate, 3 * rate * h * duration);
    }
}

// A fall that a rate slows: x = g / c (t - (1 - exp(-c t)) / c), whatever the step, from 10 ms to 10 us.
TEST_P(Damped, RateGivesTheSameWayAtEveryStep)
{
    const double rate = 1.5, duration = 0.8;
    const double exact = gravity / rate * (duration - (1 - std::exp(-rate * duration)) / rate);
    for (const double h : {1e-2, 1e-3, 1e-4, 1e-5}) {
        Model model = make_model(GetParam(), stone(), dry(30));
        add_box(model, "block", {0, 0, 0}, {1, 1, 1});
        State state = initial_state(model);
        Stage stage = dynamic_stage(duration, h);
        stage.damping.rate = rate;
        run_quietly(model, {stage}, state);
        EXPECT_NEAR(0.5 - centroid(model, state, 0).z(), exact, 0.01 * exact) << h;
    }
}

// The papers' factor per step depends on the step, which is why it is not the natural setting.
TEST_P(Damped, FactorPerStepIsAppliedOnceAStep)
{
    const Model model = lone_block(GetParam());
    State state = initial_state(model);
    set_velocity(model, state, 0, {3, 0, 0});
    Stage stage = dynamic_stage(0.01, 1e-3, Vector3d::Zero());
    stage.damping.factor_per_step = 0.97;
    run_quietly(model, {stage}, state);
    EXPECT_NEAR(velocity_of(model.kinematics, state, 0).x(), 3 * std::pow(0.97, 10), 1e-12);
}

// A free block in the air is dragged towards the ground's velocity, not towards rest.
TEST_P(Damped, IsRelativeToTheMovingGround)
{
    Model model = lone_block(GetParam());
    hold(model, add_box(model, "ground", {-5, -5, -10}, {5, 5, -9}));
    // After half a period of a sine of 2 m/s2 at 1 Hz the ground goes on at 2 a / w.
    const auto push = std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(2, 1, 0, 0.5));
    Stage stage = dynamic_stage(8, 5e-3, Vector3d::Zero());
    stage.motions = {{0, 0, push}};
    stage.damping.rate = 3;
    State state = initial_state(model);
    run_quietly(model, {stage}, state);
    const double ground = 4 / (2 * std::numbers::pi);
    EXPECT_NEAR(push->residual_velocity(), ground, 1e-12);
    EXPECT_NEAR(velocity_of(model.kinematics, state, 0).x(), ground, 1e-6);
    EXPECT_NEAR(velocity_of(model.kinematics, state, 1).x(), ground, 1e-12);
}

// Two supports that move apart: the block between them goes with the mean, whichever is written first.
TEST_P(Damped, IsRelativeToTheMeanOfSupportsThatMoveDifferently)
{
    Model model = lone_block(GetParam());
    hold(model, add_box(model, "left", {-5, -5, -10}, {0, 5, -9}));
    hold(model, add_box(model, "right", {1, -5, -10}, {5, 5, -9}));
    const auto fast = std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(2, 1, 0, 0.5));
    const auto slow = std::make_shared<GroundMotion>(fast->scaled(-0.5));
    for (const bool fast_first : {true, false}) {
        Stage stage = dynamic_stage(8, 5e-3, Vector3d::Zero());
        stage.motions = {{0, 0, fast}, {1, 0, slow}};
        if (!fast_first) std::swap(stage.motions[0], stage.motions[1]);
        stage.damping.rate = 3;
        State state = initial_state(model);
        run_quietly(model, {stage}, state);
        EXPECT_NEAR(velocity_of(model.kinematics, state, 0).x(), 0.25 * fast->residual_velocity(), 1e-6);
    }
}

// One support stands still and another one moves: half of it, and rest where nothing has a motion.
TEST_P(Damped, CountsASupportThatStandsStill)
{
    Model model = lone_block(GetParam());
    hold(model, add_box(model, "left", {-5, -5, -10}, {0, 5, -9}));
    hold(model, add_box(model, "right", {1, -5, -10}, {5, 5, -9}));
    const auto push = std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(2, 1, 0, 0.5));
    Stage stage = dynamic_stage(8, 5e-3, Vector3d::Zero());
    stage.motions = {{1, 0, push}};
    stage.damping.rate = 3;
    State state = initial_state(model);
    run_quietly(model, {stage}, state);
    EXPECT_NEAR(velocity_of(model.kinematics, state, 0).x(), 0.5 * push->residual_velocity(), 1e-6);
}

// e = exp(-pi xi / sqrt(1 - xi^2)) for N = <-k (g + eta dg/dt)>, xi = eta omega / 2; Newmark's own loss adds omega
// h / 4 to xi. Where the contact was found, the block being still in the air, must not matter.
TEST_P(Damped, DashpotGivesTheRestitutionOfItsRatio)
{
    for (const double xi : {0.1, 0.3, 0.6})
        for (const double gap : {0.01, 0.1}) {
            const double e = restitution(GetParam(), xi, 0.02, gap), whole = xi + 0.02 / 4;
            const double exact = std::exp(-std::numbers::pi * whole / std::sqrt(1 - whole * whole));
            std::printf("dashpot xi = %.1f, found %.2f m above: e = %.4f, closed form %.4f\n", xi, gap, e, exact);
            EXPECT_NEAR(e, exact, 0.02 * exact);
        }
}

TEST_P(Damped, DashpotOfTheCriticalRatioLetsNothingRebound)
{
    EXPECT_NEAR(restitution(GetParam(), 1.1, 0.02, 0.01), 0, 1e-3);
}

// A block on its edge turns about it freely: the corners in the air have no dashpot.
TEST_P(Damped, DashpotDoesNotHoldCornersInTheAir)
{
    const auto fall = [&](double dashpot) {
        JointMaterial joint = dry(60);
        joint.relaxation_time = dashpot;
        joint.stiffness = {ContactStiffness::Kind::per_area, 1e10};
        Model model = make_model(GetParam(), stone(1e11), joint);
        hold(model, add_box(model, "plane", {-3, -3, -1}, {3, 3, 0}));
        const int block = add_box(model, "block", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
        State state = initial_state(model);
        const double tilt = 0.2, low = 0.5 * (std::sin(tilt) + std::cos(tilt));
        set_pose(model, state, block, {0, 0, low}, turned(tilt, Vector3d::UnitY()));
        run_quietly(model, {dynamic_stage(0.15, 1e-3)}, state);
        return angular_velocity_of(model, state, block).y();
    };
    const double free_fall = fall(0), damped = fall(1e-2);
    EXPECT_GT(std::abs(free_fall), 0.3);
    EXPECT_NEAR(damped, free_fall, 0.03 * std::abs(free_fall));
}

}  // namespace voussoir::testing
