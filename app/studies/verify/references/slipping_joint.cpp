#include "app/studies/verify/references/slipping_joint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace voussoir::app::studies::verify::references
{

SlipCoefficients slip_coefficients(double strength_ratio)
{
    using std::numbers::pi;
    const double s = std::min(strength_ratio, 1.0), p = std::asin(s), rest = pi / 2 - p;
    const double passed = 4 / pi * (p / 2 - std::sin(2 * p) / 4 + s * s * rest);
    const double returned = 4 / pi * (rest / 2 + std::sin(2 * p) / 4 - 2 * s * std::cos(p) + s * s * rest);
    const double taken = 8 / pi * s * (std::cos(p) - s * rest);
    return {std::sqrt(passed), std::sqrt(std::max(0.0, returned)), std::sqrt(std::max(0.0, taken))};
}

}  // namespace voussoir::app::studies::verify::references
