// Products and incomplete factors of block matrices.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "libdda/solve/block_matrix.h"

namespace voussoir::solve
{

/// The kernels of the iteration for one block size, so that the compiler unrolls them.
template <int N>
struct Kernels {
    using Square = Eigen::Matrix<double, N, N>;
    using Segment = Eigen::Matrix<double, N, 1>;
    using ConstBlock = Eigen::Map<const Square>;
    using Block = Eigen::Map<Square>;

    static ConstBlock block(const BlockMatrix& m, int position) { return ConstBlock(m.block(position)); }

    // lazyProduct: at these sizes the unrolled product beats the packing of the general one.
    static void multiply(const BlockMatrix& m, const Eigen::VectorXd& x, Eigen::VectorXd& y)
    {
        y.setZero();
        for (int i = 0; i < m.rows(); ++i) {
            const Segment xi = x.segment<N>(N * i);
            Segment sum = block(m, m.diagonal(i)).lazyProduct(xi);
            for (int p = m.row_start[i]; p < m.diagonal(i); ++p) {
                const int j = m.columns[p];
                const ConstBlock a = block(m, p);
                sum += a.lazyProduct(x.segment<N>(N * j));
                y.segment<N>(N * j) += a.transpose().lazyProduct(xi);
            }
            y.segment<N>(N * i) += sum;
        }
    }

    /// Rows first ... end of the same product, to the same bits: each row collects what multiply() sends to it.
    static void multiply_rows(const BlockMatrix& m, const ColumnsOf& columns, int first, int end,
                              const Eigen::VectorXd& x, Eigen::VectorXd& y)
    {
        for (int i = first; i < end; ++i) {
            Segment sum = block(m, m.diagonal(i)).lazyProduct(x.segment<N>(N * i));
            for (int p = m.row_start[i]; p < m.diagonal(i); ++p)
                sum += block(m, p).lazyProduct(x.segment<N>(N * m.columns[p]));
            for (int k = columns.start[i]; k < columns.start[i + 1]; ++k)
                sum += block(m, columns.positions[k]).transpose().lazyProduct(x.segment<N>(N * columns.rows[k]));
            y.segment<N>(N * i) = sum;
        }
    }

    /// L with L L^T = A on the pattern of A: L_ij = (A_ij - sum_k L_ik L_jk^T) L_jj^-T. The inverse of each
    /// diagonal block is stored in its place. A diagonal block that loses definiteness by the dropped fill keeps
    /// the factor of A_ii alone.
    static void factorise(const BlockMatrix& a, BlockMatrix& l)
    {
        l.values = a.values;
        for (int i = 0; i < a.rows(); ++i) factorise_row(block(a, a.diagonal(i)), i, l);
    }

    /// One row of it, which holds that of A before. @param own diagonal block of A
    static void factorise_row(const ConstBlock& own, int i, BlockMatrix& l)
    {
        Square diagonal = own;
        for (int p = l.row_start[i]; p < l.diagonal(i); ++p) {
            const int j = l.columns[p];
            Square sum = block(l, p);
            subtract_common(l, i, p, j, sum);
            const Square lij = sum.lazyProduct(block(l, l.diagonal(j)).transpose());
            Block(l.block(p)) = lij;
            diagonal -= lij.lazyProduct(lij.transpose());
        }
        Eigen::LLT<Square> cholesky(diagonal);
        if (cholesky.info() != Eigen::Success) cholesky.compute(own);
        Block(l.block(l.diagonal(i))) = inverse_of_lower(cholesky.matrixLLT());
    }

    /// L^-1 row by row, kept as columns of its transpose so that whole columns are combined at a time.
    static Square inverse_of_lower(const Square& l)
    {
        Square transposed = Square::Identity();
        for (int i = 0; i < N; ++i) {
            for (int k = 0; k < i; ++k) transposed.col(i) -= l(i, k) * transposed.col(k);
            transposed.col(i) /= l(i, i);
        }
        return transposed.transpose();
    }

    /// sum -= L_ik L_jk^T over the columns k < j that rows i and j share.
    static void subtract_common(const BlockMatrix& l, int i, int end_i, int j, Square& sum)
    {
        each_common_column(l, i, end_i, j,
                           [&](int p, int q) { sum -= block(l, p).lazyProduct(block(l, q).transpose()); });
    }

    /// z = (L L^T)^-1 r
    static void precondition(const BlockMatrix& l, const Eigen::VectorXd& r, Eigen::VectorXd& z)
    {
        z = r;
        forward(l, 0, l.rows(), z);
        for (int i = l.rows() - 1; i >= 0; --i) {
            const Segment known = z.segment<N>(N * i);
            const Segment zi = block(l, l.diagonal(i)).transpose().lazyProduct(known);
            z.segment<N>(N * i) = zi;
            for (int p = l.row_start[i]; p < l.diagonal(i); ++p)
                z.segment<N>(N * l.columns[p]) -= block(l, p).transpose().lazyProduct(zi);
        }
    }

    /// Rows first ... end of z = L^-1 z, all that they need of those before known.
    static void forward(const BlockMatrix& l, int first, int end, Eigen::VectorXd& z)
    {
        for (int i = first; i < end; ++i) {
            Segment sum = z.segment<N>(N * i);
            for (int p = l.row_start[i]; p < l.diagonal(i); ++p)
                sum -= block(l, p).lazyProduct(z.segment<N>(N * l.columns[p]));
            z.segment<N>(N * i) = block(l, l.diagonal(i)).lazyProduct(sum);
        }
    }
};

}  // namespace voussoir::solve
