#include "libdda/model/hysteresis.h"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace voussoir
{

namespace
{

using std::numbers::pi;

constexpr int fewest = 2, most = 24;                           // branches
constexpr int points_per_branch = 12;                          // at which the ratio is judged
constexpr double reaches[] = {1, 1.3, 1.7, 2.2, 2.8, 3.5, 5};  // of the relaxation times beyond the band, a factor
constexpr int reweightings = 40;

/// `count` values from `low` to `high`, evenly spaced in their logarithms.
std::vector<double> spread(double low, double high, int count)
{
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, i / (count - 1.0)));
    return values;
}

/// The largest |ratio of the branches / ratio asked - 1| at some frequencies [1/s].
double worst_of(const std::vector<MaxwellBranch>& branches, double ratio, const std::vector<double>& omegas)
{
    double worst = 0;
    for (const double omega : omegas)
        worst = std::max(worst, std::abs(damping_ratio_of(branches, omega) / ratio - 1));
    return worst;
}

/// Shares for given relaxation times: Im M = 2 ratio Re M is linear in them. Least squares whose weights grow
/// where the error is large (Lawson), so that the largest error is small.
std::vector<MaxwellBranch> fitted(double ratio, const std::vector<double>& times,
                                  const std::vector<double>& omegas)
{
    const auto rows = static_cast<Eigen::Index>(omegas.size()), columns = static_cast<Eigen::Index>(times.size());
    Eigen::MatrixXd matrix(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i)
        for (Eigen::Index j = 0; j < columns; ++j) {
            const double x = omegas[static_cast<std::size_t>(i)] * times[static_cast<std::size_t>(j)];
            matrix(i, j) = (x - 2 * ratio * x * x) / (1 + x * x) / (2 * ratio);
        }
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(rows, 1.0 / static_cast<double>(rows));
    std::vector<MaxwellBranch> best;
    double least = INFINITY;
    for (int round = 0; round < reweightings; ++round) {
        const Eigen::VectorXd root = weights.cwiseSqrt();
        const Eigen::VectorXd shares = (root.asDiagonal() * matrix).colPivHouseholderQr().solve(root);
        if (!shares.allFinite() || shares.minCoeff() <= 0) break;
        std::vector<MaxwellBranch> branches;
        branches.reserve(times.size());
        for (Eigen::Index j = 0; j < columns; ++j)
            branches.push_back({shares[j], times[static_cast<std::size_t>(j)]});
        const double worst = worst_of(branches, ratio, omegas);
        if (worst < least) best = branches;
        least = std::min(least, worst);
        weights = weights.cwiseProduct((matrix * shares - Eigen::VectorXd::Ones(rows)).cwiseAbs());
        if (!(weights.sum() > 0)) break;
        weights /= weights.sum();
    }
    return best;
}

}  // namespace

std::complex<double> modulus_over_rest(const std::vector<MaxwellBranch>& branches, double omega)
{
    std::complex<double> modulus = 1;
    for (const MaxwellBranch& branch : branches) {
        const std::complex<double> x(0, omega * branch.time);
        modulus += branch.share * x / (1.0 + x);
    }
    return modulus;
}

double damping_ratio_of(const std::vector<MaxwellBranch>& branches, double omega)
{
    const std::complex<double> modulus = modulus_over_rest(branches, omega);
    return 0.5 * modulus.imag() / modulus.real();
}

std::vector<MaxwellBranch> hysteretic_branches(double ratio, double lowest, double highest)
{
    const bool allowed = ratio > 0 && ratio <= most_hysteretic_ratio && lowest > 0 && highest > lowest &&
                         highest <= widest_band * lowest;
    if (!allowed) return {};
    for (int count = fewest; count <= most; ++count) {
        const std::vector<double> omegas = spread(2 * pi * lowest, 2 * pi * highest, points_per_branch * count);
        for (const double reach : reaches) {
            const std::vector<double> times =
                spread(1 / (2 * pi * highest * reach), reach / (2 * pi * lowest), count);
            std::vector<MaxwellBranch> branches = fitted(ratio, times, omegas);
            if (!branches.empty() && worst_of(branches, ratio, omegas) <= hysteretic_ripple) return branches;
        }
    }
    return {};
}

}  // namespace voussoir
