// Blocks in single precision: what their products are, and that a large scene's iteration does not notice.
#include "libdda/solve/single_precision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libdda/solve/conjugate_gradients.h"
#include "libdda/solve/single_factor.h"
#include "tests/libdda/solve/lattice.h"

namespace voussoir::testing
{

namespace
{

template <class K>
class SinglePrecision : public ::testing::Test
{
};
using All =
    ::testing::Types<step::SpatialDeformable, step::SpatialRigid, step::PlanarDeformable, step::PlanarRigid>;
TYPED_TEST_SUITE(SinglePrecision, All);

/// Iterations of conjugate gradients with all that preconditions them.
template <class K>
int iterations(const Lattice<K>& lattice, VectorXd& x)
{
    const auto solver = solve::make_conjugate_gradient_solver(1e-9);
    solver->place(lattice.places);
    const solve::LinearReport report =
        solver->solve(lattice.matrix, numbers(K::unknowns * lattice.matrix.rows()), x);
    EXPECT_TRUE(report.solved);
    return report.iterations;
}

/// @returns the least that is left of a diagonal entry; 0: there is no factor
template <int N>
double factorise(const solve::BlockMatrix& matrix, solve::SingleFactor<N>& factor)
{
    factor.resize(matrix);
    double left = 1;
    for (int i = 0; i < matrix.rows() && left > 0; ++i)
        left = std::min(left, factor.factorise_row(matrix, i, [&](int p, auto& columns) {
            solve::SinglePrecision<N>::take(solve::Kernels<N>::block(matrix, p), columns);
        }));
    return left;
}

}  // namespace

TYPED_TEST(SinglePrecision, ProductsAreThoseOfDoublesToSixDigits)
{
    constexpr int n = TypeParam::unknowns;
    using Single = solve::SinglePrecision<n>;
    const VectorXd values = numbers(3 * n * n), x = numbers(n);
    std::vector<float> blocks;
    Single::resize(3, blocks);
    for (int i = 0; i < 3; ++i)
        Single::put(Eigen::Map<const typename TypeParam::Square>(values.data() + i * n * n), i, blocks);
    for (int i = 0; i < 3; ++i) {
        const VectorXd expected = Eigen::Map<const typename TypeParam::Square>(values.data() + i * n * n) * x;
        const auto product = Single::product(blocks, i, x.data());
        EXPECT_LT((product.template head<n>().matrix().template cast<double>() - expected).norm(),
                  1e-6 * expected.norm());
    }
}

TYPED_TEST(SinglePrecision, TransposedProductsToo)
{
    constexpr int n = TypeParam::unknowns;
    using Single = solve::SinglePrecision<n>;
    const VectorXd values = numbers(2 * n * n), x = numbers(n);
    std::vector<float> blocks;
    Single::resize(2, blocks);
    Eigen::VectorXf y = Eigen::VectorXf::Zero(Single::width);
    y.head<n>() = x.cast<float>();
    typename Single::Packed packed, product;
    Single::read(y.data(), packed);
    for (int i = 0; i < 2; ++i) {
        const Eigen::Map<const typename TypeParam::Square> block(values.data() + i * n * n);
        Single::put(block, i, blocks);
        Single::transposed_product(blocks, i, packed, product);
        Single::write(product, y.data());
        const VectorXd expected = block.transpose() * x;
        EXPECT_LT((y.head<n>().template cast<double>() - expected).norm(), 1e-6 * expected.norm());
        EXPECT_EQ(y.tail(Single::width - n).norm(), 0);
    }
}

// Each block of the last row of the factor is a hundredth of the one before it: after 20 of them 1e-40 would be
// left.
TYPED_TEST(SinglePrecision, WhatFadesIsGoneBeforeItSlowsTheProcessor)
{
    constexpr int n = TypeParam::unknowns, rows = 40;
    using Single = solve::SinglePrecision<n>;
    using Square = typename TypeParam::Square;
    solve::BlockMatrix pattern;
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < i; ++j) pairs.emplace_back(i, j);
    solve::set_pattern(pattern, n, rows, pairs);
    for (int i = 0; i < rows; ++i) {
        Eigen::Map<Square>(pattern.block(pattern.diagonal(i))) = Square::Identity();
        if (i > 0) Eigen::Map<Square>(pattern.block(pattern.position(i, i - 1))) = 0.01 * Square::Identity();
        if (i == rows - 1) Eigen::Map<Square>(pattern.block(pattern.position(i, 0))) = 0.01 * Square::Identity();
    }
    solve::SingleFactor<n> factor;
    EXPECT_GT(factorise(pattern, factor), 0.9);
    int small = 0;
    for (const float number : factor.blocks())
        if (number != 0 && std::abs(number) < Single::nothing) ++small;
    EXPECT_EQ(small, 0);
}

