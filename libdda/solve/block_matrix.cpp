#include "libdda/solve/block_matrix.h"

#include <algorithm>

#include "libdda/errors.h"

namespace voussoir::solve
{

int BlockMatrix::position(int row, int column) const
{
    const auto first = columns.begin() + row_start[row], last = columns.begin() + row_start[row + 1];
    const auto found = std::lower_bound(first, last, column);
    DDA_ASSERT(found != last && *found == column);
    return static_cast<int>(found - columns.begin());
}

bool set_pattern(BlockMatrix& matrix, int block_size, int rows, std::vector<std::pair<int, int>>& pairs)
{
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<int> row_start{0}, columns;
    std::size_t next = 0;
    for (int row = 0; row < rows; ++row) {
        for (; next < pairs.size() && pairs[next].first == row; ++next) columns.push_back(pairs[next].second);
        columns.push_back(row);
        row_start.push_back(static_cast<int>(columns.size()));
    }
    const bool is_new =
        matrix.block_size != block_size || matrix.row_start != row_start || matrix.columns != columns;
    matrix.block_size = block_size;
    matrix.row_start = std::move(row_start);
    matrix.columns = std::move(columns);
    matrix.values.assign(matrix.columns.size() * block_size * block_size, 0.0);
    return is_new;
}

}  // namespace voussoir::solve
