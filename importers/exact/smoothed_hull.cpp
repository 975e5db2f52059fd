#include "importers/exact/smoothed_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "importers/exact/cut_solid.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

using Key = std::array<double, 3>;

Key key_of(const Vector3d& x)
{
    return {x.x(), x.y(), x.z()};
}

/// The vertices that stand out most, over each facet of the chosen ones' hull; none when none does by `height`.
std::set<int> outstanding(const TriangleSurface& hull, const std::vector<bool>& chosen,
                          const TriangleSurface& inner, double height)
{
    std::vector<CutPlane> facets;
    for (const Eigen::Vector3i& t : inner.triangles)
        facets.push_back({inner.vertices[t[0]], normal_of(inner, t).normalized()});
    std::vector<std::pair<double, int>> highest(facets.size(), {height, -1});
    for (int v = 0; v < static_cast<int>(hull.vertices.size()); ++v) {
        if (chosen[v]) continue;
        std::size_t best = 0;
        double out = -1e300;
        for (std::size_t f = 0; f < facets.size(); ++f)
            if (const double d = facets[f].distance(hull.vertices[v]); d > out) {
                out = d;
                best = f;
            }
        if (!facets.empty() && out > highest[best].first) highest[best] = {out, v};
    }
    std::set<int> found;
    for (const auto& [out, v] : highest)
        if (v >= 0) found.insert(v);
    return found;
}

}  // namespace

TriangleSurface smoothed_hull(const TriangleSurface& hull, const std::vector<Vector3d>& kept, double height)
{
    std::set<Key> keys;
    for (const Vector3d& x : kept) keys.insert(key_of(x));
    std::vector<bool> chosen(hull.vertices.size(), false);
    for (std::size_t v = 0; v < chosen.size(); ++v) chosen[v] = keys.contains(key_of(hull.vertices[v]));
    for (int i = 0; i < 27; ++i) {  // a body to begin with
        const Vector3d direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        const auto furthest = std::max_element(
            hull.vertices.begin(), hull.vertices.end(),
            [&](const Vector3d& a, const Vector3d& b) { return direction.dot(a) < direction.dot(b); });
        chosen[furthest - hull.vertices.begin()] = true;
    }
    while (true) {
        std::vector<Vector3d> points;
        for (std::size_t v = 0; v < chosen.size(); ++v)
            if (chosen[v]) points.push_back(hull.vertices[v]);
        TriangleSurface inner = convex_hull(points);
        if (inner.triangles.empty()) return hull;
        const std::set<int> added = outstanding(hull, chosen, inner, height);
        if (added.empty()) return inner;
        for (const int v : added) chosen[v] = true;
    }
}

std::vector<Vector3d> underside_of(const TriangleSurface& hull)
{
    std::set<int> vertices;
    for (const Eigen::Vector3i& t : hull.triangles)
        if (-normal_of(hull, t).normalized().z() > std::numbers::sqrt2 / 2) vertices.insert({t[0], t[1], t[2]});
    std::vector<Vector3d> points;
    for (const int v : vertices) points.push_back(hull.vertices[v]);
    return points;
}

}  // namespace voussoir::importers::exact
