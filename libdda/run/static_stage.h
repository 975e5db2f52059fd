// A stage in which the structure comes to rest.
#pragma once

#include "libdda/run/progress.h"

namespace voussoir::driver
{

/// Steps with the velocity set to zero after each, until the unbalanced force of every block is below the
/// tolerance in two steps running without change of contact state. Time does not pass.
/// @returns false when the run ends in this stage
bool run_static(const Stage& stage, RunProgress& progress);

}  // namespace voussoir::driver
