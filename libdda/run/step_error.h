// The step that a wanted error allows.
#pragma once

#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::driver
{

/// Mean accelerations of the blocks over a step, (blocks x unknowns) in the units of State::velocities per second;
/// blows count as if they had lasted the whole of it. @param h s, from `before` to `after`
std::vector<double> mean_accelerations(const State& before, const State& after, double h);

/// By how much a step may have displaced a block wrongly, the worst of all [m]. A step takes the force as
/// constant: q1 = q0 + h v0 + h^2 a / 2 is wrong by h^3/12 of the rate of a, which two steps show, x''' = 2 (a1 -
/// a0) / (h0 + h1). Of a block that turns or stretches the points at its size from the centroid count.
/// @param earlier mean accelerations of the step before; empty: it was at rest
/// @param earlier_h s, of that step; @param h s
double step_error(const Model& model, const std::vector<double>& earlier, double earlier_h,
                  const std::vector<double>& accelerations, double h);

/// How much longer the next step may be, or this one when it is done again: the error grows with the third power
/// of it. Between 0.2 and 2.
double next_share(double error, double wanted);

}  // namespace voussoir::driver
