// Cholesky factors of block matrices in single precision, row by row.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "libdda/solve/block_kernels.h"
#include "libdda/solve/block_matrix.h"
#include "libdda/solve/single_precision.h"

namespace voussoir::solve
{

/// Of each diagonal entry of a matrix so much at least must be left in its factor: what is left of the stiffness
/// of the softest motions is known to one in a hundred then, for 24 bits are 6e-8 of the whole.
constexpr double least_left = 1e-5;

/// L of L L^T = A, on a pattern that it is given with each call; the inverse of each diagonal block in its place.
/// As Kernels::factorise_row and precondition() in double precision, but that a diagonal block which loses its
/// definiteness ends the work. Source: docs/numerics.md 3.
template <int N>
class SingleFactor
{
    using Single = SinglePrecision<N>;

 public:
    static constexpr int width = Single::width;  // of a row's segment of a vector: N numbers and zeros

    void resize(const BlockMatrix& pattern) { Single::resize(pattern.columns.size(), blocks_); }

    /// A block made elsewhere.
    template <class Square>
    void put(const Square& block, int position)
    {
        Single::put(block, position, blocks_);
    }

    /// Row i, those before it that it meets known.
    /// @param take gives a block of A by its position in the pattern: take(position, Columns&)
    /// @returns what is left of a diagonal entry of A, the least part of one; 0: the row is not to be had
    template <class Take>
    double factorise_row(const BlockMatrix& pattern, int i, const Take& take)
    {
        typename Single::Columns own, sum;
        take(pattern.diagonal(i), own);
        Square whole;
        give(own, whole);
        for (int p = pattern.row_start[i]; p < pattern.diagonal(i); ++p) {
            const int j = pattern.columns[p];
            take(p, sum);
            each_common_column(pattern, i, p, j,
                               [&](int of_i, int of_j) { Single::subtract_product(at(of_i), at(of_j), sum); });
            Single::multiply_by_lower(sum, at(pattern.diagonal(j)), at(p));
            Single::subtract_product(at(p), at(p), own);
        }
        Square diagonal;
        give(own, diagonal);
        const Eigen::LLT<Square> cholesky(diagonal);
        if (cholesky.info() != Eigen::Success || !diagonal.allFinite()) return 0;
        put(Kernels<N>::inverse_of_lower(cholesky.matrixLLT()), pattern.diagonal(i));
        return (cholesky.matrixLLT().diagonal().array().square() / whole.diagonal().array()).minCoeff();
    }

    /// Segment i of x = L^-1 b, those before it known.
    /// @param b N numbers; @param x `width` numbers a segment, zeros behind N of them
    template <class Segment>
    void forward(const BlockMatrix& pattern, int i, const Segment& b, float* x) const
    {
        typename Single::Sum sum = Single::Sum::Zero();
        sum.template head<N>() = b.template cast<float>();
        for (int p = pattern.row_start[i]; p < pattern.diagonal(i); ++p)
            sum -= Single::product(blocks_, p, x + width * pattern.columns[p]);
        typename Single::Segment(x + width * i) =
            Single::product(blocks_, pattern.diagonal(i), sum.data()).template head<N>();
        Single::leave_out_faint(x + width * i);
    }

    /// Segment i of x = L^-T x, those behind it known. @param below the columns of the pattern
    void backward(const BlockMatrix& pattern, const ColumnsOf& below, int i, float* x) const
    {
        typename Single::Packed own, other, product;
        Single::read(x + width * i, own);
        for (int k = below.start[i + 1] - 1; k >= below.start[i]; --k) {
            Single::read(x + width * below.rows[k], other);
            Single::transposed_product(blocks_, below.positions[k], other, product);
            own -= product;
        }
        Single::transposed_product(blocks_, pattern.diagonal(i), own, product);
        Single::write(product, x + width * i);
        Single::leave_out_faint(x + width * i);
    }

    /// Of all positions of the pattern, one after the other, and some numbers behind them.
    const std::vector<float>& blocks() const { return blocks_; }

 private:
    using Square = typename Kernels<N>::Square;

    float* at(int position) { return blocks_.data() + static_cast<std::size_t>(position) * Single::size; }

    static void give(const typename Single::Columns& columns, Square& block)
    {
        for (int c = 0; c < N; ++c) block.col(c) = columns[c].template head<N>().matrix().template cast<double>();
    }

    std::vector<float> blocks_;
};

}  // namespace voussoir::solve
