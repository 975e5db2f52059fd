// The first of the random structures at both sides of their limit; many_limit_scenes_test.cpp runs all.
#include <ctime>

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

// The two sides of a limit are far apart in what is left over, and the iteration ends under any load.
TEST(LimitScenes, BalanceEndsUnderAnyLoadAndTellsTheSidesApart)
{
    double below = 0, beyond = 1;
    int most = 0;
    for (int n = 0; n < 30; ++n) {
        const limit::LimitProblem problem = limit_problem(limit_scene(limit_scene_seed, n, true).model);
        const double capacity = limit::limit_factor(problem).value_or(0);
        below = std::max(below, limit::balance_of(pushed_problem(problem, 0.99 * capacity)).acceleration);
        beyond = std::min(beyond, limit::balance_of(pushed_problem(problem, 1.01 * capacity)).acceleration);
        for (const double factor : {0.0, 0.5, 1.0, 1.5, 2.0, 4.0, 7.0, 20.0}) {
            const limit::Balance balance = limit::balance_of(pushed_problem(problem, factor));
            EXPECT_EQ(balance.standing, factor < capacity ? limit::Standing::balanced : limit::Standing::mechanism)
                << n << ": " << factor << " of " << capacity;
            most = std::max(most, balance.iterations);
        }
    }
    std::printf("left over 1 %% below the limit %.1e, 1 %% beyond %.1e; at most %d iterations\n", below, beyond,
                most);
    EXPECT_LT(below, 1e-6);
    EXPECT_GT(beyond, 1e-3);
    EXPECT_LE(most, 150);
}

// Two ways to the same number: the mechanisms of the springs and the simplex method.
TEST(LimitScenes, HaveTheLimitOfTheLinearProgram)
{
    for (int n = 0; n < 25; ++n) {
        if (n % 5 == 4 && n != 14) continue;  // the linear programs of domes take a second each
        const limit::LimitProblem problem = limit_problem(limit_scene(limit_scene_seed, n, true).model);
        std::clock_t start = std::clock();
        const double program = limit::associated_limit(problem).factor;
        const double by_program = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        start = std::clock();
        const double tolerance = problem.planar ? 2e-5 : 1.5e-4;  // the programs' own, of the cone in space
        EXPECT_NEAR(limit::limit_factor(problem).value_or(0), program, tolerance * program) << n;
        std::printf("%d: %zu blocks, program %.1f ms, springs %.1f ms\n", n, problem.blocks.size(), by_program,
                    1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
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
