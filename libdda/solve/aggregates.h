// Clusters of blocks that lie together: the large blocks of a coarse space.
#pragma once

#include <vector>

#include "libdda/solve/block_matrix.h"

namespace voussoir::solve
{

struct Aggregates {
    int count = 0;
    std::vector<int> of_row;  // 0 .. count - 1; -1: in none
};

/// Divides the rows of a pattern into connected aggregates of about `size` rows, as round as the pattern lets them
/// be, and numbers them so that neighbours have near numbers (Cuthill and McKee's order). The pattern alone
/// decides. Source: [CuthillMcKee1969].
/// @param takes_part (rows) which rows are wanted
Aggregates aggregate(const BlockMatrix& pattern, const std::vector<char>& takes_part, int size);

}  // namespace voussoir::solve
