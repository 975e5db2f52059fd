// The circle of a vault's intrados.
#pragma once

#include <cmath>
#include <vector>

#include "libdda/errors.h"

namespace voussoir::importers::patterns
{

/// Through both springings, at z = 0, and the crown above their middle.
struct CircularArc {
    double radius = 0;     // m
    double centre = 0;     // m, its level
    double springing = 0;  // rad, from the crown
};

inline CircularArc arc_over(double span, double rise)
{
    const double half = span / 2, radius = (half * half + rise * rise) / (2 * rise);
    return {radius, rise - radius, 2 * std::atan(rise / half)};
}

/// Adds faults unless 0 < rise <= span / 2.
void check_arc(double span, double rise, std::vector<Fault>& faults);

}  // namespace voussoir::importers::patterns
