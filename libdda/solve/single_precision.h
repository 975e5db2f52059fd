// Blocks of a preconditioner in single precision. What a preconditioner of a large scene takes its time for is
// reading its blocks from memory, and an iteration that corrects itself needs no more than their first digits.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace voussoir::solve
{

/// Square blocks of N x N one after the other, each column major, and products with them column by column, which
/// vectorise. Source: docs/numerics.md 3.
template <int N>
struct SinglePrecision {
    static constexpr int size = N * N;
    static constexpr int fours = (N + 3) / 4;
    static constexpr int width = 4 * fours;     // behind a column's N numbers a product takes some that come after
    using Sum = Eigen::Array<float, width, 1>;  // of which the first N count
    using Segment = Eigen::Map<Eigen::Array<float, N, 1>>;

    /// What fills a factor fades from column to column, and processors take a hundred times as long for numbers
    /// below 1e-38 as for others. This is far below what counts, some 1e-8 at least, in SI units; the product of
    /// two such numbers is not below 1e-38.
    static constexpr float nothing = 1e-18F;
    /// The same of a vector, which fades from row to row far from a load.
    static constexpr float nothing_of_vector = 1e-30F;

    /// Makes room for so many blocks.
    static void resize(std::size_t blocks, std::vector<float>& all)
    {
        all.resize(blocks * size + width);
        std::fill(all.end() - width, all.end(), 0.0F);  // what a product takes of them must be a number
    }

    template <class Square>
    static void put(const Square& block, std::size_t position, std::vector<float>& all)
    {
        Eigen::Map<Eigen::Matrix<float, N, N>>(all.data() + position * size) = block.unaryExpr(
            [](double number) { return std::abs(number) < nothing ? 0.0F : static_cast<float>(number); });
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

    /// Four numbers that are worked on at once, by every instruction set of ours. The order of additions is the
    /// one written below, the same on any.
    typedef float Four __attribute__((vector_size(16)));  // NOLINT(modernize-use-using): g++ takes none there

    /// N numbers and zeros behind them, `width` in all.
    struct Packed {
        std::array<Four, fours> part;

        void operator-=(const Packed& other)
        {
            for (int c = 0; c < fours; ++c) part[c] -= other.part[c];
        }
    };
    static void read(const float* from, Packed& x) { std::memcpy(x.part.data(), from, sizeof(x.part)); }
    static void write(const Packed& x, float* to) { std::memcpy(to, x.part.data(), sizeof(x.part)); }

    /// y = A^T x of a block A. The scalar products of four columns are added up together: one after the other, as
    /// Eigen does it, each waits for its own sum.
    static void transposed_product(const std::vector<float>& all, std::size_t position, const Packed& x, Packed& y)
    {
        const float* block = all.data() + position * size;
        for (int c = 0; c < fours; ++c) {
            Four a{}, b{}, d{}, e{};
            multiply_column(block, 4 * c, x, a);
            multiply_column(block, 4 * c + 1, x, b);
            multiply_column(block, 4 * c + 2, x, d);
            multiply_column(block, 4 * c + 3, x, e);
            const Four front =
                __builtin_shufflevector(a, b, 0, 4, 1, 5) + __builtin_shufflevector(a, b, 2, 6, 3, 7);
            const Four back =
                __builtin_shufflevector(d, e, 0, 4, 1, 5) + __builtin_shufflevector(d, e, 2, 6, 3, 7);
            y.part[c] = __builtin_shufflevector(front, back, 0, 1, 4, 5) +
                        __builtin_shufflevector(front, back, 2, 3, 6, 7);
        }
    }

    static void leave_out_faint(float* x)
    {
        Eigen::Map<Sum> all(x);
        all = (all.abs() < nothing_of_vector).select(Sum::Zero(), all);
    }

    /// A block on its way into a factor, column by column; what lies behind the N numbers of each does not count.
    using Columns = std::array<Sum, N>;

    template <class Square>
    static void take(const Square& block, Columns& columns)
    {
        for (int c = 0; c < N; ++c) {
            columns[c].setZero();
            columns[c].template head<N>() = block.col(c).template cast<float>();
        }
    }

    /// from -= A B^T
    static void subtract_product(const float* a, const float* b, Columns& from)
    {
        for (int k = 0; k < N; ++k) {
            const Sum column = Eigen::Map<const Sum>(a + N * k);
            for (int c = 0; c < N; ++c) from[c] -= column * b[N * k + c];
        }
    }

    /// block = A L^T of a lower triangle L
    static void multiply_by_lower(const Columns& a, const float* lower, float* block)
    {
        for (int c = 0; c < N; ++c) {
            Sum column = a[0] * lower[c];
            for (int k = 1; k <= c; ++k) column += a[k] * lower[N * k + c];
            Segment(block + N * c) = (column.abs() < nothing).select(Sum::Zero(), column).template head<N>();
        }
    }

 private:
    /// Column k of a block with x, four products added up for four; nothing where there is no such column.
    static void multiply_column(const float* block, int k, const Packed& x, Four& sums)
    {
        if (k >= N) return;
        Four numbers;
        for (int c = 0; c < fours; ++c) {
            std::memcpy(&numbers, block + N * k + 4 * c, sizeof(numbers));
            sums += numbers * x.part[c];
        }
    }
};

}  // namespace voussoir::solve
