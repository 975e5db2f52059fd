// The axis of a diagram: logarithmic or linear, with its ticks.
#pragma once

#include <vector>

namespace voussoir::app::plots
{

struct Tick {
    double value = 0;
    bool is_labelled = true;  // else short and without a line across the diagram
};

/// What an axis runs over.
struct Axis {
    bool logarithmic = true;
    double low = 0, high = 1;  // of the values, or of their common logarithms

    /// Place of a value, 0 at the low end and 1 at the high one.
    double share(double value) const;
};

/// Room for all values with a margin; a logarithmic axis has ticks at two powers of ten at least.
Axis axis_for(const std::vector<double>& values, bool logarithmic);

/// Powers of ten and what lies between; or 4 to 9 multiples of 1, 2 or 5 times a power of ten.
std::vector<Tick> ticks_of(const Axis& axis);

}  // namespace voussoir::app::plots
