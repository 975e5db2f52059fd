#include "libdda/geometry/polygon_moments.h"

#include <cmath>

namespace voussoir
{

using Eigen::Vector2d;

PolygonMoments::PolygonMoments(std::span<const Vector2d> corners)
{
    // By triangles from the first corner, so that large coordinates cancel nothing.
    const Vector2d& origin = corners.front();
    Vector2d first = Vector2d::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Vector2d p = corners[i] - origin, q = corners[i + 1] - origin, sum = p + q;
        const double of_triangle = 0.5 * std::abs(p.x() * q.y() - p.y() * q.x());
        area += of_triangle;
        first += of_triangle / 3 * sum;
        second += of_triangle / 12 * (p * p.transpose() + q * q.transpose() + sum * sum.transpose());
    }
    centroid = origin;
    if (area == 0) return;
    centroid += first / area;
    second -= first * first.transpose() / area;
}

}  // namespace voussoir
