// How far points reach along a direction.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>

namespace voussoir
{

/// Distance between the first and the last of some points along a direction [m]; no points: minus infinity.
/// @param direction unit vector, in space or in the plane
/// @param position gives the place of one of `points`, if that is not the point itself
template <class Vector, class Points, class Position = std::identity>
double extent_along(const Vector& direction, const Points& points, Position position = {})
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& point : points) {
        const double place = direction.dot(std::invoke(position, point));
        low = std::min(low, place);
        high = std::max(high, place);
    }
    return high - low;
}

}  // namespace voussoir
