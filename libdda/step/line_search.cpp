#include "libdda/step/line_search.h"

#include <cmath>
#include <limits>

namespace voussoir::step
{

namespace
{

/// Unbalanced force along the direction at d + s direction: with the bound frozen, the derivative of the
/// potential.
template <class K>
double slope_at(double s, FrictionBound bound, int threads, StepSystem<K>& system)
{
    system.trial = system.d + s * system.direction;
    evaluate_contacts(system.trial, bound, threads, system.contacts);
    if (!evaluate_residual(system.trial, system)) return std::numeric_limits<double>::infinity();
    return system.residual.dot(system.direction);
}

}  // namespace

template <class K>
Reach line_search(double slope_0, FrictionBound bound, bool strict, int threads, StepSystem<K>& system)
{
    const double enough = strict ? 0 : 0.5 * std::abs(slope_0);
    double high = 1, slope_high = slope_at(high, bound, threads, system);
    if (slope_high <= enough) return {high, true};
    double low = 0, slope_low = slope_0;
    for (int evaluation = 1; evaluation < 12; ++evaluation) {
        double s =
            std::isfinite(slope_high) ? low - slope_low * (high - low) / (slope_high - slope_low) : 0.5 * high;
        if (s - low < 0.1 * (high - low) || high - s < 0.1 * (high - low)) s = 0.5 * (low + high);
        const double slope = slope_at(s, bound, threads, system);
        if (slope <= enough && slope >= -std::abs(0.5 * slope_0)) return {s, true};
        if (slope > 0) {
            high = s;
            slope_high = slope;
        } else {
            low = s;
            slope_low = slope;
        }
    }
    return {low > 0 ? low : high, false};
}

#define VOUSSOIR_INSTANTIATE(K) template Reach line_search(double, FrictionBound, bool, int, StepSystem<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
