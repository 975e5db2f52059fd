// How far blocks may go in a step, by which contacts are looked for.
#pragma once

#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::step
{

/// Radius of the vertices about the centroid of each block [m].
template <int D>
std::vector<double> radii_of(const Model& model);

/// How far each block may move within a step of length h [s]: its velocity, its spin, gravity, the ground under
/// it, how far its joints gape as drawn, and how far its bonds have stretched.
/// @param radii (blocks) [m] @param[out] reach (blocks) [m]
template <class K>
void find_reach(const Model& model, const Stage& stage, const State& state, double h,
                const std::vector<double>& radii, std::vector<double>& reach);

}  // namespace voussoir::step
