// What the static stages of random walls and arches say beside limit analysis.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>

#include "app/studies/verify/limit_masonry.h"
#include "libdda/limit/limit_analysis.h"

namespace voussoir::app::studies::verify
{

/// How many of the scenes have one limit, how many an interval of them, and what all runs cost.
struct LimitCounts {
    int sharp = 0, wide = 0;
    std::int64_t standing = 0, falling = 0;  // iterations
};

/// Pushes the n-th scene with 0.3 % less than the non-associated limit and with 0.3 % more than the associated
/// one: it stands and falls. Where the two limits are the same to 0.3 % the verdict is right outside 0.3 % of
/// them, where they differ the threshold lies between them within 0.3 %.
inline void judge_verdicts(std::uint64_t seed, int n, LimitCounts& counts)
{
    constexpr double margin = 3e-3;
    const LimitMasonry masonry = random_masonry(seed, n);
    // What balances a prism in its plane does so in space; there are more states in space to search through.
    const limit::LimitProblem problem = limit_problem(random_masonry(seed, n, true).model);
    const limit::LimitState most = limit::associated_limit(problem);
    const limit::LimitState least = limit::non_associated_limit(problem);
    ASSERT_TRUE(most.found && least.found) << n << ": " << masonry.description;
    ASSERT_GT(least.factor, 0) << n << ": " << masonry.description;
    EXPECT_LE(least.factor, most.factor * 1.001) << n << ": " << masonry.description;
    const bool sharp = least.factor > (1 - margin) * most.factor;
    ++(sharp ? counts.sharp : counts.wide);
    const Pushed below = push(masonry.model, (1 - margin) * least.factor);
    const Pushed above = push(masonry.model, (1 + margin) * most.factor);
    EXPECT_EQ(below.report.outcome, Outcome::completed)
        << n << ": " << masonry.description << ", limits " << least.factor << " and " << most.factor;
    EXPECT_EQ(above.report.outcome, Outcome::collapsed)
        << n << ": " << masonry.description << ", limits " << least.factor << " and " << most.factor;
    EXPECT_TRUE(above.report.diagnosis && !above.report.diagnosis->blocks.empty())
        << n << ": " << masonry.description << " names no stone that falls";
    counts.standing += below.report.open_close_iterations;
    counts.falling += above.report.open_close_iterations;
    std::printf("%3d limits %.5f %.5f, stands for %.4f s, falls for %.4f s of CPU: %s\n", n, least.factor,
                most.factor, below.cpu_time, above.cpu_time, masonry.description.c_str());
}

}  // namespace voussoir::app::studies::verify
