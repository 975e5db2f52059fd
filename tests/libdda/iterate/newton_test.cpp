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
    Pushed pushed{static_cast<double>(shaken.open_close_iterations) / static_cast<double>(shaken.steps)};
    for (int b = 1; b < static_cast<int>(model.blocks.size()); ++b)
        pushed.drift = std::max(pushed.drift, (centroid(model, state, b) - centroid(model, before, b)).norm());
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
    EXPECT_LT(push(Kinematics::planar_rigid, 24, 46, 0.5, 0.144).iterations, 8);
}

}  // namespace voussoir::testing
