#include "libdda/analysis/integrator_accuracy.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace voussoir
{

IntegratorAccuracy integrator_accuracy(double angle, double end_share)
{
    // v1 = v0 + h a, q1 = q0 + h (v0 + v1) / 2, a = -omega^2 ((1 - theta) q0 + (1 + theta) q1) / 2.
    const double x2 = angle * angle;
    const double divisor = 1 + 0.25 * (1 + end_share) * x2;
    const double q_of_q = (1 - 0.25 * (1 - end_share) * x2) / divisor, q_of_v = 1 / divisor;
    const double half_trace = 0.5 * (q_of_q + 2 * q_of_v - 1), determinant = 2 * q_of_v - q_of_q;
    const std::complex<double> root = std::sqrt(std::complex<double>(half_trace * half_trace - determinant));
    // The eigenvalue that decays more slowly governs.
    const std::complex<double> plus = half_trace + root, minus = half_trace - root;
    const std::complex<double> slow = std::abs(plus) >= std::abs(minus) ? plus : minus;
    const double decay = std::max(0.0, -std::log(std::abs(slow))), turn = std::abs(std::arg(slow));
    if (root.imag() == 0) return {1, angle / std::max(turn, 1e-300) - 1};
    const double length = std::hypot(decay, turn);
    return {decay / length, angle / length - 1};
}

}  // namespace voussoir
