#include "libdda/contact/face_points.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <span>

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
constexpr std::uint32_t towards_corner = inner_feature | 0x8000, towards_side = inner_feature | 0x40000000;

constexpr double alike = 1e-3;     // of the area, that of the corners' parts: convex but for rounding
constexpr double thinnest = 1e-6;  // of needles, second moment across by that along

/// Share of the area at the corners, by the polygon's second moment over that of its corners: 1/4 of a triangle,
/// 1/3 of a parallelogram, 5/12 of a hexagon, 1/2 of a disc. Fitted, so that the mean distance from the centroid
/// is right.
double share_of_corners(double ratio)
{
    return ratio - 3.0 / 16;
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

    explicit Spread(std::span<const Place> places)
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

/// A face in its plane: places from its centroid, shares of its area, and the gap, linear over it.
struct Face {
    Vector3d u, v, normal, centroid = Vector3d::Zero();
    double area = 0;                     // m2
    bool is_sound = false;               // no needle, and convex: else it rests on its corners
    Matrix2d second = Matrix2d::Zero();  // m2, about the centroid, over the area
    double gap = 0;                      // m, at the centroid
    Vector2d slope = Vector2d::Zero();   // -, of the gap
    std::size_t count;                   // of its corners
    std::span<Place> corners;
    std::vector<PolygonPoint>& points;

    /// @param points corners with tributary areas
    Face(const Vector3d& normal, std::vector<PolygonPoint>& points)
        : u(normal.unitOrthogonal()), v(normal.cross(u)), normal(normal), count(points.size()), points(points)
    {
        thread_local std::vector<Vector2d>
            polygon;  // kept, as places are: this is done for each face in each step
        thread_local std::vector<Place> places;
        polygon.clear();
        places.clear();
        const Vector3d origin = points.front().position;
        for (const PolygonPoint& point : points)
            polygon.emplace_back(u.dot(point.position - origin), v.dot(point.position - origin));
        const PolygonMoments moments(polygon);
        area = moments.area;
        if (!(area > 0)) return;
        second = moments.second / area;
        double share = 0;
        for (std::size_t i = 0; i < count; ++i) {
            places.push_back({polygon[i] - moments.centroid, points[i].area / area});
            share += places.back().weight;
        }
        for (Place& place : places) place.weight /= share;
        corners = places;
        is_sound =
            second.determinant() > thinnest * second.trace() * second.trace() && std::abs(share - 1) < alike;
        if (!is_sound) return;
        find_gap();
        centroid =
            origin + moments.centroid.x() * u + moments.centroid.y() * v + (gap - points.front().gap) * normal;
    }
    void set_corner(std::size_t corner, double weight) { points[corner].area = weight * area; }
    void add(const Place& place, double share, std::uint32_t label)
    {
        const double rise = slope.dot(place.at);
        points.push_back({centroid + place.at.x() * u + place.at.y() * v + rise * normal, gap + rise,
                          share * place.weight * area, label});
    }
    void find_gap()
    {
        const Spread spread(corners);
        double mean = 0;
        Vector2d covariance = Vector2d::Zero();
        for (std::size_t i = 0; i < count; ++i) mean += corners[i].weight * points[i].gap;
        for (std::size_t i = 0; i < count; ++i)
            covariance += corners[i].weight * (points[i].gap - mean) * (corners[i].at - spread.mean);
        slope = spread.about_mean().inverse() * covariance;
        gap = mean - slope.dot(spread.mean);
    }
};

}  // namespace

void add_inner_points(const Vector3d& normal, std::vector<PolygonPoint>& points)
{
    Face face(normal, points);
    if (!face.is_sound) return;
    const std::size_t n = face.count;
    thread_local std::vector<Place> inner;
    inner.clear();
    for (const Place& corner : face.corners) inner.push_back({corner.at, 0.5 * corner.weight});
    double sides = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vector2d &here = face.corners[i].at, &next = face.corners[(i + 1) % n].at;
        inner.push_back({0.5 * (here + next), std::abs(here.x() * next.y() - here.y() * next.x())});
        sides += inner.back().weight;
    }
    for (std::size_t i = n; i < 2 * n; ++i) inner[i].weight *= 0.5 / sides;

    // What lies inside has the first and second moments that the corners leave it.
    const Spread at_corners(face.corners), inside(inner);
    const double share = share_of_corners(face.second.trace() / at_corners.second.trace());
    const Vector2d mean = -share / (1 - share) * at_corners.mean;
    const Matrix2d second = (face.second - share * at_corners.second) / (1 - share) - mean * mean.transpose();
    const Matrix2d map = map_between(inside.about_mean(), second);
    if (!map.allFinite()) return;

    for (std::size_t i = 0; i < n; ++i) face.set_corner(i, share * face.corners[i].weight);
    for (std::size_t i = 0; i < 2 * n; ++i)
        face.add({mean + map * (inner[i].at - inside.mean), inner[i].weight}, 1 - share,
                 points[i % n].feature | (i < n ? towards_corner : towards_side));
}

void add_inner_points(const Vector2d& /*normal*/, std::vector<PolygonPointIn<2>>& points)
{
    const PolygonPointIn<2> first = points[0], second = points[1];
    const double length = first.area + second.area;
    const double share = share_of_corners(1.0 / 3), half_way = std::sqrt((1 - 3 * share) / (1 - share)) / 3;
    points[0].area = points[1].area = 0.5 * share * length;
    const auto add = [&](double part, double weight, std::uint32_t label) {
        points.push_back({(1 - part) * first.position + part * second.position,
                          (1 - part) * first.gap + part * second.gap, weight * (1 - share) * length,
                          inner_feature | label});
    };
    add(0.5 - half_way, 0.375, first.feature);
    add(0.5 + half_way, 0.375, second.feature);
    add(0.5, 0.25, first.feature << 8 | second.feature << 4);
}

}  // namespace voussoir::contact
