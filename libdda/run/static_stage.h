// A stage in which the structure comes to rest.
#pragma once

#include "libdda/run/progress.h"

namespace voussoir::driver
{

/// The second way of a static stage has so many times the increments of gravity that the stage has, and may take
/// so many times the steps in each, for they are short.
constexpr int most_times_the_increments = 4, most_times_the_steps = 10;

/// Looks for rest, and for a verdict that two ways of three agree on: steps as the stage has them, shorter ones
/// with the weight in increments, limit analysis. A fall is believed where limit analysis finds that nothing
/// balances the stones, a rest that was reached straight as it is; all else is confirmed by the second way.
/// @returns false when the run ends in this stage
bool run_static(const Stage& stage, RunProgress& progress);

}  // namespace voussoir::driver
