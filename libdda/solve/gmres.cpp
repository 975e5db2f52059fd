#include "libdda/solve/gmres.h"

#include <Eigen/Dense>
#include <cmath>

namespace voussoir::solve
{

using Eigen::VectorXd;

LinearReport Gmres::solve(const Operator& multiply, const Operator& precondition, const VectorXd& b,
                          double tolerance, int max_iterations, VectorXd& x)
{
    LinearReport report;
    const double size = b.norm();
    x.setZero(b.size());
    if (size == 0) {
        report.solved = true;
        return report;
    }
    upper_.setZero(max_iterations + 1, max_iterations);
    rest_.setZero(max_iterations + 1);
    cosine_.resize(max_iterations);
    sine_.resize(max_iterations);
    basis_.resize(max_iterations + 1);
    basis_[0] = b / size;
    rest_[0] = size;
    int k = 0;
    while (k < max_iterations && std::abs(rest_[k]) > tolerance * size) {
        precondition(basis_[k], z_);
        multiply(z_, w_);
        for (int i = 0; i <= k; ++i) {
            upper_(i, k) = w_.dot(basis_[i]);
            w_ -= upper_(i, k) * basis_[i];
        }
        const double left = w_.norm();
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
        if (left > 0) basis_[k + 1] = w_ / left;
        ++k;
        ++report.iterations;
        if (left == 0) break;
    }
    report.solved = std::abs(rest_[k]) <= tolerance * size;
    const VectorXd y = upper_.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(rest_.head(k));
    z_.setZero(b.size());
    for (int i = 0; i < k; ++i) z_ += y[i] * basis_[i];
    precondition(z_, x);
    return report;
}

}  // namespace voussoir::solve