// The factor of a chain is exact: L^-T L^-1 b solves the system.
TYPED_TEST(SinglePrecision, FactorOfAChainSolvesIt)
{
    constexpr int n = TypeParam::unknowns, rows = 50, width = solve::SingleFactor<n>::width;
    const Lattice<TypeParam> tower(1, rows, 100);
    solve::SingleFactor<n> factor;
    EXPECT_GT(factorise(tower.matrix, factor), solve::least_left);
    const VectorXd x = numbers(rows * n);
    VectorXd b;
    solve::multiply(tower.matrix, x, b);
    Eigen::VectorXf found = Eigen::VectorXf::Zero(rows * width);
    for (int i = 0; i < rows; ++i) factor.forward(tower.matrix, i, b.segment<n>(n * i), found.data());
    const solve::ColumnsOf below = solve::columns_of(tower.matrix);
    for (int i = rows - 1; i >= 0; --i) factor.backward(tower.matrix, below, i, found.data());
    for (int i = 0; i < rows; ++i) {
        EXPECT_LT((found.segment<n>(width * i).template cast<double>() - x.segment<n>(n * i)).norm(), 1e-3);
        EXPECT_EQ(found.segment(width * i + n, width - n).norm(), 0);
    }
}

// A chain that nothing but its inertia holds: the last diagonal block keeps what is left of the springs, and 24
// bits do not know it. A matrix that is not positive definite has no factor.
TYPED_TEST(SinglePrecision, FactorTellsWhatIsLeft)
{
    constexpr int n = TypeParam::unknowns, rows = 20;
    const auto left = [](const solve::BlockMatrix& matrix) {
        solve::SingleFactor<n> factor;
        return factorise(matrix, factor);
    };
    EXPECT_GT(left(Lattice<TypeParam>(1, rows, 1e2, false).matrix), 1e-3);
    EXPECT_LT(left(Lattice<TypeParam>(1, rows, 1e9, false).matrix), solve::least_left);
    Lattice<TypeParam> not_definite(1, rows, 1e2);
    Eigen::Map<typename TypeParam::Square>(not_definite.matrix.block(not_definite.matrix.diagonal(7))) *= -1;
    EXPECT_EQ(left(not_definite.matrix), 0);
}

// 1,023 rows are preconditioned in double precision and in one piece, 1,024 in single, in domains and with smaller
// clusters, which save iterations: what counts is that stiffness costs none of them. Without ground nothing but
// its inertia holds the whole, a ten-thousandth to a million millionth of what the springs hold; somewhere
// between, double precision takes over.
TYPED_TEST(SinglePrecision, CostsNoIterationsHoweverStiffTheJoints)
{
    int first = 0;
    for (const bool has_ground : {true, false})
        for (const double stiffness : {1e4, 1e5, 1e6, 1e8, 1e12}) {
            SCOPED_TRACE(::testing::PrintToString(has_ground) + ", " + std::to_string(stiffness));
            const Lattice<TypeParam> in_double(31, 33, stiffness, has_ground),
                in_single(32, 32, stiffness, has_ground);
            VectorXd x;
            const int most = iterations(in_double, x), taken = iterations(in_single, x);
            if (first == 0) first = taken;
            EXPECT_LE(taken, most);
            EXPECT_NEAR(taken, first, std::max(2.0, 0.15 * first));
            VectorXd load;
            solve::multiply(in_single.matrix, x, load);
            const VectorXd b = numbers(load.size());
            // Beyond what is asked for, what rounding in double precision makes of the product: 50 eps of each
            // spring.
            EXPECT_LT((load - b).norm(), 1e-9 * b.norm() + 1e-14 * stiffness * x.norm());
        }
}

}  // namespace voussoir::testing
