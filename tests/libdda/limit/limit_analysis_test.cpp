// Limit analysis against closed forms.
#include "libdda/limit/limit_analysis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "libdda/limit/linear_program.h"
#include "tests/libdda/limit/limit_problems.h"

namespace voussoir::limit
{

// It slides at mu and topples at width / height.
TEST(LimitAnalysis, BlockSlidesOrTopples)
{
    for (const bool planar : {true, false})
        for (const double friction : {0.1, 0.3, 0.5}) {
            const LimitProblem problem = block_on_base(friction, planar);
            const double exact = std::min(friction, width / height);
            EXPECT_NEAR(associated_limit(problem).factor, exact, 1e-7);
            EXPECT_NEAR(non_associated_limit(problem).factor, exact, 1e-6);
        }
}

// The cone of friction is round, whatever the direction of the load beside those of the contact.
TEST(LimitAnalysis, ConeIsRound)
{
    LimitProblem problem = block_on_base(0.2, false);
    for (const double angle : {0.0, 0.3, 1.1}) {
        problem.blocks[1].live = {std::cos(angle), std::sin(angle), 0};
        EXPECT_NEAR(associated_limit(problem).factor, 0.2, 1e-7);
    }
}

TEST(LimitAnalysis, ForcesBalanceTheLoads)
{
    const LimitProblem problem = block_on_base(0.5, false);
    const LimitState state = associated_limit(problem);
    Eigen::Vector3d sum = problem.blocks[1].dead + state.factor * problem.blocks[1].live;
    for (const Eigen::Vector3d& force : state.forces) sum += force;
    EXPECT_LT(sum.norm(), 1e-9);
    EXPECT_LT(state.beyond_friction, 1e-9);
}

// A stone that slides along a vertical joint between two that cannot give way: with dilatancy it is locked for
// good, the associated limit has no end. Drawn out of a cleft that opens by more than the angle of friction it is
// free: nothing but its weight holds it.
TEST(LimitAnalysis, CleftLocksADilatantStoneOnly)
{
    EXPECT_FALSE(associated_limit(stone_in_a_cleft(0.5, 0)).found);
    const double wide = std::atan(0.5) + 0.1;
    EXPECT_NEAR(associated_limit(stone_in_a_cleft(0.5, wide)).factor, 1, 1e-6);
}

TEST(LimitAnalysis, LinearProgram)
{
    LinearProgram program;  // greatest 3 x + 2 y with x + y <= 4, x + 3 y <= 6, x <= 3
    const int x = program.add_variable(3), y = program.add_variable(2);
    const double none = -1e30;
    const int sum = program.add_row({{x, 1}, {y, 1}}, none, 4);
    program.add_row({{x, 1}, {y, 3}}, none, 6);
    program.add_row({{x, 1}}, none, 3);
    ASSERT_TRUE(program.maximise());
    EXPECT_NEAR(program.greatest(), 11, 1e-9);
    program.set_upper(sum, 2);
    ASSERT_TRUE(program.maximise());
    EXPECT_NEAR(program.greatest(), 6, 1e-9);
    program.fix(x, 0);
    ASSERT_TRUE(program.maximise());
    EXPECT_NEAR(program.value(y), 2, 1e-9);
    program.fix(x, 5);
    EXPECT_FALSE(program.maximise());  // x <= 3
    LinearProgram endless;
    endless.add_row({{endless.add_variable(1), 1}}, 0, 1e30);
    EXPECT_FALSE(endless.maximise());
}

// A block beyond the edge of what it stands on.
TEST(LimitAnalysis, BlocksThatCannotStandHaveNoLimit)
{
    LimitProblem problem = block_on_base(0.5, true);
    problem.blocks[1].centroid.x() = 0.6 * width;
    EXPECT_FALSE(associated_limit(problem).found);
    EXPECT_FALSE(non_associated_limit(problem).found);
}

}  // namespace voussoir::limit
