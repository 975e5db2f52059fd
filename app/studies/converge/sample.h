// The measures: what is compared of a recorded quantity.
#pragma once

#include <vector>

#include "app/studies/converge/estimate.h"
#include "app/studies/converge/recorder.h"

namespace voussoir::app::studies::converge
{

/// Of a history its values at `times`, linear between recorded steps (where a time is a step of the run, as on
/// nested grids, that is the value itself); of a peak its largest size and of an end its value, up to the last of
/// `times`.
/// @param times (n) rising [s], within the recording; at least one
/// @returns (3 x n), (1 x 1) for a peak, (3 x 1) for an end
Sample sample_of(const Quantity& quantity, const Recording& recording, const std::vector<double>& times);

/// The number that stands for a sample in a table: the end of a component with its sign, else the largest size.
double value_of(const Quantity& quantity, const Sample& sample);

}  // namespace voussoir::app::studies::converge
