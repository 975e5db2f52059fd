#include "importers/patterns/pattern.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "libdda/errors.h"
#include "libdda/geometry/moments.h"

namespace voussoir::importers::patterns
{
namespace
{

using Eigen::Vector3d;

double cross(const Point& a, const Point& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

double signed_area(const std::vector<Point>& outline)
{
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) twice += cross(outline[i], outline[(i + 1) % outline.size()]);
    return twice / 2;
}

/// A corner that lies between its neighbours, or on one of them.
bool is_needless(const Point& before, const Point& here, const Point& after)
{
    const Point in = here - before, out = after - here;
    return std::abs(cross(in, out)) <= 1e-9 * (in.norm() + out.norm());
}

/// Faces between two loops of n corners: 0 to n - 1 counter-clockwise seen from above, the rest above them.
std::vector<std::vector<int>> drum_faces(int n)
{
    std::vector<std::vector<int>> faces(2);
    for (int i = 0; i < n; ++i) {
        faces[0].push_back(n - 1 - i);
        faces[1].push_back(n + i);
        const int next = (i + 1) % n;
        faces.push_back({i, next, n + next, n + i});
    }
    return faces;
}

}  // namespace

double to_nanometre(double metres)
{
    return std::round(metres * 1e9) / 1e9 + 0.0;
}

Point to_nanometre(const Point& point)
{
    return {to_nanometre(point.x()), to_nanometre(point.y())};
}

std::vector<Point> clean_outline(const std::vector<Point>& points)
{
    std::vector<Point> outline = points;
    for (std::size_t i = 0; i < outline.size() && outline.size() > 3;) {
        const std::size_t n = outline.size();
        if (is_needless(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]))
            outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i)), i = i == 0 ? 0 : i - 1;
        else
            ++i;
    }
    if (signed_area(outline) < 0) std::reverse(outline.begin(), outline.end());
    return outline;
}

std::vector<Point> regular_outline(const Point& centre, double width, int sides)
{
    std::vector<Point> outline;
    outline.reserve(static_cast<std::size_t>(sides));
    const double reach = width / 2 / std::cos(std::numbers::pi / sides);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / sides;
        outline.push_back(to_nanometre(Point(centre + reach * Point(std::cos(angle), std::sin(angle)))));
    }
    return outline;
}

ConvexPolyhedron frustum(const std::vector<Point>& lower, double foot, const std::vector<Point>& upper, double top,
                         const std::string& name)
{
    std::vector<Vector3d> vertices;
    vertices.reserve(lower.size() + upper.size());
    for (const Point& x : lower) vertices.emplace_back(x.x(), x.y(), foot);
    for (const Point& x : upper) vertices.emplace_back(x.x(), x.y(), top);
    return make_convex_polyhedron(std::move(vertices), drum_faces(static_cast<int>(lower.size())), name);
}

ConvexPolyhedron pointed_frustum(const std::vector<Point>& lower, double foot, const std::vector<Point>& upper,
                                 double top, double tip, const std::string& name)
{
    std::vector<Eigen::Vector3d> vertices;
    vertices.reserve(lower.size() + upper.size() + 1);
    for (const Point& x : lower) vertices.emplace_back(x.x(), x.y(), foot);
    for (const Point& x : upper) vertices.emplace_back(x.x(), x.y(), top);
    const int sides = static_cast<int>(lower.size()), apex = static_cast<int>(vertices.size());
    vertices.emplace_back(0, 0, tip);
    std::vector<std::vector<int>> faces(1);
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides;
        faces[0].push_back(sides - 1 - i);
        if (!upper.empty()) faces.push_back({i, next, sides + next, sides + i});
        faces.push_back({apex - sides + i, apex - sides + next, apex});
    }
    return make_convex_polyhedron(std::move(vertices), std::move(faces), name);
}

ConvexPolyhedron prism_up(const std::vector<Point>& outline, double foot, double top, const std::string& name)
{
    const std::vector<Point> clean = clean_outline(outline);
    return frustum(clean, foot, clean, top, name);
}

ConvexPolyhedron prism_along_y(const std::vector<Point>& outline, double front, double back,
                               const std::string& name)
{
    const std::vector<Point> clean = clean_outline(outline);
    std::vector<Vector3d> vertices;
    // Counter-clockwise in (x, z) is seen from the front: the back is "below" along y, turned round.
    for (const double y : {back, front})
        for (const Point& x : clean) vertices.emplace_back(x.x(), y, x.y());
    return make_convex_polyhedron(std::move(vertices), drum_faces(static_cast<int>(clean.size())), name);
}

void glue(ConvexPolyhedron& part, const Vector3d& point, const Vector3d& normal)
{
    part.glued.resize(part.faces.size(), false);
    for (std::size_t f = 0; f < part.faces.size(); ++f)
        if (std::all_of(part.faces[f].begin(), part.faces[f].end(), [&](int v) {
                return std::abs(normal.dot(part.vertices[v] - point)) <= 1e-8 * normal.norm();
            }))
            part.glued[f] = true;
}

double volume_of(const PatternStone& stone)
{
    return moments_of(stone.parts).volume;
}

mesh::PolygonSurface surface_of(const std::string& name, const std::vector<ConvexPolyhedron>& parts)
{
    mesh::PolygonSurface surface{name, {}, {}};
    std::map<std::array<std::int64_t, 3>, int> known;  // by tenths of micrometres
    for (const ConvexPolyhedron& part : parts)
        for (std::size_t f = 0; f < part.faces.size(); ++f) {
            if (part.is_glued(static_cast<int>(f))) continue;
            std::vector<int> loop;
            for (const int v : part.faces[f]) {
                const Vector3d& x = part.vertices[v];
                const std::array<std::int64_t, 3> key{std::llround(x.x() * 1e7), std::llround(x.y() * 1e7),
                                                      std::llround(x.z() * 1e7)};
                const auto [place, is_new] = known.try_emplace(key, static_cast<int>(surface.vertices.size()));
                if (is_new) surface.vertices.push_back(x);
                loop.push_back(place->second);
            }
            surface.faces.push_back(std::move(loop));
        }
    return surface;
}

}  // namespace voussoir::importers::patterns
