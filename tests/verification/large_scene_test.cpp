// What a scene of a thousand stones costs, in iterations: the same on every machine.
#include <gtest/gtest.h>

#include "tests/verification/program_run.h"

namespace voussoir::verification
{

// Clusters of stones carry loads that would else go from stone to stone: 40 iterations of conjugate gradients
// each. Stones relaxed one by one find the states of their joints: 264 iterations without, and most of them short.
TEST(LargeScene, AHouseOf985RigidStonesComesToRestInFewIterations)
{
    const ProgramRun ran = run_case(VOUSSOIR_CASES "/house_large.yaml",
                                    {"kinematics=spatial_rigid", "stages[1].duration=2 ms", "output=null"});
    ASSERT_EQ(ran.status, 0);
    EXPECT_EQ(ran.word("outcome"), "completed");
    EXPECT_EQ(ran.figure("blocks"), 985);
    std::printf("house of 985 stones: %.0f open-close iterations, %.1f of conjugate gradients each\n",
                ran.figure("open_close_iterations"),
                ran.figure("linear_iterations") / ran.figure("open_close_iterations"));
    EXPECT_LT(ran.figure("open_close_iterations"), 60);
    EXPECT_LT(ran.figure("linear_iterations"), 25 * ran.figure("open_close_iterations"));
}

}  // namespace voussoir::verification
