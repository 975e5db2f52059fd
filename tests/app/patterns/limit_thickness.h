// The thickness at which a pattern ceases to stand, by linear programming, and what the engine says on both sides
// of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/studies/verify/limit_masonry.h"
#include "app/studies/verify/references/limit_analysis.h"
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

/// Expects the engine to agree 0.4 % beside the least thickness of the linear program, which is found to 0.1 %.
/// @param entry of a thickness [m]; @param falls, stands_at thicknesses that certainly do
inline void expect_limit_thickness(const std::function<std::string(double)>& entry, double falls, double stands_at)
{
    using studies::verify::limit_problem;
    const auto by_program = [&](double thickness) {
        const auto limit = studies::verify::references::associated_limit(
            limit_problem(read_pattern(entry(thickness), under_own_weight).model));
        // On the verge, rounding may find an equilibrium that bears no load beside the weight.
        return limit.found && limit.factor > 1e-6;
    };
    ASSERT_TRUE(by_program(stands_at));
    ASSERT_FALSE(by_program(falls));
    while (stands_at / falls > 1.001) {
        const double middle = (stands_at + falls) / 2;
        (by_program(middle) ? stands_at : falls) = middle;
    }
    EXPECT_TRUE(stands(entry(stands_at * 1.004))) << stands_at;
    EXPECT_FALSE(stands(entry(falls * 0.996))) << falls;
}

}  // namespace voussoir::app::patterns_test
