#include "libdda/solve/gmres.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/libdda/poses.h"

namespace voussoir::testing
{

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace
{

/// Of no symmetry, its eigenvalues right of the origin.
MatrixXd unsymmetric(int size)
{
    Random random(11);
    VectorXd entries(size * size);
    random.fill(entries, 1);
    return MatrixXd(Eigen::Map<MatrixXd>(entries.data(), size, size)) +
           2 * std::sqrt(size) * MatrixXd::Identity(size, size);
}

VectorXd numbers(int size)
{
    Random random(12);
    VectorXd b(size);
    random.fill(b, 1);
    return b;
}

solve::Pieces whole(int size)
{
    return {size, 1, 1};
}

void copy(const VectorXd& r, VectorXd& z)
{
    z = r;
}

}  // namespace

TEST(Gmres, SolvesSystemsThatAreNotSymmetricToTheTolerance)
{
    const MatrixXd a = unsymmetric(60);
    const VectorXd b = numbers(60);
    solve::Gmres gmres;
    VectorXd x;
    for (const double tolerance : {1e-2, 1e-6, 1e-10}) {
        const solve::LinearReport report =
            gmres.solve([&](const VectorXd& v, VectorXd& y) { y = a * v; }, copy, b, tolerance, 60, whole(60), x);
        EXPECT_TRUE(report.solved);
        EXPECT_LE((b - a * x).norm(), 1.01 * tolerance * b.norm());
    }
}

TEST(Gmres, NeedsOneIterationWithTheInverse)
{
    const MatrixXd a = unsymmetric(30), inverse = a.inverse();
    const VectorXd b = numbers(30);
    solve::Gmres gmres;
    VectorXd x;
    const solve::LinearReport report =
        gmres.solve([&](const VectorXd& v, VectorXd& y) { y = a * v; },
                    [&](const VectorXd& r, VectorXd& z) { z = inverse * r; }, b, 1e-10, 5, whole(30), x);
    EXPECT_TRUE(report.solved);
    EXPECT_EQ(report.iterations, 1);
    EXPECT_LT((x - inverse * b).norm(), 1e-10 * x.norm());
}

/// A number with 12 binary digits.
double rounded(double x)
{
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, 12)), exponent - 12);
}

// The operator is of two thousand unknowns in several pieces, some a million times as stiff as others.
TEST(Gmres, KeepsToTheToleranceThoughThePreconditionerIsRounded)
{
    const int size = 2000;
    const VectorXd b = numbers(size);
    const auto stiffness = [](Eigen::Index i) { return i % 2 == 0 ? 1.0 : 1e6; };
    const auto multiply = [&](const VectorXd& v, VectorXd& y) {
        y.resize(size);
        for (Eigen::Index i = 0; i < size; ++i)
            y[i] = stiffness(i) * (v[i] - 0.4 * v[(i + 1) % size] * stiffness((i + 1) % size) / 1e6);
    };
    const auto precondition = [&](const VectorXd& r, VectorXd& z) {
        z.resize(size);
        for (Eigen::Index i = 0; i < size; ++i) z[i] = rounded(r[i] / stiffness(i));
    };
    solve::Gmres gmres;
    VectorXd x, y;
    const solve::LinearReport report = gmres.solve(multiply, precondition, b, 1e-6, 60, whole(size), x);
    EXPECT_TRUE(report.solved);
    multiply(x, y);
    EXPECT_LE((b - y).norm(), 1.01e-6 * b.norm());
}

TEST(Gmres, SaysThatItHasNotSolved)
{
    const MatrixXd a = unsymmetric(60);
    const VectorXd b = numbers(60);
    solve::Gmres gmres;
    VectorXd x;
    EXPECT_FALSE(
        gmres.solve([&](const VectorXd& v, VectorXd& y) { y = a * v; }, copy, b, 1e-12, 3, whole(60), x).solved);
    EXPECT_LT((b - a * x).norm(), b.norm());  // the best of what it has
}

TEST(Gmres, OfNothingIsNothing)
{
    solve::Gmres gmres;
    VectorXd x = numbers(4);
    EXPECT_TRUE(gmres.solve(copy, copy, VectorXd::Zero(4), 1e-3, 5, whole(4), x).solved);
    EXPECT_EQ(x.norm(), 0);
}

}  // namespace voussoir::testing
