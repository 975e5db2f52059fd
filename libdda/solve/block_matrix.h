// The symmetric matrix of a step: one square block per block of the scene, and per pair in contact.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace voussoir::solve
{

/// Lower triangle by rows of square blocks, columns ascending, the diagonal block last in each row.
struct BlockMatrix {
    int block_size = 0;
    std::vector<int> row_start;  // (rows + 1)
    std::vector<int> columns;    // (blocks)
    std::vector<double> values;  // (blocks x block_size x block_size), each block column major

    int rows() const { return static_cast<int>(row_start.size()) - 1; }
    double* block(int position) { return values.data() + position * block_size * block_size; }
    const double* block(int position) const { return values.data() + position * block_size * block_size; }
    int diagonal(int row) const { return row_start[row + 1] - 1; }
    /// Position of block (row, column), row > column; it must exist.
    int position(int row, int column) const;
};

/// What of a pattern lies below the diagonal, by columns: rows ascending.
struct ColumnsOf {
    std::vector<int> start;      // (columns + 1)
    std::vector<int> rows;       // (blocks below the diagonal)
    std::vector<int> positions;  // of the same blocks in the matrix
};
ColumnsOf columns_of(const BlockMatrix& pattern);

/// Calls work(p, q) for the positions of the blocks that rows i and j have in the same column, columns ascending,
/// up to position `end_i` of row i and the diagonal of row j.
template <class Work>
void each_common_column(const BlockMatrix& m, int i, int end_i, int j, const Work& work)
{
    int q = m.row_start[j];
    const int end_j = m.diagonal(j);
    for (int p = m.row_start[i]; p < end_i; ++p) {
        while (q < end_j && m.columns[q] < m.columns[p]) ++q;
        if (q == end_j) return;
        if (m.columns[q] == m.columns[p]) work(p, q);
    }
}

/// Gives the matrix the pattern of `rows` diagonal blocks and the given pairs (row > column; any order, repeats
/// allowed), and sets it to zero. Returns whether the pattern is a new one.
bool set_pattern(BlockMatrix& matrix, int block_size, int rows, std::vector<std::pair<int, int>>& pairs);

}  // namespace voussoir::solve
