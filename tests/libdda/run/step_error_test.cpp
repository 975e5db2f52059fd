// Steps that follow their error: the estimate, what steps it makes, and that a run goes on from a save as it was.
#include "libdda/run/step_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

using driver::mean_accelerations;
using driver::next_share;
using driver::step_error;
using Eigen::Vector3d;

namespace
{

class StepError : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, StepError, every_kinematics(), test_name);

constexpr double width = 1, height = 3, lean = 0.1;  // m, m, rad

/// A block that has been let go on one of its edges.
struct Rocking {
    Model model;
    State state;
    int block;

    explicit Rocking(Kinematics kinematics) : model(make_model(kinematics, stone(), dry(60)))
    {
        hold(model, add_box(model, "floor", {-3, -1, -1}, {3, 1, 0}));
        block = add_box(model, "block", {-width / 2, -0.5, 0}, {width / 2, 0.5, height});
        state = initial_state(model);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(lean, Vector3d::UnitY()).toRotationMatrix();
        const Vector3d edge(width / 2, 0, 0);
        set_pose(model, state, block, edge + turn * (Vector3d(0, 0, height / 2) - edge), turn);
    }
};

Stage followed(double duration, double time_step, double error)
{
    Stage stage = dynamic_stage(duration, time_step);
    stage.control.step_error = error;
    return stage;
}

constexpr double longest = 0.02, duration = 1.2;  // s

/// Where the block's centroid is at every nominal time [m].
std::vector<double> course(Kinematics kinematics, const Stage& stage, RunReport& report)
{
    Rocking scene(kinematics);
    scene.model.joints[0].face = FaceLaw::corners;  // the stiffer edge: its course is less a matter of chance
    std::vector<double> places;
    RunObserver observer;
    observer.every = longest;
    observer.frame = [&](const State& now, const RunReport&) {
        places.push_back(centroid(scene.model, now, scene.block).x());
    };
    report = run(scene.model, {stage}, scene.state, observer);
    return places;
}

double farthest(const std::vector<double>& one, const std::vector<double>& other)
{
    double most = one.size() == other.size() ? 0 : INFINITY;
    for (std::size_t i = 0; i < one.size() && i < other.size(); ++i)
        most = std::max(most, std::abs(one[i] - other[i]));
    return most;
}

}  // namespace

TEST_P(StepError, IsWhatAStepMakesOfAConstantJerk)
{
    const Model model = block_on_plane(GetParam(), 30);
    constexpr double jerk = 7, before = 0.01, h = 0.03;  // m/s3, s, s
    const auto at = [&](double t) {
        State state = initial_state(model);
        set_velocity(model, state, 1, {0.5 * jerk * t * t, 0, 0});
        return state;
    };
    const State start = at(0.2), middle = at(0.2 + before), end = at(0.2 + before + h);
    // q1 - q0 by the mean of the speeds, less the integral of the speed.
    const double t0 = 0.2 + before, t1 = t0 + h;
    const double exact = 0.5 * h * 0.5 * jerk * (t0 * t0 + t1 * t1) - jerk / 6 * (t1 * t1 * t1 - t0 * t0 * t0);
    EXPECT_NEAR(step_error(model, mean_accelerations(start, middle, before), before,
                           mean_accelerations(middle, end, h), h),
                exact, 1e-9 * exact);
}

TEST(StepErrorShare, IsTheCubeRootWithinItsBounds)
{
    EXPECT_NEAR(next_share(1e-4, 1e-4), 0.9, 1e-12);
    EXPECT_NEAR(next_share(8e-4, 1e-4), 0.45, 1e-12);
    EXPECT_EQ(next_share(0, 1e-4), 2);
    EXPECT_EQ(next_share(1, 1e-9), 0.2);
}

TEST_P(StepError, StonesAtRestTakeWholeSteps)
{
    const Model model = block_on_plane(GetParam(), 30);
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.01), followed(1, 0.02, 1e-6)}, state);
    EXPECT_EQ(report.refused_steps, 0);
    State fixed = initial_state(model);
    EXPECT_EQ(report.steps, run_quietly(model, {static_stage(0.01), dynamic_stage(1, 0.02)}, fixed).steps);
}

