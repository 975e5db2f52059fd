#include "libdda/contact/face_points.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "libdda/geometry/polygon_moments.h"
#include "libdda/model/state.h"

namespace voussoir::contact
{

namespace
{

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Labels of what is added, each with that of the corner before it.
constexpr std::uint32_t on_side = inner_feature, towards_corner = inner_feature | 0x8000,
                        towards_side = inner_feature | 0x40000000;
constexpr double of_corners = 1.0 / 3;  // of the rim: then the mean distance from the middle of a side is its own

/// Share of the area on the rim, by the polygon's second moment over that of its corners: 1/4 of a triangle, 1/3
/// of a parallelogram, 5/12 of a hexagon, 1/2 of a disc. Fitted, so that the mean distance from the centroid is
/// right within 1 % of regular polygons and of rectangles to 1 x 3, and within 2 % of one of 1 x 5.
double share_on_rim(double ratio)
{
    return 1.0 / 3 - 2 * (0.5 - ratio) * (0.5 - ratio);
}

/// A place on the face and the area that it stands for.
struct Place {
    Vector2d at = Vector2d::Zero();  // m, from the centroid
    double weight = 0;               // -, of the area
};

/// Of a set of places: sum of the weights is one.
struct Spread {
    Vector2d mean = Vector2d::Zero();    // m
    Matrix2d second = Matrix2d::Zero();  // m2, about the centroid

    explicit Spread(const std::vector<Place>& places)
    {
        for (const Place& place : places) {
            mean += place.weight * place.at;
            second += place.weight * place.at * place.at.transpose();
        }
    }
    Matrix2d about_mean() const { return second - mean * mean.transpose(); }
};

/// The symmetric T with T A T = B, of positive definite matrices: the geometric mean of A^-1 and B.
Matrix2d map_between(const Matrix2d& a, const Matrix2d& b)
{
    const double of_a = std::sqrt(a.determinant()), of_b = std::sqrt(b.determinant());
    // A^-1 over the root of its determinant is the adjugate of A over the root of that of A.
    Matrix2d adjugate;
    adjugate << a(1, 1), -a(0, 1), -a(1, 0), a(0, 0);
    const Matrix2d sum = adjugate / of_a + b / of_b;
    return std::sqrt(of_b / (of_a * sum.determinant())) * sum;
}

/// The gap as a linear function of the place.
struct LinearGap {
    double at_centroid = 0;             // m
    Vector2d slope = Vector2d::Zero();  // -

    /// @param corners with tributary weights; @param gaps theirs [m]
    LinearGap(const std::vector<Place>& corners, const Spread& spread, const std::vector<PolygonPoint>& points)
    {
        double mean = 0;
        Vector2d covariance = Vector2d::Zero();
        for (std::size_t i = 0; i < corners.size(); ++i) mean += corners[i].weight * points[i].gap;
        for (std::size_t i = 0; i < corners.size(); ++i)
            covariance += corners[i].weight * (points[i].gap - mean) * (corners[i].at - spread.mean);
        slope = spread.about_mean().inverse() * covariance;
        at_centroid = mean - slope.dot(spread.mean);
    }
};

}  // namespace

void add_inner_points(const Vector3d& normal, std::vector<PolygonPoint>& points)
{
    const std::size_t n = points.size();
    const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    const Vector3d origin = points.front().position;
    thread_local std::vector<Vector2d> polygon;  // kept, as what follows: this is done for each face in each step
    thread_local std::vector<Place> corners, rim, inner;
    polygon.clear();
    for (const PolygonPoint& point : points)
        polygon.emplace_back(u.dot(point.position - origin), v.dot(point.position - origin));
    const PolygonMoments moments(polygon);
    if (!(moments.area > 0)) return;

    corners.clear();
    for (std::size_t i = 0; i < n; ++i)
        corners.push_back({polygon[i] - moments.centroid, points[i].area / moments.area});
    rim.clear();
    inner.clear();
    for (const Place& corner : corners) {
        rim.push_back({corner.at, of_corners * corner.weight});
        inner.push_back({corner.at, 0.5 * corner.weight});
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Vector2d &here = corners[i].at, &next = corners[(i + 1) % n].at;
        const double share = 0.5 * std::abs(here.x() * next.y() - here.y() * next.x()) / moments.area;
        rim.push_back({0.5 * (here + next), (1 - of_corners) * share});
        inner.push_back({0.5 * (here + next), 0.5 * share});
    }

    const Spread at_corners(corners), on_rim(rim), inside(inner);
    const Matrix2d second = moments.second / moments.area;
    const double share = share_on_rim(second.trace() / at_corners.second.trace());
    const Vector2d mean = -share / (1 - share) * on_rim.mean;
    const Matrix2d wanted = (second - share * on_rim.second) / (1 - share) - mean * mean.transpose();
    const Matrix2d map = map_between(inside.about_mean(), wanted);
    if (!map.allFinite()) return;

    const LinearGap gap(corners, at_corners, points);
    const Vector3d centroid = origin + moments.centroid.x() * u + moments.centroid.y() * v +
                              (gap.at_centroid - points.front().gap) * normal;
    const auto add = [&](const Vector2d& at, double weight, std::uint32_t label) {
        const double rise = gap.slope.dot(at);
        points.push_back({centroid + at.x() * u + at.y() * v + rise * normal, gap.at_centroid + rise,
                          weight * moments.area, label});
    };
    for (std::size_t i = 0; i < n; ++i) points[i].area = share * rim[i].weight * moments.area;
    for (std::size_t i = n; i < 2 * n; ++i) add(rim[i].at, share * rim[i].weight, points[i - n].feature | on_side);
    for (std::size_t i = 0; i < 2 * n; ++i)
        add(mean + map * (inner[i].at - inside.mean), (1 - share) * inner[i].weight,
            points[i % n].feature | (i < n ? towards_corner : towards_side));
}

void add_inner_points(const Vector2d& /*normal*/, std::vector<PolygonPointIn<2>>& points)
{
    const PolygonPointIn<2> first = points[0], second = points[1];
    const double length = first.area + second.area;
    points[0].area = points[1].area = 7.0 / 90 * length;
    const auto add = [&](double part, double weight, std::uint32_t label) {
        points.push_back({(1 - part) * first.position + part * second.position,
                          (1 - part) * first.gap + part * second.gap, weight * length, inner_feature | label});
    };
    add(0.25, 32.0 / 90, first.feature);
    add(0.75, 32.0 / 90, second.feature);
    add(0.5, 12.0 / 90, first.feature << 8 | second.feature << 4);
}

}  // namespace voussoir::contact
