// How far blocks are within one another, against how thick they are.
#pragma once

#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Least width of every block over the directions of its faces [m]: the thickness of a slab, the shorter side of a
/// slender stone. Of glued parts the least.
std::vector<double> least_widths(const Model& model);

/// Keeps the deepest overlaps of the run in `report.deepest` and `report.max_penetration`.
/// A stone that slides over the edge of another is found on the side of that edge before it is above it, and goes
/// on within the step: where contact is a strip between an edge of either stone, the overlap is no deeper than the
/// strip is wide, for by that shift the stones would part.
/// @param widths least_widths(model)
void note_overlap(const Model& model, const std::vector<double>& widths, const State& state, RunReport& report);

}  // namespace voussoir