// A stone in space that is pushed to and fro, x = a / w^2 (w t - sin w t): nothing but the steps errs.
TEST_P(StepError, DecidesTheErrorOfTheRunAndItsSteps)
{
    constexpr double push = 40, frequency = 2, omega = 2 * std::numbers::pi * frequency;  // m/s2, Hz, 1/s
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "stone", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    std::vector<double> errors, steps;
    for (const double wanted : {1e-4, 1e-5, 1e-6}) {
        Stage stage = followed(1, 0.05, wanted);
        stage.gravity.setZero();
        stage.body_accelerations = {
            {0, 0, std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(push, frequency, 0, 1))}};
        State state = initial_state(model);
        errors.push_back(0);
        RunObserver observer;
        observer.step = [&](const State& now, const StepReport&, const RunReport&) {
            const double t = now.stage_time, x = push / (omega * omega) * (omega * t - std::sin(omega * t));
            errors.back() = std::max(errors.back(), std::abs(centroid(model, now, 0).x() - x));
        };
        const RunReport report = run(model, {stage}, state, observer);
        ASSERT_EQ(report.outcome, Outcome::completed);
        EXPECT_GT(report.refused_steps, 0);
        steps.push_back(static_cast<double>(report.steps));
        EXPECT_LT(static_cast<double>(report.refused_steps), 0.1 * steps.back())
            << "the next is found by the last";
        std::printf("  wanted %g m: %g m in %g steps, %d done again\n", wanted, errors.back(), steps.back(),
                    static_cast<int>(report.refused_steps));
        EXPECT_LT(errors.back(), wanted * steps.back());
    }
    // Of second order: a tenth of the error of a step is 2.15 times the steps and a 4.6th of the error of the run.
    for (const int i : {1, 2}) {
        EXPECT_NEAR(steps[i] / steps[i - 1], std::cbrt(10.0), 0.5);
        EXPECT_NEAR(errors[i - 1] / errors[i], std::pow(10.0, 2.0 / 3), 2);
    }
}

TEST(StepErrorOfARun, IsLessForTheStepsThatItTakes)
{
    RunReport followed_report, even_report;
    const std::vector<double> exact =
        course(Kinematics::planar_rigid, dynamic_stage(duration, 1e-4), followed_report);
    const std::vector<double> places =
        course(Kinematics::planar_rigid, followed(duration, longest, 1e-5), followed_report);
    const double h = duration / static_cast<double>(followed_report.steps + followed_report.refused_steps);
    const double even = longest / std::ceil(longest / h);  // no longer
    const std::vector<double> others =
        course(Kinematics::planar_rigid, dynamic_stage(duration, even), even_report);
    std::printf("  followed %g m, even %g m\n", farthest(places, exact), farthest(others, exact));
    EXPECT_LT(farthest(places, exact), farthest(others, exact));
}

TEST_P(StepError, GoesOnFromASaveAsIfItHadNotBeenStopped)
{
    const Stage stage = followed(duration, longest, 1e-5);
    Rocking whole(GetParam()), parted(GetParam());
    const RunReport undisturbed = run(whole.model, {stage}, whole.state, {});
    RunPosition position;
    int steps = 0;
    RunObserver observer;
    observer.stop = [&] { return ++steps == 40; };
    observer.save = [&](const State&, const RunPosition& at) { position = at; };
    ASSERT_EQ(run(parted.model, {stage}, parted.state, observer).outcome, Outcome::interrupted);
    position.report.outcome = Outcome::completed;
    position.report.diagnosis.reset();
    const RunReport rest = run(parted.model, {stage}, parted.state, {}, position);
    EXPECT_EQ(rest.steps, undisturbed.steps);
    EXPECT_EQ(hash_of(parted.state), hash_of(whole.state));
}

}  // namespace voussoir::testing
