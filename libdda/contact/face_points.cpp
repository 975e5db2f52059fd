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
constexpr std::uint32_t towards_corner = inner_feature | 0x8000, middle_of_side = inner_feature | 0x40000000;

/// The ends of a line where a face is cut bear nothing: what happens beside the line is of second order then.
template <int D>
bool is_on_line(const PolygonPointIn<D>& corner)
{
    return (corner.feature & on_cut_line) == on_cut_line;
}

constexpr double alike = 1e-3;     // of the area, that of the corners' parts: convex but for rounding
constexpr double thinnest = 1e-6;  // of needles, second moment across by that along

// Of the area, how much is at the corners, and how much at the middles of sides. A side of a rectangle has twice
// what its corners have on the average, so that a stone which presses on it alone resists a couple as an even line
// does, by a quarter of its length. With a third of the area at the rim the mean distance from the centroid is
// right: that is exact for a disc, and within a half of one per cent for regular polygons and rectangles.
constexpr double at_corners = 1.0 / 9, at_sides = 2 * at_corners;

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
    /// Of the area, that of the triangle of a side and the centroid, as far as its ends are corners: a side that
    /// is as good as none, where a corner is cut off, bears as good as nothing.
    double weight_of_side(std::size_t i) const
    {
        const std::size_t next = (i + 1) % count;
        const Vector2d &from = corners[i].at, &to = corners[next].at;
        const double triangle = 0.5 * std::abs(from.x() * to.y() - from.y() * to.x()) / area;
        return 0.5 * (!is_on_line(points[i]) + !is_on_line(points[next])) * triangle;
    }
    void add(const Place& place, std::uint32_t label)
    {
        const double rise = slope.dot(place.at);
        points.push_back({centroid + place.at.x() * u + place.at.y() * v + rise * normal, gap + rise,
                          place.weight * area, label});
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
    thread_local std::vector<Place> rim;  // corners, then the middles of the sides behind them
    rim.clear();
    double share = 0;
    const auto add_to_rim = [&](const Vector2d& at, double weight) {
        rim.push_back({at, weight});
        share += weight;
    };
    const auto weight_of = [&](std::size_t i) {
        return is_on_line(points[i % n]) ? 0 : at_corners * face.corners[i % n].weight;
    };
    for (std::size_t i = 0; i < n; ++i) add_to_rim(face.corners[i].at, weight_of(i));
    for (std::size_t i = 0; i < n; ++i)
        add_to_rim(0.5 * (face.corners[i].at + face.corners[(i + 1) % n].at), at_sides * face.weight_of_side(i));

    // What lies inside, towards each corner, has the first and second moments that the rim leaves it.
    const Spread at_rim(rim), inside(face.corners);
    const Vector2d mean = -at_rim.mean / (1 - share);
    const Matrix2d second = (face.second - at_rim.second) / (1 - share) - mean * mean.transpose();
    const Matrix2d map = map_between(inside.about_mean(), second);
    if (!map.allFinite()) return;

    for (std::size_t i = 0; i < n; ++i) points[i].area = rim[i].weight * face.area;
    for (std::size_t i = 0; i < n; ++i) face.add(rim[n + i], points[i].feature | middle_of_side);
    for (std::size_t i = 0; i < n; ++i) {
        const Place& corner = face.corners[i];
        face.add({mean + map * (corner.at - inside.mean), (1 - share) * corner.weight},
                 points[i].feature | towards_corner);
    }
}

void add_inner_points(const Vector2d& /*normal*/, std::vector<PolygonPointIn<2>>& points)
{
    // A rectangle from its side: an end has two corners and the middle between them, and so on.
    const PolygonPointIn<2> first = points[0], second = points[1];
    const double length = first.area + second.area, of_end = 0.5 * (at_corners + 0.5 * at_sides);
    const double at_first = is_on_line(first) ? 0 : of_end, at_second = is_on_line(second) ? 0 : of_end;
    const double between = 0.5 * (at_first + at_second), inside = 1 - at_first - at_second - between;
    points[0].area = at_first * length;
    points[1].area = at_second * length;
    // Parts of the way from one end to the other.
    const double mean = 0.5 * (at_first - at_second) / inside;
    const double away = std::sqrt((1.0 / 12 - 0.25 * (at_first + at_second)) / inside - mean * mean);
    const auto add = [&](double part, double weight, std::uint32_t label) {
        points.push_back({(1 - part) * first.position + part * second.position,
                          (1 - part) * first.gap + part * second.gap, weight * length, label});
    };
    add(0.5, between, first.feature | middle_of_side);
    add(0.5 + mean - away, 0.5 * inside, first.feature | towards_corner);
    add(0.5 + mean + away, 0.5 * inside, second.feature | towards_corner);
}

}  // namespace voussoir::contact
