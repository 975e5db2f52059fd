// What a scene of a thousand stones costs, in iterations: the same on every machine.
#include <gtest/gtest.h>

#include <string>

#include "tests/verification/program_run.h"

namespace voussoir::verification
{

namespace
{

ProgramRun run_house(const char* duration)
{
    return run_case(
        VOUSSOIR_CASES "/house_large.yaml",
        {"joints.dry.contact_stiffness=10 E/L", "stages[1].time_step=2 ms", "stages[1].force_tolerance=1e-5",
         std::string("stages[1].duration=") + duration, "output=null"});
}

}  // namespace

// Clusters of stones carry loads that would else go from stone to stone: 40 iterations of conjugate gradients
// each. Stones relaxed one by one find the states of their joints: 264 iterations without, and most of them short.
TEST(LargeScene, AHouseOf985RigidStonesComesToRestInFewIterations)
{
    const ProgramRun ran = run_house("2 ms");
    ASSERT_EQ(ran.status, 0);
    EXPECT_EQ(ran.word("outcome"), "completed");
    EXPECT_EQ(ran.figure("blocks"), 985);
    std::printf("house of 985 stones: %.0f open-close iterations, %.1f of conjugate gradients each\n",
                ran.figure("open_close_iterations"),
                ran.figure("linear_iterations") / ran.figure("open_close_iterations"));
    EXPECT_LT(ran.figure("open_close_iterations"), 60);
    EXPECT_LT(ran.figure("linear_iterations"), 25 * ran.figure("open_close_iterations"));
}

// In motion too: 25 iterations a step without, of which most are for the states of a few stones.
TEST(LargeScene, TheSameHouseIsShakenInFewIterationsAStep)
{
    const ProgramRun rested = run_house("2 ms"), shaken = run_house("0.1 s");
    ASSERT_EQ(rested.status, 0);
    ASSERT_EQ(shaken.status, 0);
    const auto between = [&](const char* figure) { return shaken.figure(figure) - rested.figure(figure); };
    EXPECT_EQ(shaken.figure("step_cuts"), 0);
    const double iterations = between("open_close_iterations") / between("steps");
    std::printf("house of 985 stones: %.1f open-close iterations a step\n", iterations);
    EXPECT_LT(iterations, 15);
}

}  // namespace voussoir::verification
