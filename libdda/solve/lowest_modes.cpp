#include "libdda/solve/lowest_modes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace voussoir::solve
{

namespace
{

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double shift_share = 1e-12;  // of the largest K_ii / M_ii
constexpr int guard_vectors = 2;       // of a block beyond the modes that are wanted
constexpr int max_basis = 240;         // vectors
constexpr double tolerance =
    1e-5;  // residual / eigenvalue; the relative error of the eigenvalue is of the order of its square
constexpr double dependent = 1e-12;  // of a vector's length: what is left of it is rounding

using Block = Eigen::Map<const MatrixXd>;

MatrixXd times_mass(const std::vector<double>& mass, int n, const MatrixXd& x)
{
    MatrixXd product(x.rows(), x.cols());
    for (int row = 0; row < x.rows() / n; ++row)
        product.middleRows(n * row, n).noalias() =
            Block(mass.data() + row * n * n, n, n) * x.middleRows(n * row, n);
    return product;
}

/// a b, column by column: Eigen gives products of large matrices to threads that may be busy elsewhere.
template <class Left>
MatrixXd by_columns(const Left& a, const MatrixXd& b)
{
    MatrixXd product(a.rows(), b.cols());
    for (int j = 0; j < b.cols(); ++j) product.col(j).noalias() = a * b.col(j);
    return product;
}

/// Largest K_ii / M_ii of the rows that have mass: the scale of the eigenvalues [1/s2].
double largest_ratio(const BlockMatrix& stiffness, const std::vector<double>& mass)
{
    const int n = stiffness.block_size;
    double most = 0;
    for (int row = 0; row < stiffness.rows(); ++row)
        for (int k = 0; k < n; ++k) {
            const double m = mass[row * n * n + k * n + k];
            if (m > 0) most = std::max(most, stiffness.block(stiffness.diagonal(row))[k * n + k] / m);
        }
    return most;
}

BlockMatrix shifted(const BlockMatrix& stiffness, const std::vector<double>& mass, double shift)
{
    BlockMatrix sum = stiffness;
    const int size = stiffness.block_size * stiffness.block_size;
    for (int row = 0; row < sum.rows(); ++row) {
        double* block = sum.block(sum.diagonal(row));
        for (int k = 0; k < size; ++k) block[k] += shift * mass[row * size + k];
    }
    return sum;
}

/// The Krylov space of the inverse, block by block.
class Lanczos
{
 public:
    Lanczos(const std::vector<double>& mass, int block_size, int wanted, CholmodFactor& factor)
        : mass_(mass), n_(block_size), wanted_(wanted), factor_(factor)
    {
    }

    /// @param size unknowns. @returns whether the wanted vectors converged
    bool run(int size)
    {
        MatrixXd next = first_block(size);
        basis_.resize(size, 0);
        while (true) {
            if (next.cols() == 0) return basis_.cols() > 0;  // the space is invariant: nothing is missing
            append(next);
            MatrixXd image;
            if (!factor_.solve(times_mass(mass_, n_, basis_.rightCols(newest_)), image)) return false;
            project(image);
            next = orthogonalised(image);
            if (next.cols() == 0 || residual(image, next) < tolerance) return solve_small();
            if (basis_.cols() + next.cols() > max_basis) return false;
        }
    }

    VectorXd values;  // (kept) of the inverse, falling
    MatrixXd shapes;  // (unknowns x kept)

 private:
    MatrixXd first_block(int size) const
    {
        std::mt19937_64 random(1);  // its numbers are fixed by the standard
        MatrixXd start(size, std::min(wanted_ + guard_vectors, size));
        for (double& x : start.reshaped()) x = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
        MatrixXd image;
        if (!factor_.solve(times_mass(mass_, n_, start), image)) return {};
        return orthogonalised(image);
    }

    void append(const MatrixXd& block)
    {
        newest_ = static_cast<int>(block.cols());
        basis_.conservativeResize(Eigen::NoChange, basis_.cols() + newest_);
        basis_.rightCols(newest_) = block;
    }

    /// Enlarges V^T M (K + sM)^-1 M V by the newest columns.
    void project(const MatrixXd& image)
    {
        const auto k = basis_.cols();
        const MatrixXd columns = by_columns(basis_.transpose(), times_mass(mass_, n_, image));
        projected_.conservativeResize(k, k);
        projected_.rightCols(newest_) = columns;
        projected_.bottomRows(newest_) = columns.transpose();
    }

    /// What is new in the images, orthonormal in M; columns that are none are dropped.
    MatrixXd orthogonalised(const MatrixXd& image) const
    {
        MatrixXd kept(image.rows(), 0);
        for (int j = 0; j < image.cols(); ++j) {
            VectorXd x = image.col(j);
            const double before = std::sqrt(x.dot(times_mass(mass_, n_, x).col(0)));
            for (int pass = 0; pass < 2; ++pass) {
                const VectorXd weighted = times_mass(mass_, n_, x);
                if (basis_.cols() > 0) x -= basis_ * (basis_.transpose() * weighted);
                if (kept.cols() > 0) x -= kept * (kept.transpose() * times_mass(mass_, n_, x));
            }
            const double length = std::sqrt(x.dot(times_mass(mass_, n_, x).col(0)));
            if (!(length > dependent * before)) continue;
            kept.conservativeResize(Eigen::NoChange, kept.cols() + 1);
            kept.rightCols(1) = x / length;
        }
        return kept;
    }

    bool solve_small()
    {
        const Eigen::SelfAdjointEigenSolver<MatrixXd> small(0.5 * (projected_ + projected_.transpose()));
        if (small.info() != Eigen::Success) return false;
        const auto kept = std::min<Eigen::Index>(wanted_, small.eigenvalues().size());
        values = small.eigenvalues().tail(kept).reverse();
        shapes = by_columns(basis_, small.eigenvectors().rightCols(kept).rowwise().reverse());
        return true;
    }

    /// Largest |(K+sM)^-1 M x - theta x| / theta of the wanted vectors: what the image has outside the basis.
    double residual(const MatrixXd& image, const MatrixXd& next)
    {
        const Eigen::SelfAdjointEigenSolver<MatrixXd> small(0.5 * (projected_ + projected_.transpose()));
        const auto k = small.eigenvalues().size();
        if (small.info() != Eigen::Success || k < wanted_) return INFINITY;
        const MatrixXd outside = by_columns(next.transpose(), times_mass(mass_, n_, image));
        double most = 0;
        for (auto i = k - wanted_; i < k; ++i) {
            const double left = (outside * small.eigenvectors().col(i).tail(newest_)).norm();
            most = std::max(most, left / std::abs(small.eigenvalues()[i]));
        }
        return most;
    }

    const std::vector<double>& mass_;
    int n_ = 0, wanted_ = 0;
    CholmodFactor& factor_;
    MatrixXd basis_, projected_;
    int newest_ = 0;  // columns of the basis
};

}  // namespace

LowestModes lowest_modes(const BlockMatrix& stiffness, const std::vector<double>& mass, int count,
                         CholmodFactor& factor)
{
    LowestModes modes;
    const double scale = largest_ratio(stiffness, mass);
    const double shift = shift_share * scale;
    if (!(scale > 0) || !std::isfinite(scale) || !factor.factorise(shifted(stiffness, mass, shift))) return modes;
    Lanczos lanczos(mass, stiffness.block_size, count, factor);
    if (!lanczos.run(stiffness.block_size * stiffness.rows())) return modes;
    modes.eigenvalues = 1 / lanczos.values.array() - shift;
    for (double& value : modes.eigenvalues)
        if (value < vanishing_eigenvalue * scale) value = 0;
    modes.shapes = std::move(lanczos.shapes);
    modes.converged = true;
    return modes;
}

}  // namespace voussoir::solve
