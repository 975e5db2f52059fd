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

ColumnsOf columns_of(const BlockMatrix& pattern)
{
    ColumnsOf result;
    result.start.assign(pattern.rows() + 1, 0);
    const auto below = [&](auto&& visit) {
        for (int i = 0; i < pattern.rows(); ++i)
            for (int p = pattern.row_start[i]; p < pattern.diagonal(i); ++p) visit(i, p);
    };
    below([&](int, int p) { ++result.start[pattern.columns[p] + 1]; });
    for (int j = 0; j < pattern.rows(); ++j) result.start[j + 1] += result.start[j];
    result.rows.resize(result.start.back());
    result.positions.resize(result.start.back());
    std::vector<int> place(result.start.begin(), result.start.end() - 1);
    below([&](int i, int p) {
        int& at = place[pattern.columns[p]];
        result.rows[at] = i;
        result.positions[at++] = p;
    });
    return result;
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
