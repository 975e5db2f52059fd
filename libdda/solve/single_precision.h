// Blocks of a preconditioner in single precision. What a preconditioner of a large scene takes its time for is
// reading its blocks from memory, and an iteration that corrects itself needs no more than their first digits.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voussoir::solve
{

/// Square blocks of N x N one after the other, each column major, and products with them column by column, which
/// vectorise. Source: docs/numerics.md 3.
template <int N>
struct SinglePrecision {
    static constexpr int size = N * N;
    static constexpr int width =
        (N + 3) / 4 * 4;                        // behind a column's N numbers a product takes some that come after
    using Sum = Eigen::Array<float, width, 1>;  // of which the first N count
    using Segment = Eigen::Map<Eigen::Array<float, N, 1>>;

    /// Makes room for so many blocks.
    static void resize(std::size_t blocks, std::vector<float>& all) { all.resize(blocks * size + width); }

    template <class Square>
    static void put(const Square& block, std::size_t position, std::vector<float>& all)
    {
        Eigen::Map<Eigen::Matrix<float, N, N>>(all.data() + position * size) = block.template cast<float>();
    }

    /// Block times x, N numbers.
    template <class Real>
    static Sum product(const std::vector<float>& all, std::size_t position, const Real* x)
    {
        const float* column = all.data() + position * size;
        // Two sums, for one would wait for itself.
        Sum even = Eigen::Map<const Sum>(column) * static_cast<float>(x[0]);
        Sum odd = Eigen::Map<const Sum>(column + N) * static_cast<float>(x[1]);
        for (int k = 2; k < N; ++k)
            (k % 2 == 0 ? even : odd) += Eigen::Map<const Sum>(column + N * k) * static_cast<float>(x[k]);
        return even + odd;
    }
};

}  // namespace voussoir::solve
