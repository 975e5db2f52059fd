// One way to rest.
#pragma once

#include "libdda/run/progress.h"

namespace voussoir::driver
{

/// Steps with the velocity set to zero after each, until the unbalanced force of every block is below the
/// tolerance in two steps running without change of contact state. Time does not pass. Stones that go on moving
/// are let go. Where a step is hard to make, or stones go far in it, it is asked whether forces within friction
/// balance them at all; if none do they are let go at once, in steps that follow their fall.
/// @returns false when the run ends on this way
bool search_rest(const Stage& stage, RunProgress& progress);

}  // namespace voussoir::driver
