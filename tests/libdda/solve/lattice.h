// Matrices of walls of blocks on springs.
#pragma once

#include "libdda/block/kinematics_traits.h"
#include "libdda/solve/block_matrix.h"
#include "libdda/solve/row_places.h"
#include "tests/libdda/poses.h"

namespace voussoir::testing
{

using Eigen::VectorXd;

/// A lattice of unit cubes (squares) on springs at the corners of their faces, with a little inertia; the lowest
/// course stands on the ground, if there is one.
template <class K>
struct Lattice {
    static constexpr int D = K::dimension, n = K::unknowns;
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    using Square = typename K::Square;
    using Unknowns = typename K::Unknowns;

    solve::BlockMatrix matrix;
    solve::RowPlaces places;

    /// @param stiffness of the springs [N/m]; the inertia is 1 kg
    Lattice(int columns, int courses, double stiffness = 1e4, bool has_ground = true) : stiffness_(stiffness)
    {
        const int rows = columns * courses;
        std::vector<std::pair<int, int>> pairs;
        for (int i = 0; i < rows; ++i) {
            if (i % columns > 0) pairs.emplace_back(i, i - 1);
            if (i >= columns) pairs.emplace_back(i, i - columns);
        }
        solve::set_pattern(matrix, n, rows, pairs);
        places.kinematics = K::kinematics;
        places.free.assign(rows, 1);
        for (int i = 0; i < rows; ++i) {
            const Vector centre = i % columns * Vector::Unit(0) + i / columns * Vector::Unit(D - 1);
            places.centres.insert(places.centres.end(), centre.data(), centre.data() + D);
            add(i, i, K::mass_matrix(1, 0.1 * Matrix::Identity()) + elasticity());
            if (i % columns > 0) join(i, i - 1, Vector::Unit(0));
            if (has_ground || i >= columns) join(i, i - columns, Vector::Unit(D - 1));
        }
    }

    Unknowns of(const VectorXd& d, int row) const { return d.segment<n>(n * row); }

    /// The whole lattice moved as one block about the origin.
    VectorXd moved_as_one(const Unknowns& motion) const
    {
        VectorXd d(n * matrix.rows());
        for (int i = 0; i < matrix.rows(); ++i) {
            Unknowns own = motion;
            own.template head<D>() =
                K::displacement(motion, Eigen::Map<const Vector>(places.centres.data() + D * i));
            d.segment<n>(n * i) = own;
        }
        return d;
    }

 private:
    /// stiffness |strain|^2 / 2; none of rigid blocks.
    Square elasticity() const
    {
        Square k = Square::Zero();
        if constexpr (K::deformable)
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j) {
                    Unknowns strain = Unknowns::Zero();
                    strain[D + D * j + i] += 0.5;
                    strain[D + D * i + j] += 0.5;
                    k += stiffness_ * strain * strain.transpose();
                }
        return k;
    }

    void add(int i, int j, const Square& k)
    {
        if (i >= 0 && j >= 0 && i >= j) Eigen::Map<Square>(matrix.block(matrix.position(i, j))) += k;
    }

    /// Springs between a block and the one before it (or the ground) in the direction of the normal.
    void join(int i, int j, const Vector& normal)
    {
        const Matrix across = normal * normal.transpose();
        const Matrix c = stiffness_ * across + 0.5 * stiffness_ * (Matrix::Identity() - across);
        for (int corner = 0; corner < 1 << (D - 1); ++corner) {
            Vector along = Vector::Zero();
            for (int k = 0, bit = 0; k < D; ++k)
                if (normal[k] == 0) along[k] = (corner >> bit++) % 2 == 0 ? -0.5 : 0.5;
            const Vector of_i = along - 0.5 * normal, of_j = along + 0.5 * normal;
            Square ii = Square::Zero(), ij = Square::Zero(), jj = Square::Zero();
            K::add_stiffness(ii, of_i, of_i, c);
            K::add_stiffness(ij, of_i, of_j, -c);
            K::add_stiffness(jj, of_j, of_j, c);
            add(i, i, ii);
            add(i, j, ij);
            add(j, j, jj);
        }
    }

    double stiffness_;
};

inline VectorXd numbers(Eigen::Index size)
{
    Random random(5);
    VectorXd b(size);
    random.fill(b, 1);
    return b;
}

}  // namespace voussoir::testing
