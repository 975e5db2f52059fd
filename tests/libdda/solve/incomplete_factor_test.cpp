// Factors in parts: what they know exactly, and that threads change nothing.
#include "libdda/solve/incomplete_factor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <set>

#include "libdda/solve/conjugate_gradients.h"
#include "tests/libdda/solve/lattice.h"

namespace voussoir::testing
{

namespace
{

template <class K>
class IncompleteFactor : public ::testing::Test
{
};
using All =
    ::testing::Types<step::SpatialDeformable, step::SpatialRigid, step::PlanarDeformable, step::PlanarRigid>;
TYPED_TEST_SUITE(IncompleteFactor, All);

template <class K>
VectorXd preconditioned(const solve::BlockMatrix& matrix, int threads, const VectorXd& r)
{
    solve::IncompleteFactor factor;
    factor.factorise<K::unknowns>(matrix, threads);
    VectorXd z;
    factor.apply<K::unknowns>(r, threads, z);
    return z;
}

}  // namespace

TYPED_TEST(IncompleteFactor, OfAChainIsExact)
{
    constexpr int n = TypeParam::unknowns;
    const Lattice<TypeParam> tower(1, 60);
    const VectorXd x = numbers(60 * n);
    VectorXd r;
    solve::multiply(tower.matrix, x, r);
    EXPECT_LT((preconditioned<TypeParam>(tower.matrix, 1, r) - x).norm(), 1e-8 * x.norm());
}

TYPED_TEST(IncompleteFactor, IsTheSameOnAnyNumberOfThreads)
{
    const Lattice<TypeParam> wall(40, 30);
    const VectorXd r = numbers(1200 * TypeParam::unknowns), z = preconditioned<TypeParam>(wall.matrix, 1, r);
    for (const int threads : {2, 3, 16})
        EXPECT_EQ(preconditioned<TypeParam>(wall.matrix, threads, r), z) << threads;
}

TYPED_TEST(IncompleteFactor, IsSymmetricAndPositive)
{
    const Lattice<TypeParam> wall(40, 30);
    const VectorXd r = numbers(1200 * TypeParam::unknowns), s = r.reverse();
    const VectorXd of_r = preconditioned<TypeParam>(wall.matrix, 2, r),
                   of_s = preconditioned<TypeParam>(wall.matrix, 2, s);
    // Used in single precision the same numbers are added in another order on the way there and back.
    EXPECT_NEAR(of_r.dot(s), of_s.dot(r), 1e-6 * std::abs(of_r.dot(r)));
    EXPECT_GT(of_r.dot(r), 0);
}

// Without ground and with stiff springs single precision is not enough. One factor is used for patterns and
// stiffnesses in turn and keeps nothing of one for the next; the work beside it is done once.
TYPED_TEST(IncompleteFactor, KeepsNothingFromMatrixToMatrix)
{
    constexpr int n = TypeParam::unknowns;
    const Lattice<TypeParam> soft(40, 30), stiff(40, 30, 1e9, false), small(31, 33), wide(48, 25);
    solve::IncompleteFactor factor;
    for (const Lattice<TypeParam>* wall : {&soft, &stiff, &small, &soft, &wide, &stiff}) {
        const VectorXd r = numbers(wall->matrix.rows() * n),
                       expected = preconditioned<TypeParam>(wall->matrix, 1, r);
        for (const int threads : {1, 2, 3}) {
            std::atomic<int> calls = 0;
            VectorXd z;
            factor.prepare<n>(wall->matrix);
            factor.factorise<n>(wall->matrix, threads, [&] { ++calls; });
            factor.apply<n>(r, threads, z);
            EXPECT_EQ(calls, 1);
            EXPECT_EQ(z, expected) << threads;
        }
    }
}

// As many numbers in segments of another width: what is behind the numbers of a segment must be zeros again.
TEST(IncompleteFactors, KeepNothingFromBlockSizeToBlockSize)
{
    const Lattice<step::PlanarRigid> planar(60, 40);
    const Lattice<step::SpatialRigid> spatial(40, 30);
    const VectorXd r = numbers(7200);
    const VectorXd of_planar = preconditioned<step::PlanarRigid>(planar.matrix, 1, r),
                   of_spatial = preconditioned<step::SpatialRigid>(spatial.matrix, 1, r);
    solve::IncompleteFactor factor;
    VectorXd z;
    for (int turn = 0; turn < 2; ++turn) {
        factor.factorise<3>(planar.matrix, 1);
        factor.apply<3>(r, 1, z);
        EXPECT_EQ(z, of_planar);
        factor.factorise<6>(spatial.matrix, 1);
        factor.apply<6>(r, 1, z);
        EXPECT_EQ(z, of_spatial);
    }
}

// Far from a load its effect fades; numbers below 1e-38 would cost a processor a hundred times as much.
TYPED_TEST(IncompleteFactor, OfALoadAtOneEndFadesToNothing)
{
    constexpr int n = TypeParam::unknowns;
    const Lattice<TypeParam> wall(400, 3, 1);
    VectorXd r = VectorXd::Zero(1200 * n);
    r[0] = 1;
    const VectorXd z = preconditioned<TypeParam>(wall.matrix, 1, r);
    int faint = 0;
    for (const double number : z)
        if (number != 0 && std::abs(number) < 1e-30F) ++faint;
    EXPECT_EQ(faint, 0);
    EXPECT_EQ(z.tail(n).norm(), 0);
}

// Of 2,320 joints of this wall those between border stones of two domains alone are left out.
TYPED_TEST(IncompleteFactor, DropsFewBlocks)
{
    constexpr int n = TypeParam::unknowns;
    const Lattice<TypeParam> wall(40, 30), small(31, 33);
    solve::IncompleteFactor factor;
    factor.factorise<n>(wall.matrix, 1);
    const auto stored = static_cast<std::int64_t>(wall.matrix.columns.size());
    EXPECT_LT(factor.entries(), stored * n * n);
    EXPECT_GT(factor.entries(), 99 * stored / 100 * n * n);
    factor.factorise<n>(small.matrix, 1);
    EXPECT_EQ(factor.entries(), static_cast<std::int64_t>(small.matrix.columns.size()) * n * n);
}

TYPED_TEST(IncompleteFactor, RowsCollectWhatTheProductSends)
{
    constexpr int n = TypeParam::unknowns;
    const Lattice<TypeParam> wall(12, 9);
    const VectorXd x = numbers(108 * n);
    VectorXd whole(x.size()), in_rows(x.size());
    solve::Kernels<n>::multiply(wall.matrix, x, whole);
    solve::Kernels<n>::multiply_rows(wall.matrix, solve::columns_of(wall.matrix), 0, 50, x, in_rows);
    solve::Kernels<n>::multiply_rows(wall.matrix, solve::columns_of(wall.matrix), 50, 108, x, in_rows);
    EXPECT_EQ(in_rows, whole);
}

TEST(Domains, AreAsManyAsTheRowsAsk)
{
    const Lattice<step::PlanarRigid> small(31, 33), wall(40, 30), long_wall(400, 30);
    EXPECT_EQ(solve::divide_into_domains(small.matrix, 256, 16).count, 1);
    const int few = solve::divide_into_domains(wall.matrix, 256, 16).count;
    EXPECT_GE(few, 3);
    EXPECT_LE(few, 6);
    const solve::Domains many = solve::divide_into_domains(long_wall.matrix, 256, 16);
    EXPECT_GE(many.count, 12);
    EXPECT_LE(many.count, 20);
    EXPECT_EQ(std::set<int>(many.of_row.begin(), many.of_row.end()).size(), static_cast<std::size_t>(many.count));
}

}  // namespace voussoir::testing
