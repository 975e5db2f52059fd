#include "importers/exact/clipped_volume.h"

#include <algorithm>
#include <array>

#include "importers/exact/kept_vertices.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

/// What lies behind a plane, and the fan that closes it. A vertex in the plane counts as behind it: a triangle is
/// cut where it crosses only. @param hub of the fan, in the plane
TriangleSurface behind(const TriangleSurface& whole, const std::vector<double>& distance, const Vector3d& hub)
{
    TriangleSurface kept;
    kept.vertices.push_back(hub);
    KeptVertices vertices(whole, distance, kept);
    for (const Eigen::Vector3i& t : whole.triangles) {
        std::array<int, 4> loop{};
        int count = 0, leaves = -1, enters = -1;
        for (int k = 0; k < 3; ++k) {
            const int from = t[k], to = t[(k + 1) % 3];
            const bool from_in = distance[from] <= 0, to_in = distance[to] <= 0;
            if (from_in) loop[count++] = vertices.keep(from);
            if (from_in == to_in) continue;
            (from_in ? leaves : enters) = loop[count++] = vertices.cut(from, to);
        }
        for (int i = 1; i + 1 < count; ++i) kept.triangles.emplace_back(loop[0], loop[i], loop[i + 1]);
        if (leaves >= 0) kept.triangles.emplace_back(0, enters, leaves);
    }
    return kept;
}

}  // namespace

double clipped_volume(TriangleSurface surface, const std::vector<CutPlane>& planes)
{
    std::vector<double> distance;
    for (const CutPlane& plane : planes) {
        distance.clear();
        for (const Vector3d& x : surface.vertices) distance.push_back(plane.distance(x));
        if (std::none_of(distance.begin(), distance.end(), [](double d) { return d > 0; })) continue;
        surface = behind(surface, distance, plane.anchor);
    }
    return volume_of(surface);
}

}  // namespace voussoir::importers::exact
