// What a step of a large wall costs, in iterations: the same on every machine.
#include "libdda/iterate/newton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

struct Pushed {
    double iterations = 0;  // a step
    double drift = 0;       // m, the farthest
    RunReport rested, shaken;
};

/// A running bond that is brought to rest and pushed in its plane at 2 Hz, in steps of 8 ms, of which none is cut.
/// @param share of gravity, the largest acceleration; @param duration s
Pushed push(Kinematics kinematics, int courses, int stones, double share, double duration)
{
    Model model = running_bond(kinematics, courses, stones);
    State state = initial_state(model);
    Stage motion = dynamic_stage(duration, 8e-3);
    const auto push =
        std::make_shared<const GroundMotion>(GroundMotion::sine_acceleration(share * gravity, 2, 0, 1));
    for (int b = 1; b < static_cast<int>(model.blocks.size()); ++b)
        motion.body_accelerations.push_back({b, 0, push});
    const RunReport rested = run_quietly(model, {static_stage(1)}, state);
    EXPECT_EQ(rested.outcome, Outcome::completed);
    begin_stage(model, 0, state);
    const State before = state;
    const RunReport shaken = run_quietly(model, {motion}, state);
    EXPECT_EQ(shaken.outcome, Outcome::completed);
    EXPECT_EQ(shaken.step_cuts, 0);
    EXPECT_EQ(shaken.steps, std::lround(duration / motion.control.time_step));
    Pushed pushed;
    pushed.iterations = static_cast<double>(shaken.open_close_iterations) / static_cast<double>(shaken.steps);
    for (int b = 1; b < static_cast<int>(model.blocks.size()); ++b)
        pushed.drift = std::max(pushed.drift, (centroid(model, state, b) - centroid(model, before, b)).norm());
    pushed.rested = rested;
    pushed.shaken = shaken;
    std::printf("%zu stones: %.2f iterations a step, drift %.2g mm\n", model.blocks.size(), pushed.iterations,
                1e3 * pushed.drift);
    return pushed;
}

}  // namespace

// By less than its friction and its width can take, so that nothing may move.
TEST(Newton, TwentyTimesTheStonesTakeHardlyMoreIterationsAStep)
{
    const Pushed small = push(Kinematics::spatial_rigid, 8, 12, 0.3, 0.2);
    const Pushed large = push(Kinematics::spatial_rigid, 32, 62, 0.3, 0.2);
    EXPECT_LT(small.iterations, 4);
    EXPECT_LT(large.iterations, 5);
    EXPECT_LT(small.drift, 5e-5);
    EXPECT_LT(large.drift, 2e-4);
}

// By more than friction can take: joints slide in many places at once.
TEST(Newton, ALargeWallThatSlidesTakesFewIterationsAStep)
{
    EXPECT_LT(push(Kinematics::planar_rigid, 24, 46, 0.5, 0.144).iterations, 8.5);
}

TEST(Newton, TheReportCountsWhatActed)
{
    const Pushed wall = push(Kinematics::planar_rigid, 8, 12, 0.5, 0.144);
    const IterationCounts &of_rest = wall.rested.acted, &of_motion = wall.shaken.acted;
    EXPECT_GT(of_rest.relaxed, 0);
    EXPECT_EQ(of_rest.whole_tangents, 0) << "on the way to rest it may lead to another equilibrium";
    EXPECT_GT(of_motion.relaxed, 0);
    EXPECT_GT(of_motion.whole_tangents, 0);
    EXPECT_GT(of_motion.shortened, 0);
    for (const RunReport& report : {wall.rested, wall.shaken})
        for (const std::int64_t times :
             {report.acted.relaxed, report.acted.whole_tangents, report.acted.shortened})
            EXPECT_LE(times, report.open_close_iterations);
}

// What does not act costs nothing and is not counted.
TEST(Newton, NothingButTheGuessActsOnABlockThatLies)
{
    Model model = block_on_plane(Kinematics::spatial_rigid, 30);
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(1), dynamic_stage(0.05, 1e-3)}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_GT(report.open_close_iterations, 0);
    const IterationCounts& acted = report.acted;
    EXPECT_EQ(acted.relaxed + acted.whole_tangents + acted.shortened, 0);
}

}  // namespace voussoir::testing
