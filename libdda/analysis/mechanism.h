// A mechanism: stones that go on moving though nothing gives them a push.
#pragma once

#include <vector>

#include "libdda/analysis/block_shifts.h"
#include "libdda/model/diagnosis.h"
#include "libdda/model/model.h"

namespace voussoir
{

/// Which stones a mechanism moves, the farthest first: those that moved at least a twentieth as far in the last
/// step as the one that moved farthest. How far a corner of each has gone since the stage began, and the direction
/// in which its centroid has.
/// @param stage index @param gone since the stage began @param last in its last step, in which something moved
Diagnosis mechanism_of(const Model& model, int stage, const std::vector<BlockShift>& gone,
                       const std::vector<BlockShift>& last);

}  // namespace voussoir
