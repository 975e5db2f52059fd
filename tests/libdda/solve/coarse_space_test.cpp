// Walls of blocks on springs: what the coarse space knows exactly, and how many iterations it saves.
#include "libdda/solve/coarse_space.h"

#include <gtest/gtest.h>

#include "libdda/solve/cholmod_solver.h"
#include "libdda/solve/conjugate_gradients.h"
#include "tests/libdda/solve/lattice.h"

namespace voussoir::testing
{

namespace
{

template <class K>
class CoarseSpace : public ::testing::Test
{
};
using All =
    ::testing::Types<step::SpatialDeformable, step::SpatialRigid, step::PlanarDeformable, step::PlanarRigid>;
TYPED_TEST_SUITE(CoarseSpace, All);

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
    ASSERT_TRUE(coarse.prepare(lattice.matrix, solve::columns_of(lattice.matrix), 1));
    coarse.factorise();
    for (int k = 0; k < TypeParam::unknowns; ++k) {
        const VectorXd d = lattice.moved_as_one(TypeParam::Unknowns::Unit(k));
        VectorXd load, found;
        solve::multiply(lattice.matrix, d, load);
        coarse.start(load, 1, found);
        EXPECT_LT((found - d).norm(), 1e-9 * d.norm()) << k;
    }
}

TYPED_TEST(CoarseSpace, LeavesNoResidualThatMovesTheWholeAsOneBlock)
{
    const Lattice<TypeParam> lattice(20, 20);
    solve::CoarseSpace coarse;
    coarse.place(lattice.places);
    ASSERT_TRUE(coarse.prepare(lattice.matrix, solve::columns_of(lattice.matrix), 1));
    coarse.factorise();
    const VectorXd r = numbers(TypeParam::unknowns * 400);
    VectorXd z = 1e-4 * numbers(r.size()), kz;
    coarse.correct(r, 1, z);
    solve::multiply(lattice.matrix, z, kz);
    for (int k = 0; k < TypeParam::unknowns; ++k) {
        const VectorXd d = lattice.moved_as_one(TypeParam::Unknowns::Unit(k));
        EXPECT_LT(std::abs(d.dot(r - kz)), 1e-9 * d.norm() * kz.norm()) << k;
    }
}

// From 1,024 rows on the coarse factor is in single precision, unless inertia alone holds the whole: then in
// double.
TYPED_TEST(CoarseSpace, OfManyRowsKnowsTheWholeToSixDigits)
{
    for (const bool has_ground : {true, false}) {
        const double stiffness = has_ground ? 1e4 : 1e8;
        const Lattice<TypeParam> lattice(33, 32, stiffness, has_ground);
        solve::CoarseSpace coarse;
        coarse.place(lattice.places);
        const VectorXd r = numbers(TypeParam::unknowns * lattice.matrix.rows());
        VectorXd first;
        for (const int threads : {1, 2, 3}) {
            ASSERT_TRUE(coarse.prepare(lattice.matrix, solve::columns_of(lattice.matrix), threads));
            coarse.factorise();
            VectorXd z = numbers(r.size()) / stiffness, kz;
            coarse.correct(r, threads, z);
            if (threads == 1) first = z;
            EXPECT_EQ(z, first) << threads;
            solve::multiply(lattice.matrix, z, kz);
            for (int k = 0; k < TypeParam::unknowns; ++k) {
                const VectorXd d = lattice.moved_as_one(TypeParam::Unknowns::Unit(k));
                EXPECT_LT(std::abs(d.dot(r - kz)), 1e-6 * d.norm() * kz.norm()) << k << ", " << has_ground;
            }
        }
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
    EXPECT_FALSE(
        coarse.prepare(wall.matrix, solve::columns_of(wall.matrix), 1));  // nobody told it where the rows are
    for (const Lattice<TypeParam>* lattice : {&few, &chain}) {
        coarse.place(lattice->places);
        EXPECT_FALSE(coarse.prepare(lattice->matrix, solve::columns_of(lattice->matrix), 1));
    }
    coarse.place(wall.places);
    EXPECT_TRUE(coarse.prepare(wall.matrix, solve::columns_of(wall.matrix), 1));
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
    ASSERT_TRUE(coarse.prepare(lattice.matrix, solve::columns_of(lattice.matrix), 1));
    coarse.factorise();
    VectorXd x;
    coarse.start(numbers(n * 400), 1, x);
    EXPECT_EQ(lattice.of(x, held).norm(), 0);
    EXPECT_GT(lattice.of(x, held + 1).norm(), 0);
    const int iterated = iterations(lattice, true, x);
    EXPECT_LT(iterated, iterations(lattice, false, x));
}

}  // namespace voussoir::testing
