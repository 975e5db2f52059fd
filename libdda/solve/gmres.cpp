#include "libdda/solve/gmres.h"

#include <Eigen/Dense>
#include <cmath>

namespace voussoir::solve
{

using Eigen::VectorXd;

double Gmres::orthogonalise(int k)
{
    for (int i = 0; i <= k; ++i) {
        upper_(i, k) = w_.dot(basis_[i]);
        w_ -= upper_(i, k) * basis_[i];
    }
    return w_.squaredNorm();
}

double Gmres::orthogonalise_together(int k, Pieces& pieces)
{
    shares_.resize(k + 1, static_cast<Eigen::Index>(pieces.count()));
    pieces.each([&](Eigen::Index from, Eigen::Index count) {
        const auto w = w_.segment(from, count);
        auto share = shares_.col(static_cast<Eigen::Index>(pieces.at(from)));
        for (int i = 0; i <= k; ++i) share[i] = w.dot(basis_[i].segment(from, count));
    });
    auto column = upper_.col(k).head(k + 1);
    column.setZero();
    for (Eigen::Index piece = 0; piece < shares_.cols(); ++piece) column += shares_.col(piece);
    return pieces.sum([&](Eigen::Index from, Eigen::Index count) {
        auto w = w_.segment(from, count);
        for (int i = 0; i <= k; ++i) w -= upper_(i, k) * basis_[i].segment(from, count);
        return w.squaredNorm();
    });
}

LinearReport Gmres::solve(const Operator& multiply, const Operator& precondition, const VectorXd& b,
                          double tolerance, int max_iterations, Pieces pieces, VectorXd& x)
{
    LinearReport report;
    const double size = std::sqrt(pieces.dot(b, b));
    x.setZero(b.size());
    if (size == 0) {
        report.solved = true;
        return report;
    }
    upper_.resize(max_iterations + 1, max_iterations);  // what is used of it is written first
    rest_.setZero(max_iterations + 1);
    cosine_.resize(max_iterations);
    sine_.resize(max_iterations);
    basis_.resize(max_iterations + 1);
    const bool keeps = pieces.count() > 1;
    if (keeps) improved_.resize(max_iterations);
    const auto add_to_basis = [&](int k, const VectorXd& v, double length) {
        basis_[k].resize(b.size());
        pieces.each([&](Eigen::Index from, Eigen::Index count) {
            basis_[k].segment(from, count) = v.segment(from, count) / length;
        });
    };
    add_to_basis(0, b, size);
    rest_[0] = size;
    int k = 0;
    while (k < max_iterations && std::abs(rest_[k]) > tolerance * size) {
        VectorXd& z = keeps ? improved_[k] : z_;
        precondition(basis_[k], z);
        multiply(z, w_);
        const double left = std::sqrt(keeps ? orthogonalise_together(k, pieces) : orthogonalise(k));
        for (int i = 0; i < k; ++i) {
            const double above = upper_(i, k), below = upper_(i + 1, k);
            upper_(i, k) = cosine_[i] * above + sine_[i] * below;
            upper_(i + 1, k) = cosine_[i] * below - sine_[i] * above;
        }
        const double length = std::hypot(upper_(k, k), left);
        if (!(length > 0) || !std::isfinite(length)) break;
        cosine_[k] = upper_(k, k) / length;
        sine_[k] = left / length;
        upper_(k, k) = length;
        rest_[k + 1] = -sine_[k] * rest_[k];
        rest_[k] *= cosine_[k];
        if (left > 0) add_to_basis(k + 1, w_, left);
        ++k;
        ++report.iterations;
        if (left == 0) break;
    }
    report.solved = std::abs(rest_[k]) <= tolerance * size;
    const VectorXd y = upper_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(rest_.head(k));
    const std::vector<VectorXd>& all = keeps ? improved_ : basis_;
    VectorXd& sum = keeps ? x : z_;
    sum.resize(b.size());
    pieces.each([&](Eigen::Index from, Eigen::Index count) {
        sum.segment(from, count).setZero();
        for (int i = 0; i < k; ++i) sum.segment(from, count) += y[i] * all[i].segment(from, count);
    });
    if (!keeps) precondition(z_, x);
    return report;
}

}  // namespace voussoir::solve
