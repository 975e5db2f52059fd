// Rock blocks that are too small, made part of a neighbour.
#pragma once

#include "importers/exact/joint_sets.h"

namespace voussoir::importers::exact
{

/// Makes each block smaller than `smallest` [m3] part of the neighbour with which it shares the largest area of
/// whole faces, the smallest block first; the faces between them are glued. A block that is still too small, for
/// it shares no whole face with another one, is left out. The order of the others stays.
void merge_small(double smallest, CutRock& rock);

/// Counts a block among those left out.
void leave_out(const RockBlock& block, CutRock& rock);

}  // namespace voussoir::importers::exact
