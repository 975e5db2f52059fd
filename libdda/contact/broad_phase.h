// Which parts may touch within the step.
#pragma once

#include <utility>
#include <vector>

#include "libdda/contact/placed_part.h"

namespace voussoir::contact
{

/// Pairs of parts, and what finding them works on.
struct Candidates {
    std::vector<std::pair<int, int>> pairs;
    std::vector<int> order;
};

/// Pairs (i < j) of parts of different blocks whose bounding boxes, each grown by the reach of its block, overlap;
/// ascending. Pairs of two fully held blocks are left out. Sweep and prune along the longest axis.
/// @param reach (blocks) [m] how far a block may move in this step, plus the contact distance
template <int D>
void find_candidates(const std::vector<PlacedPartIn<D>>& parts, const std::vector<double>& reach,
                     const std::vector<bool>& fully_held, int threads, Candidates& candidates);

}  // namespace voussoir::contact
