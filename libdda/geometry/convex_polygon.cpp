#include "libdda/geometry/convex_polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libdda/errors.h"
#include "libdda/geometry/plane.h"

namespace voussoir
{

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{

double cross(const Vector2d& a, const Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

double diagonal_of(const std::vector<Vector2d>& vertices)
{
    Vector2d lower = vertices.front(), upper = lower;
    for (const Vector2d& x : vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    return (upper - lower).norm();
}

double twice_area(const std::vector<Vector2d>& loop)
{
    double sum = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
    return sum;
}

/// Distance of corner i to the left of the line from its predecessor to its successor, negated: > 0 bulges out.
double bulge(const std::vector<Vector2d>& loop, std::size_t i)
{
    const Vector2d& before = loop[(i + loop.size() - 1) % loop.size()];
    const Vector2d along = loop[(i + 1) % loop.size()] - before;
    const double length = along.norm();
    return length > 0 ? -cross(along, loop[i] - before) / length : 0;
}

void drop_straight_corners(std::vector<Vector2d>& loop, double tolerance)
{
    for (std::size_t i = 0; i < loop.size() && loop.size() > 2;)
        if (std::abs(bulge(loop, i)) <= tolerance) {
            loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
            i = i > 0 ? i - 1 : 0;
        } else {
            ++i;
        }
}

}  // namespace

ConvexPolygon make_convex_polygon(std::vector<Vector2d> vertices, const std::string& name, double tolerance)
{
    for (const Vector2d& x : vertices)
        if (!x.allFinite()) throw InputError(name, "a coordinate that is not a number", "give finite coordinates");
    if (vertices.size() < 3)
        throw InputError(name, std::to_string(vertices.size()) + " corners", "an outline has at least three");
    const double size = diagonal_of(vertices);
    if (twice_area(vertices) < 0) std::reverse(vertices.begin(), vertices.end());
    drop_straight_corners(vertices, tolerance * size);
    if (vertices.size() < 3 || twice_area(vertices) <= tolerance * size * size)
        throw InputError(name, "an outline without area", "give a polygon that encloses one");
    double turned = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (bulge(vertices, i) < 0)
            throw InputError(name, "a corner that points inwards", "split the outline into convex parts");
        const Vector2d before = vertices[i] - vertices[(i + vertices.size() - 1) % vertices.size()];
        const Vector2d after = vertices[(i + 1) % vertices.size()] - vertices[i];
        turned += std::atan2(cross(before, after), before.dot(after));
    }
    if (turned > 7)  // more than once round
        throw InputError(name, "an outline that winds around itself", "give the corners in order");
    return {std::move(vertices)};
}

ConvexPolygon make_rectangle(const Vector2d& lower, const Vector2d& upper)
{
    return make_convex_polygon({lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}, "rectangle");
}

ConvexPolygon outline_of(const ConvexPolyhedron& prism, double& depth, const std::string& name, double tolerance)
{
    double low = INFINITY, high = -INFINITY, size = 0;
    for (const Vector3d& x : prism.vertices) {
        low = std::min(low, x.y());
        high = std::max(high, x.y());
        size = std::max(size, (x - prism.vertices.front()).norm());
    }
    std::vector<Vector2d> loop;
    bool is_prism = false;
    for (std::size_t f = 0; f < prism.faces.size(); ++f) {
        const Vector3d normal = face_normal(prism, static_cast<int>(f));
        if (std::abs(normal.y()) > tolerance && std::abs(std::abs(normal.y()) - 1) > tolerance) {
            is_prism = false;
            break;
        }
        if (normal.y() > -0.5) continue;
        is_prism = true;
        for (const int v : prism.faces[f]) loop.push_back(from_space<2>(prism.vertices[v]));
    }
    if (!is_prism)
        throw InputError(name, "a shape that is not a prism along y",
                         "a planar scene takes stones that are the same in every section along y");
    depth = high - low;
    return make_convex_polygon(std::move(loop), name, tolerance);
}

Moments moments_of(const std::vector<ConvexPolygon>& outlines, double thickness)
{
    const Vector2d origin = outlines.front().vertices.front();
    double area = 0;
    Vector2d first = Vector2d::Zero();
    Matrix2d second = Matrix2d::Zero();
    for (const ConvexPolygon& outline : outlines)
        for (std::size_t i = 1; i + 1 < outline.vertices.size(); ++i) {
            const Vector2d p = outline.vertices[0] - origin, q = outline.vertices[i] - origin,
                           r = outline.vertices[i + 1] - origin, s = p + q + r;
            const double a = 0.5 * cross(q - p, r - p);
            area += a;
            first += a / 3 * s;
            second += a / 12 * (p * p.transpose() + q * q.transpose() + r * r.transpose() + s * s.transpose());
        }
    const Vector2d centroid = first / area;
    Moments moments;
    moments.volume = area * thickness;
    moments.centroid = to_space(Vector2d(origin + centroid));
    moments.second = thickness * to_space(Matrix2d(second - area * centroid * centroid.transpose()), 0);
    return moments;
}

}  // namespace voussoir
