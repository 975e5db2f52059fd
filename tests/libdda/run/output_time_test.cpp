// What an observer takes for its output is told apart from what the computation takes.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

constexpr double pause = 0.02;  // s

void rest_a_little()
{
    std::this_thread::sleep_for(std::chrono::duration<double>(pause));
}

double output_seconds(const RunReport& report)
{
    return report.seconds[static_cast<int>(Part::output)];
}

/// Two static steps at least, and one frame of a dynamic stage.
RunReport observed(const RunObserver& observer)
{
    const Model model = block_on_plane(Kinematics::spatial_rigid, 30);
    State state = initial_state(model);
    return run(model, {static_stage(0.01), dynamic_stage(2e-3, 1e-3)}, state, observer);
}

}  // namespace

TEST(OutputTime, CountsFrames)
{
    int frames = 0;
    RunObserver observer;
    observer.every = 1;
    observer.frame = [&](const State&, const RunReport&) { ++frames, rest_a_little(); };
    const RunReport report = observed(observer);
    ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_EQ(frames, 3);
    EXPECT_GE(output_seconds(report), frames * pause);
}

TEST(OutputTime, CountsSaves)
{
    int saves = 0;
    RunObserver observer;
    observer.every = 1;
    observer.save = [&](const State&, const RunPosition&) { ++saves, rest_a_little(); };
    const RunReport report = observed(observer);
    EXPECT_GE(saves, 5) << "frames, and static steps";
    EXPECT_GE(output_seconds(report), saves * pause);
}

TEST(OutputTime, IsNothingWhereNothingIsAskedForAndNoPartOfOthers)
{
    RunObserver observer;
    observer.stop = [] { return rest_a_little(), false; };
    EXPECT_EQ(output_seconds(observed(observer)), 0);
}

}  // namespace voussoir::testing
