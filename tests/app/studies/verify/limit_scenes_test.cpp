// The first of the random structures at both sides of their limit; many_limit_scenes_test.cpp runs all.
#include "tests/app/studies/verify/scene_verdicts.h"

namespace voussoir::app::studies::verify
{

TEST(LimitScenes, StandBelowTheirLimitAndFallBeyond)
{
    VerdictCounts counts;
    for (int n = 0; n < 9; ++n)
        for (const bool rigid : {true, false})
            if (n != 4 || rigid) judge_scene(limit_scene_seed, n, rigid, {0.97, 1.01}, counts);
    EXPECT_GE(counts.sharp, 10);
    EXPECT_GE(counts.open, 1);
    EXPECT_EQ(counts.undecided, 0);
    EXPECT_EQ(counts.left_out, 0);
}

// Two ways to the same number: the mechanisms of the springs and the simplex method.
TEST(LimitScenes, HaveTheLimitOfTheLinearProgram)
{
    for (int n = 0; n < 25; ++n) {
        if (n % 5 == 4 && n != 14) continue;  // the linear programs of domes take a second each
        const limit::LimitProblem problem = limit_problem(limit_scene(limit_scene_seed, n, true).model);
        const double program = limit::associated_limit(problem).factor;
        EXPECT_NEAR(limit::limit_factor(problem).value_or(0), program, 1.5e-4 * program) << n;
    }
}

// What stones do that slide without opening, by springs and by linear programs.
TEST(LimitScenes, HaveTheLimitWithoutDilatancyOfTheLinearPrograms)
{
    int apart = 0;
    for (const int n : {0, 1, 6, 11, 21, 26}) {
        const limit::LimitProblem problem = limit_problem(limit_scene(limit_scene_seed, n, true).model);
        const double least = limit::non_associated_limit(problem, 5).factor,
                     most = limit::limit_factor(problem).value_or(0);
        EXPECT_EQ(limit::standing_without_dilatancy(pushed_problem(problem, 0.99 * least)),
                  limit::Standing::balanced)
            << n;
        EXPECT_EQ(limit::standing_without_dilatancy(pushed_problem(problem, 1.01 * least)),
                  limit::Standing::mechanism)
            << n;
        apart += least < 0.99 * most;
    }
    EXPECT_GE(apart, 2) << "of some scenes the two limits differ";
}

}  // namespace voussoir::app::studies::verify
