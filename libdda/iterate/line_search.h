// How far an iteration goes along its direction: one rule for all stones and for a single one.
#pragma once

#include <algorithm>
#include <cmath>

#include "libdda/iterate/iteration_rules.h"

namespace voussoir::step
{

/// Shares of a direction between which the forces come to balance.
struct Reach {
    double low = 0, high = 1;  // the farthest at which they still drive on, the nearest at which they do not
    bool is_found = false;     // the one last evaluated will do; `low` and `high` are both that
};

/// Finds a share s of a direction at which what the forces do along it has halved: the whole of it where that will
/// do, else by regula falsi, with bisection where that stalls.
/// @param slope_0 R . direction where it begins, < 0 [J]; @param slope_at the same at s, which it moves to;
/// infinite where nothing may go
template <class Slope>
Reach line_search(double slope_0, const SearchRule& rule, const Slope& slope_at)
{
    const double enough = 0.5 * std::abs(slope_0);
    Reach reach;
    double slope_low = slope_0, slope_high = slope_at(reach.high);
    if (slope_high <= enough) return {1, 1, true};
    for (int evaluation = 1; evaluation < rule.most_evaluations; ++evaluation) {
        const double between = reach.high - reach.low;
        double s = reach.low - slope_low * between / (slope_high - slope_low);
        const bool is_small = std::min(s - reach.low, reach.high - s) < rule.least_part * between;
        if (is_small || evaluation % rule.halved_every == 0 || !std::isfinite(slope_high))
            s = 0.5 * (reach.low + reach.high);
        const double slope = slope_at(s);
        if (std::abs(slope) <= enough) return {s, s, true};
        (slope > 0 ? reach.high : reach.low) = s;
        (slope > 0 ? slope_high : slope_low) = slope;
    }
    return reach;
}

}  // namespace voussoir::step
