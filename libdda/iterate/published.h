// The open-close iteration as published: springs are added and removed, friction of sliding points is a load of
// the pass before, and when six passes do not settle the step is cut. Kept for comparison with the papers' tables.
// Source: [Shi1988], chapter 4; an emulation on our contact polygons, not Shi's code.
#pragma once

#include "libdda/iterate/directions.h"

namespace voussoir::step
{

/// Shi's open-close iteration: solve, switch springs, repeat until no spring switches, six times at most.
template <class K>
bool iterate_published(StepProblem<K>& problem, Directions<K>& directions, StepReport& report);

}  // namespace voussoir::step
