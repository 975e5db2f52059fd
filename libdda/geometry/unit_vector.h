// Directions as people write them, of any length.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace voussoir
{

/// The vector divided by its largest component where the square of its length is too large or too small for a
/// number; otherwise the vector itself, bit for bit. Zero, and what is not finite, stay as they are.
template <class Vector>
Vector of_measurable_length(const Vector& v)
{
    const double largest = v.cwiseAbs().maxCoeff();
    if (std::isnormal(v.squaredNorm()) || !(largest > 0) || !std::isfinite(largest)) return v;
    return v / largest;
}

/// The vector of length 1 in this direction; zero stays zero.
template <class Vector>
Vector unit_vector(const Vector& v)
{
    return of_measurable_length(v).normalized();
}

}  // namespace voussoir
