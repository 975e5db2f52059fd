// A thrown cube whose corners meet a table by impulses alone: Moreau's time stepping with steps so short that they
// do not matter. It knows nothing of the engine: what it gets wrong, the law of impact and friction gets wrong.
#pragma once

#include "tests/verification/experiments/thrown_cube.h"

namespace voussoir::verification
{

/// @param step [s]
TrackedMotion cube_by_impulses(const Toss& toss, const CubeSetting& setting, double step);

}  // namespace voussoir::verification
