// Points of the mode chart, drawn from a seed over the papers' ranges.
#pragma once

#include <cstdint>
#include <vector>

#include "app/studies/verify/references/mode_chart.h"

namespace voussoir::app::studies::verify
{

/// A block on a slope under gravity and a horizontal force m g tan beta.
struct ChartCase {
    references::ChartPoint chart;
    double alpha = 0;  // rad, slope; beta = psi - alpha
};

enum class ChartKind {
    gravitational,  // alpha 14 to 50, phi 20 mostly, delta 11 to 50 degrees; beta = 0
    pseudo_static,  // alpha 10 mostly, delta 6 to 70, phi 6 to 80 degrees, psi up to 75 (not printed)
};

/// Half of the points (rounded up) lie within 1 degree of a boundary, none within 0.05 degree, by
/// `within_of_a_boundary`. "Mostly" is four of five; the others have alpha (phi) anywhere in 10 to 45 degrees.
std::vector<ChartCase> chart_points(ChartKind kind, int count, std::uint64_t seed);

}  // namespace voussoir::app::studies::verify
