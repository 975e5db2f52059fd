// Walls of blocks on springs: what the coarse space knows exactly, and how many iterations it saves.
#include "libdda/solve/coarse_space.h"

#include <gtest/gtest.h>

#include "libdda/solve/cholmod_solver.h"
#include "libdda/solve/conjugate_gradients.h"
#include "libdda/step/kinematics_traits.h"
#include "tests/libdda/poses.h"

namespace voussoir::testing
{

namespace
{

using Eigen::VectorXd;

/// A lattice of unit cubes (squares) on springs at the corners of their faces, with a little inertia; the lowest
/// course stands on the ground.
template <class K>
struct Lattice {
    static constexpr int D = K::dimension, n = K::unknowns;
    using Vector = typename K::Vector;
    using Matrix = typename K::Matrix;
    using Square = typename K::Square;
    using Unknowns = typename K::Unknowns;

    solve::BlockMatrix matrix;
    solve::RowPlaces places;

    Lattice(int columns, int courses)
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
            join(i, i - columns, Vector::Unit(D - 1));
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
    /// 1e4 |strain|^2 / 2; none of rigid blocks.
    static Square elasticity()
    {
        Square k = Square::Zero();
        if constexpr (K::deformable)
            for (int i = 0; i < D; ++i)
                for (int j = 0; j < D; ++j) {
                    Unknowns strain = Unknowns::Zero();
                    strain[D + D * j + i] += 0.5;
                    strain[D + D * i + j] += 0.5;
                    k += 1e4 * strain * strain.transpose();
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
        const Matrix c = 1e4 * across + 5e3 * (Matrix::Identity() - across);
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
};

template <class K>
class CoarseSpace : public ::testing::Test
{
};
using All =
    ::testing::Types<step::SpatialDeformable, step::SpatialRigid, step::PlanarDeformable, step::PlanarRigid>;
TYPED_TEST_SUITE(CoarseSpace, All);

VectorXd numbers(Eigen::Index size)
{
    Random random(5);
    VectorXd b(size);
    random.fill(b, 1);
    return b;
}

/// Iterations of conjugate gradients, which must solve the system. Those without places may come to their end.
template <class K>
int iterations(const Lattice<K>& lattice, bool with_places, VectorXd& x)
{
    const auto solver = solve::make_conjugate_gradient_solver(1e-8);
    if (with_places) solver->place(lattice.places);
    const solve::LinearReport report =
        solver->solve(lattice.matrix, numbers(K::unknowns * lattice.matrix.rows()), x);
    EXPECT_TRUE(report.solved || !with_places);
    return report.iterations;
}

}  // namespace

TYPED_TEST(CoarseSpace, KnowsTheMotionsOfTheWholeAsOneBlock)
{
    const Lattice<TypeParam> lattice(20, 20);
    solve::CoarseSpace coarse;
    coarse.place(lattice.places);
    ASSERT_TRUE(coarse.prepare(lattice.matrix));
    for (int k = 0; k < TypeParam::unknowns; ++k) {
        const VectorXd d = lattice.moved_as_one(TypeParam::Unknowns::Unit(k));
        VectorXd load, found;
        solve::multiply(lattice.matrix, d, load);
        coarse.start(load, found);
        EXPECT_LT((found - d).norm(), 1e-9 * d.norm()) << k;
    }
}

TYPED_TEST(CoarseSpace, LeavesNoResidualThatMovesTheWholeAsOneBlock)
{
    const Lattice<TypeParam> lattice(20, 20);
    solve::CoarseSpace coarse;
    coarse.place(lattice.places);
    ASSERT_TRUE(coarse.prepare(lattice.matrix));
    const VectorXd r = numbers(TypeParam::unknowns * 400);
    VectorXd z = 1e-4 * numbers(r.size()), kz;
    coarse.correct(r, z);
    solve::multiply(lattice.matrix, z, kz);
    for (int k = 0; k < TypeParam::unknowns; ++k) {
        const VectorXd d = lattice.moved_as_one(TypeParam::Unknowns::Unit(k));
        EXPECT_LT(std::abs(d.dot(r - kz)), 1e-9 * d.norm() * kz.norm()) << k;
    }
}

TYPED_TEST(CoarseSpace, TheSolutionIsThatOfTheDirectSolver)
{
    const Lattice<TypeParam> lattice(20, 20);
    VectorXd direct, iterated;
    ASSERT_TRUE(
        solve::make_cholmod_solver()->solve(lattice.matrix, numbers(TypeParam::unknowns * 400), direct).solved);
    iterations(lattice, true, iterated);
    EXPECT_LT((iterated - direct).norm(), 1e-5 * direct.norm());
}

TYPED_TEST(CoarseSpace, IterationsHardlyGrowWithTheNumberOfBlocks)
{
    VectorXd x;
    const Lattice<TypeParam> small(20, 20), large(40, 40);
    const int few = iterations(small, true, x), many = iterations(large, true, x);
    EXPECT_LE(many, 1.25 * few);
    EXPECT_GE(iterations(large, false, x), 1.5 * iterations(small, false, x));
    EXPECT_LE(many, 0.5 * iterations(large, false, x));
}

TYPED_TEST(CoarseSpace, IsNotThereForFewRowsOrForChains)
{
    solve::CoarseSpace coarse;
    const Lattice<TypeParam> few(10, 10), chain(1, 400), wall(20, 20);
    EXPECT_FALSE(coarse.prepare(wall.matrix));  // nobody told it where the rows are
    for (const Lattice<TypeParam>* lattice : {&few, &chain}) {
        coarse.place(lattice->places);
        EXPECT_FALSE(coarse.prepare(lattice->matrix));
    }
    coarse.place(wall.places);
    EXPECT_TRUE(coarse.prepare(wall.matrix));
}

// What holds a component makes its row and column those of the identity.
TYPED_TEST(CoarseSpace, RowsThatAreHeldStayOut)
{
    Lattice<TypeParam> lattice(20, 20);
    constexpr int n = TypeParam::unknowns, held = 137;
    lattice.places.free[held] = 0;
    for (int i = 0; i < lattice.matrix.rows(); ++i)
        for (int p = lattice.matrix.row_start[i]; p < lattice.matrix.row_start[i + 1]; ++p) {
            if (i != held && lattice.matrix.columns[p] != held) continue;
            Eigen::Map<typename TypeParam::Square> block(lattice.matrix.block(p));
            block.setZero();
            if (i == held && lattice.matrix.columns[p] == held) block.setIdentity();
        }
    solve::CoarseSpace coarse;
    coarse.place(lattice.places);
    ASSERT_TRUE(coarse.prepare(lattice.matrix));
    VectorXd x;
    coarse.start(numbers(n * 400), x);
    EXPECT_EQ(lattice.of(x, held).norm(), 0);
    EXPECT_GT(lattice.of(x, held + 1).norm(), 0);
    const int iterated = iterations(lattice, true, x);
    EXPECT_LT(iterated, iterations(lattice, false, x));
}

}  // namespace voussoir::testing
