// Parts of a structure that friction alone holds.
#pragma once

#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// The blocks of parts that bear on the rest by nothing but joints that have used up their friction, whether they
/// slide or turn: no chain of bars that carry, bonds and joints that stick joins them to the ground. What turns
/// about an edge and slides elsewhere is not among these, as long as the edge sticks.
/// @param least normal force [N] of a joint that is worth a look
/// @returns ascending
std::vector<int> held_by_sliding_joints(const Model& model, const State& state, double least);

}  // namespace voussoir
