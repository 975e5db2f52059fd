// The lowest modes of block matrices against dense solutions.
#include "libdda/solve/lowest_modes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <utility>

#include "tests/libdda/poses.h"

namespace voussoir::testing
{

namespace
{

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Chains of masses with random springs and inertias; every chain the same.
struct Chains {
    solve::BlockMatrix stiffness;
    std::vector<double> mass;
    MatrixXd dense, dense_mass;

    Chains(int block_size, int rows, int copies, bool held)
    {
        const int n = block_size, all = n * rows * copies;
        std::vector<std::pair<int, int>> pairs;
        for (int c = 0; c < copies; ++c)
            for (int i = 1; i < rows; ++i) pairs.emplace_back(c * rows + i, c * rows + i - 1);
        solve::set_pattern(stiffness, n, rows * copies, pairs);
        dense = dense_mass = MatrixXd::Zero(all, all);
        for (int c = 0; c < copies; ++c) add_chain(n, rows, n * rows * c, held);
        mass.resize(static_cast<std::size_t>(n) * n * rows * copies);
        for (int i = 0; i < rows * copies; ++i) {
            Eigen::Map<MatrixXd>(mass.data() + i * n * n, n, n) = dense_mass.block(n * i, n * i, n, n);
            for (int p = stiffness.row_start[i]; p < stiffness.row_start[i + 1]; ++p)
                Eigen::Map<MatrixXd>(stiffness.block(p), n, n) =
                    dense.block(n * i, n * stiffness.columns[p], n, n);
        }
    }
    void add_chain(int n, int rows, int first, bool held)
    {
        Random random(7);
        VectorXd part(n);
        for (int i = 0; i < rows; ++i) {
            dense_mass.block(first + n * i, first + n * i, n, n).diagonal().setConstant(random.between(1, 3));
            for (int k = 0; k < n; ++k) {  // springs that only feel the difference of two neighbours
                if (i == 0 && !held) continue;
                VectorXd g = VectorXd::Zero(dense.rows());
                random.fill(part, 1);
                g.segment(first + n * i, n) = part;
                if (i > 0) g.segment(first + n * (i - 1), n) = -part;
                dense += random.between(1e6, 1e8) * g * g.transpose();
            }
        }
    }
};

TEST(LowestModes, OfChainsAreThoseOfTheDenseMatrices)
{
    for (const int rows : {2, 7, 60}) {
        const Chains chains(3, rows, 1, true);
        solve::CholmodFactor factor;
        const solve::LowestModes modes = solve::lowest_modes(chains.stiffness, chains.mass, 5, factor);
        ASSERT_TRUE(modes.converged);
        ASSERT_EQ(modes.eigenvalues.size(), 5);
        const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> exact(chains.dense, chains.dense_mass);
        for (int i = 0; i < 5; ++i) {
            EXPECT_NEAR(modes.eigenvalues[i] / exact.eigenvalues()[i], 1, 1e-9) << rows << " rows, mode " << i;
            const VectorXd x = modes.shapes.col(i);
            EXPECT_NEAR(x.dot(chains.dense_mass * x), 1, 1e-9);
            EXPECT_NEAR(std::abs(x.dot(chains.dense_mass * exact.eigenvectors().col(i))), 1, 1e-9);
        }
    }
}

TEST(LowestModes, OfEqualStructuresAllCome)
{
    const Chains chains(3, 20, 4, true);
    solve::CholmodFactor factor;
    const solve::LowestModes modes = solve::lowest_modes(chains.stiffness, chains.mass, 8, factor);
    ASSERT_TRUE(modes.converged);
    ASSERT_EQ(modes.eigenvalues.size(), 8);
    for (const int i : {1, 2, 3, 5, 6, 7})
        EXPECT_NEAR(modes.eigenvalues[i] / modes.eigenvalues[i - 1], 1, 1e-9) << i;
    EXPECT_GT(modes.eigenvalues[4], 1.01 * modes.eigenvalues[3]);
}

TEST(LowestModes, OfAFreeChainBeginWithZero)
{
    const Chains chains(3, 30, 1, false);
    solve::CholmodFactor factor;
    const solve::LowestModes modes = solve::lowest_modes(chains.stiffness, chains.mass, 5, factor);
    ASSERT_TRUE(modes.converged);
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> exact(chains.dense, chains.dense_mass);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(modes.eigenvalues[i], 0) << i;
    for (int i = 3; i < 5; ++i) EXPECT_NEAR(modes.eigenvalues[i] / exact.eigenvalues()[i], 1, 1e-7) << i;
}

TEST(LowestModes, OfNegativeStiffnessAreNone)
{
    Chains chains(3, 5, 1, true);
    for (double& value : chains.stiffness.values) value = -value;
    solve::CholmodFactor factor;
    EXPECT_FALSE(solve::lowest_modes(chains.stiffness, chains.mass, 2, factor).converged);
}

}  // namespace

}  // namespace voussoir::testing
