// Factors in parts: what they know exactly, and that threads change nothing.
#include "libdda/solve/incomplete_factor.h"

#include <gtest/gtest.h>

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
