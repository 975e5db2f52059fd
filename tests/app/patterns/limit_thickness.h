// The thickness, and the push, at which a pattern ceases to stand, by limit analysis, and what the engine says
// on both sides of it.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studies/verify/limit_masonry.h"
#include "libdda/limit/balance.h"
#include "libdda/limit/limit_factor.h"
#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{

/// Rigid stones under their own weight alone.
inline const std::vector<std::string> under_own_weight{"kinematics=spatial_rigid", "stages[1]=null"};

/// Whether the static stage of an entry comes to rest.
inline bool stands(const std::string& entry, std::vector<std::string> overrides = {})
{
    overrides.insert(overrides.end(), under_own_weight.begin(), under_own_weight.end());
    return run_to_rest(read_pattern(entry, overrides)).report.outcome == Outcome::completed;
}

/// Whether forces within friction balance the stones' own weight.
inline bool bears_itself(const limit::LimitProblem& problem)
{
    const limit::Standing standing = limit::balance_of(problem).standing;
    EXPECT_NE(standing, limit::Standing::unknown);
    return standing == limit::Standing::balanced;
}

/// Expects the engine to agree 0.4 % beside the least thickness of limit analysis, which is found to 0.1 %.
/// @param entry of a thickness, or of another measure that makes it safer; @param falls, stands_at such measures
/// that certainly do; @param overrides of the case
inline void expect_limit_thickness(const std::function<std::string(double)>& entry, double falls, double stands_at,
                                   const std::vector<std::string>& overrides = {})
{
    using studies::verify::limit_problem;
    std::vector<std::string> at_rest = overrides;
    at_rest.insert(at_rest.end(), under_own_weight.begin(), under_own_weight.end());
    const auto by_program = [&](double thickness) {
        return bears_itself(limit_problem(read_pattern(entry(thickness), at_rest).model));
    };
    ASSERT_TRUE(by_program(stands_at));
    ASSERT_FALSE(by_program(falls));
    while (stands_at / falls > 1.001) {
        const double middle = (stands_at + falls) / 2;
        (by_program(middle) ? stands_at : falls) = middle;
    }
    EXPECT_TRUE(stands(entry(stands_at * 1.004), overrides)) << stands_at;
    EXPECT_FALSE(stands(entry(falls * 0.996), overrides)) << falls;
}

/// Under the weight and `share` of it along x.
inline std::vector<std::string> pushed(double share)
{
    return {"gravity={direction: [" + std::to_string(share) + ", 0, -1]}"};
}

/// Expects the engine to stand 0.5 % below and to fall 0.5 % above the push along x, over the weight, at which the
/// limit analysis says that stones overturn. @param friction at which nothing slides [deg]
inline void expect_limit_push(const std::string& entry, const char* friction = "joints.dry.friction=75 deg")
{
    std::vector<std::string> overrides = under_own_weight;
    overrides.emplace_back(friction);
    const auto problem = studies::verify::limit_problem(read_pattern(entry, overrides).model);
    const std::optional<double> limit = limit::limit_factor(problem);
    ASSERT_TRUE(limit);
    for (const auto& [share, stays] : {std::pair(0.995, true), std::pair(1.005, false)}) {
        std::vector<std::string> push = pushed(share * *limit);
        push.emplace_back(friction);
        EXPECT_EQ(stands(entry, push), stays) << share << " of " << *limit;
    }
}

}  // namespace voussoir::app::patterns_test
