// How far blocks may go in a step, by which contacts are looked for.
#pragma once

#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::step
{

/// Of a block as drawn.
struct Extent {
    double radius = 0;  // m, of the vertices about the centroid
    double size = 0;    // m, of the block
};

/// Of all blocks.
template <int D>
std::vector<Extent> extents_of(const Model& model);

/// How far each block may move within a step of length h [s]: its velocity, its spin, gravity, the ground under
/// it, how far its joints gape as drawn, and how far its bonds have stretched.
/// @param extents (blocks) @param[out] reach (blocks) [m]
template <class K>
void find_reach(const Model& model, const Stage& stage, const State& state, double h,
                const std::vector<Extent>& extents, std::vector<double>& reach);

}  // namespace voussoir::step
