// The members of the linear solver against a dense factorisation.
#include "libdda/solve/linear_solver.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <limits>

#include "libdda/solve/cholmod_solver.h"
#include "libdda/solve/conjugate_gradients.h"
#include "tests/libdda/poses.h"

namespace voussoir::testing
{

namespace
{

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Pairs = std::vector<std::pair<int, int>>;

/// The block matrix and the same numbers densely.
struct System {
    solve::BlockMatrix blocks;
    MatrixXd dense;
    VectorXd right_hand_side;

    System(int block_size, int rows, Pairs pairs, unsigned seed, double shift = 1)
    {
        Random random(seed);
        solve::set_pattern(blocks, block_size, rows, pairs);
        dense = shift * MatrixXd::Identity(block_size * rows, block_size * rows);
        for (const auto& [i, j] : pairs) add_spring(i, j, random);
        for (int i = 0; i < rows; ++i)
            for (int p = blocks.row_start[i]; p < blocks.row_start[i + 1]; ++p)
                Eigen::Map<MatrixXd>(blocks.block(p), block_size, block_size) =
                    dense.block(block_size * i, block_size * blocks.columns[p], block_size, block_size);
        right_hand_side.resize(block_size * rows);
        random.fill(right_hand_side, 1);
    }
    /// k g^T g of a few random directions that involve two rows, as contacts do.
    void add_spring(int i, int j, Random& random)
    {
        const int n = blocks.block_size;
        for (int k = 0; k < n / 2; ++k) {
            VectorXd g = VectorXd::Zero(dense.rows()), part(n);
            random.fill(part, 1);
            g.segment(n * i, n) = part;
            random.fill(part, 1);
            g.segment(n * j, n) = part;
            dense += random.between(1, 10) * g * g.transpose();
        }
    }
    double error_of(const VectorXd& x) const
    {
        const VectorXd exact = dense.llt().solve(right_hand_side);
        return (x - exact).norm() / exact.norm();
    }
};

Pairs random_pairs(int rows, int count, unsigned seed)
{
    Random random(seed);
    Pairs pairs;
    while (static_cast<int>(pairs.size()) < count) {
        const int i = static_cast<int>(random.between(0, rows)), j = static_cast<int>(random.between(0, rows));
        if (i != j) pairs.emplace_back(std::max(i, j), std::min(i, j));
    }
    return pairs;
}

Pairs chain(int rows)
{
    Pairs pairs;
    for (int i = 1; i < rows; ++i) pairs.emplace_back(i, i - 1);
    return pairs;
}

}  // namespace

TEST(BlockMatrix, PatternIsSortedWithoutRepeatsAndEndsOnTheDiagonal)
{
    solve::BlockMatrix matrix;
    Pairs pairs{{3, 1}, {2, 0}, {3, 1}, {3, 0}};
    EXPECT_TRUE(solve::set_pattern(matrix, 6, 4, pairs));
    EXPECT_EQ(matrix.row_start, (std::vector<int>{0, 1, 2, 4, 7}));
    EXPECT_EQ(matrix.columns, (std::vector<int>{0, 1, 0, 2, 0, 1, 3}));
    EXPECT_EQ(matrix.position(3, 1), 5);
    for (int row = 0; row < 4; ++row) EXPECT_EQ(matrix.columns[matrix.diagonal(row)], row);
    matrix.values[0] = 1;
    EXPECT_FALSE(solve::set_pattern(matrix, 6, 4, pairs));
    EXPECT_EQ(matrix.values[0], 0);
    EXPECT_TRUE(solve::set_pattern(matrix, 12, 4, pairs));
    EXPECT_EQ(matrix.values.size(), 7U * 144);
}

TEST(LinearSolver, AgreesWithDenseForEveryBlockSize)
{
    for (const int n : {12, 6, 3}) {
        const System system(n, 20, random_pairs(20, 40, 5), 11);
        VectorXd x;
        const solve::LinearReport direct =
            solve::make_cholmod_solver()->solve(system.blocks, system.right_hand_side, x);
        EXPECT_TRUE(direct.solved);
        EXPECT_EQ(direct.factorisations, 1);
        EXPECT_GT(direct.factor_entries, 20 * n * (n + 1) / 2 - 1);
        EXPECT_LT(system.error_of(x), 1e-11) << n;
        const solve::LinearReport krylov =
            solve::make_conjugate_gradient_solver(1e-12)->solve(system.blocks, system.right_hand_side, x);
        EXPECT_TRUE(krylov.solved);
        EXPECT_GT(krylov.iterations, 2);
        EXPECT_LT(system.error_of(x), 1e-9) << n;
    }
}

TEST(LinearSolver, ConjugateGradientsStopAtTheirTolerance)
{
    const System system(6, 30, random_pairs(30, 60, 2), 3);
    int last = 0;
    for (const double tolerance : {1e-2, 1e-5, 1e-9}) {
        VectorXd x;
        const solve::LinearReport report =
            solve::make_conjugate_gradient_solver(tolerance)->solve(system.blocks, system.right_hand_side, x);
        EXPECT_TRUE(report.solved);
        EXPECT_GT(report.iterations, last);
        last = report.iterations;
        const double residual = (system.dense * x - system.right_hand_side).norm();
        EXPECT_LT(residual, 1.001 * tolerance * system.right_hand_side.norm());
    }
}

// The incomplete factor of a chain drops nothing: it is the factor.
TEST(LinearSolver, ConjugateGradientsSolveAChainAtOnce)
{
    for (const int n : {12, 6, 3}) {
        const System system(n, 40, chain(40), 17, 0.1);
        VectorXd x;
        const solve::LinearReport report =
            solve::make_conjugate_gradient_solver(1e-10)->solve(system.blocks, system.right_hand_side, x);
        EXPECT_TRUE(report.solved);
        EXPECT_LE(report.iterations, 2);
        EXPECT_LT(system.error_of(x), 1e-8);
    }
}

// One solver sees many patterns in a run; what it keeps must not show.
TEST(LinearSolver, AChangeOfPatternOrBlockSizeDoesNotMatter)
{
    const auto direct = solve::make_cholmod_solver(), krylov = solve::make_conjugate_gradient_solver(1e-12);
    const System systems[] = {System(6, 20, random_pairs(20, 40, 1), 1),
                              System(6, 20, random_pairs(20, 40, 2), 2),
                              System(6, 25, chain(25), 3),
                              System(12, 25, chain(25), 4),
                              System(3, 25, chain(25), 5),
                              System(6, 20, random_pairs(20, 40, 1), 1)};
    for (const System& system : systems)
        for (solve::LinearSolver* solver : {direct.get(), krylov.get()}) {
            VectorXd x, fresh;
            ASSERT_TRUE(solver->solve(system.blocks, system.right_hand_side, x).solved);
            EXPECT_LT(system.error_of(x), 1e-9);
            if (solver == direct.get())
                solve::make_cholmod_solver()->solve(system.blocks, system.right_hand_side, fresh);
            else
                solve::make_conjugate_gradient_solver(1e-12)->solve(system.blocks, system.right_hand_side, fresh);
            EXPECT_EQ((x - fresh).cwiseAbs().maxCoeff(), 0);
        }
}

TEST(LinearSolver, AnIndefiniteMatrixIsNotSolved)
{
    const System system(6, 10, random_pairs(10, 20, 8), 9, -3);
    ASSERT_LT(system.dense.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0);
    for (const LinearSolverKind kind :
         {LinearSolverKind::cholmod, LinearSolverKind::conjugate_gradients, LinearSolverKind::automatic}) {
        VectorXd x;
        EXPECT_FALSE(
            solve::make_linear_solver(kind, 1e-8)->solve(system.blocks, system.right_hand_side, x).solved);
    }
}

TEST(LinearSolver, NumbersThatAreNoneAreNotSolved)
{
    System system(6, 10, chain(10), 9);
    system.blocks.values[50] = std::numeric_limits<double>::quiet_NaN();
    for (const LinearSolverKind kind :
         {LinearSolverKind::cholmod, LinearSolverKind::conjugate_gradients, LinearSolverKind::automatic}) {
        VectorXd x;
        EXPECT_FALSE(
            solve::make_linear_solver(kind, 1e-8)->solve(system.blocks, system.right_hand_side, x).solved);
    }
}

TEST(LinearSolver, AutomaticFallsBackOnTheDirectSolver)
{
    // A tolerance of zero: the iteration cannot reach it, Cholesky does not ask.
    const System system(12, 20, random_pairs(20, 60, 4), 21, 1e-6);
    VectorXd x;
    EXPECT_FALSE(solve::make_conjugate_gradient_solver(0)->solve(system.blocks, system.right_hand_side, x).solved);
    const solve::LinearReport report =
        solve::make_linear_solver(LinearSolverKind::automatic, 0)->solve(system.blocks, system.right_hand_side, x);
    EXPECT_TRUE(report.solved);
    EXPECT_EQ(report.factorisations, 2);
    EXPECT_LT(system.error_of(x), 1e-6);
}

TEST(LinearSolver, NothingAskedNothingMoves)
{
    System system(6, 10, chain(10), 9);
    system.right_hand_side.setZero();
    VectorXd x;
    const solve::LinearReport report = solve::make_linear_solver(LinearSolverKind::automatic, 1e-3)
                                           ->solve(system.blocks, system.right_hand_side, x);
    EXPECT_TRUE(report.solved);
    EXPECT_EQ(x.norm(), 0);
}

}  // namespace voussoir::testing
