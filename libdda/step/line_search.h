// How far an iteration goes along its direction.
#pragma once

#include "libdda/step/step_system.h"

namespace voussoir::step
{

/// How far to go along a direction.
struct Reach {
    double s = 1;
    bool at_hand = true;  // it was the last to be evaluated
};

/// Finds s in (0, 1] with slope(s) <= 0.5 |slope(0)|: regula falsi with bisection where it stalls, at most twelve
/// evaluations, then the end where the potential still falls.
/// @param slope_0 the unbalanced force along the direction at system.d, < 0 [J]; @param strict s with slope(s) <=
/// 0 instead
template <class K>
Reach line_search(double slope_0, FrictionBound bound, bool strict, int threads, StepSystem<K>& system);

}  // namespace voussoir::step
