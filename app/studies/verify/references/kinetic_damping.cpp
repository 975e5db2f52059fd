#include "app/studies/verify/references/kinetic_damping.h"

#include <cmath>

namespace voussoir::app::studies::verify::references
{

double displacement_with_factor(double acceleration, double factor, double time_step, long steps)
{
    const double n = static_cast<double>(steps), h2 = time_step * time_step;
    if (factor == 1) return 0.5 * acceleration * h2 * n * n;
    const double powers = (1 - std::pow(factor, n)) / (1 - factor);  // 1 + k + ... + k^(n-1)
    return acceleration * h2 * (factor / (1 - factor) * (n - powers) + 0.5 * n);
}

double displacement_with_rate(double acceleration, double rate, double time)
{
    return acceleration / rate * (time + std::expm1(-rate * time) / rate);
}

}  // namespace voussoir::app::studies::verify::references
