// How a cluster of blocks that moves as one block moves each of them.
#pragma once

#include <Eigen/Core>

namespace voussoir::solve
{

/// How a cluster that moves as one block with its centre at lever -y moves one of its blocks: P = [1, S; 0, 1].
template <int D>
struct RigidShape {
    static constexpr int dimension = D, unknowns = D == 3 ? 6 : 3, spins = unknowns - D;
    using Lever = Eigen::Matrix<double, D, 1>;

    static Eigen::Matrix<double, D, spins> turned(const Lever& y)
    {
        Eigen::Matrix<double, D, spins> s;
        if constexpr (D == 3)
            s << 0, y[2], -y[1], -y[2], 0, y[0], y[1], -y[0], 0;
        else
            s << -y[1], y[0];
        return s;
    }
    /// b = b P
    template <class Block>
    static void right(const Lever& y, Block& b)
    {
        b.template rightCols<spins>() += b.template leftCols<D>().lazyProduct(turned(y));
    }
    /// c = P^T c
    template <class Block>
    static void left(const Lever& y, Block& c)
    {
        c.template bottomRows<spins>() += turned(y).transpose().lazyProduct(c.template topRows<D>());
    }
    /// c = P c
    template <class Segment>
    static void spread(const Lever& y, Segment& c)
    {
        c.template head<D>() += turned(y).lazyProduct(c.template tail<spins>());
    }

    /// left() and spread() of a segment, quicker. Eigen rounds theirs in another way where it fuses products with
    /// sums, so that scenes of few stones keep theirs, and their bits.
    template <class Segment>
    static void left_quickly(const Lever& y, Segment& c)
    {
        if constexpr (D == 3) {
            c[3] += y[1] * c[2] - y[2] * c[1];
            c[4] += y[2] * c[0] - y[0] * c[2];
            c[5] += y[0] * c[1] - y[1] * c[0];
        } else {
            c[2] += y[0] * c[1] - y[1] * c[0];
        }
    }
    template <class Segment>
    static void spread_quickly(const Lever& y, Segment& c)
    {
        if constexpr (D == 3) {
            c[0] += y[2] * c[4] - y[1] * c[5];
            c[1] += y[0] * c[5] - y[2] * c[3];
            c[2] += y[1] * c[3] - y[0] * c[4];
        } else {
            c[0] -= y[1] * c[2];
            c[1] += y[0] * c[2];
        }
    }
};

/// The same with the nine (four) components of a gradient, column by column.
template <int D>
struct AffineShape {
    static constexpr int dimension = D, unknowns = D + D * D;
    using Lever = Eigen::Matrix<double, D, 1>;

    template <class Block>
    static void right(const Lever& y, Block& b)
    {
        for (int j = 0; j < D; ++j) b.template middleCols<D>(D + D * j) += y[j] * b.template leftCols<D>();
    }
    template <class Block>
    static void left(const Lever& y, Block& c)
    {
        for (int j = 0; j < D; ++j) c.template middleRows<D>(D + D * j) += y[j] * c.template topRows<D>();
    }
    template <class Segment>
    static void spread(const Lever& y, Segment& c)
    {
        for (int j = 0; j < D; ++j) c.template head<D>() += y[j] * c.template segment<D>(D + D * j);
    }
    template <class Segment>
    static void left_quickly(const Lever& y, Segment& c)
    {
        left(y, c);
    }
    template <class Segment>
    static void spread_quickly(const Lever& y, Segment& c)
    {
        spread(y, c);
    }
};

}  // namespace voussoir::solve
