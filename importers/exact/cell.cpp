#include "importers/exact/cell.h"

#include "importers/exact/hull_volume.h"
#include "importers/exact/kept_vertices.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

/// How often the surface winds round a point. Source: [VanOosteromStrackee1983].
double winding(const TriangleSurface& surface, const Vector3d& point)
{
    double sum = 0;
    for (const Eigen::Vector3i& t : surface.triangles) {
        const Vector3d a = surface.vertices[t[0]] - point, b = surface.vertices[t[1]] - point,
                       c = surface.vertices[t[2]] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4 * std::numbers::pi);
}

/// One side of a surface, clipped at a plane. @param sign 1 keeps what has positive distances
TriangleSurface side_of(const TriangleSurface& whole, const std::vector<double>& distance, double sign)
{
    TriangleSurface side;
    KeptVertices vertices(whole, distance, side);
    for (const Eigen::Vector3i& t : whole.triangles) {
        std::array<int, 4> loop{};
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            const int from = t[k], to = t[(k + 1) % 3];
            if (sign * distance[from] >= 0) loop[count++] = vertices.keep(from);
            if (distance[from] * distance[to] < 0) loop[count++] = vertices.cut(from, to);
        }
        for (int i = 1; i + 1 < count; ++i) side.triangles.emplace_back(loop[0], loop[i], loop[i + 1]);
    }
    return side;
}

/// Where the plane meets two walls of the cell each, in the cell and inside the solid.
std::vector<Vector3d> corners_on(const CutPlane& plane, const std::vector<CutPlane>& walls,
                                 const TriangleSurface& solid)
{
    std::vector<Vector3d> corners;
    for (std::size_t i = 0; i < walls.size(); ++i)
        for (std::size_t j = i + 1; j < walls.size(); ++j) {
            Eigen::Matrix3d normals;
            normals << plane.normal.transpose(), walls[i].normal.transpose(), walls[j].normal.transpose();
            if (std::abs(normals.determinant()) < 1e-6) continue;
            const Vector3d shift = normals.partialPivLu().solve(
                Vector3d(0, -walls[i].distance(plane.anchor), -walls[j].distance(plane.anchor)));
            const Vector3d corner = plane.anchor + shift;
            bool inside = true;
            for (std::size_t k = 0; k < walls.size() && inside; ++k)
                inside = k == i || k == j || walls[k].distance(corner) <= 0;
            if (inside && winding(solid, corner) > 0.5) corners.push_back(corner);
        }
    return corners;
}

std::vector<Vector3d> points_of(const Cell& cell)
{
    std::vector<Vector3d> points = cell.surface.vertices;
    points.insert(points.end(), cell.corners.begin(), cell.corners.end());
    return points;
}

}  // namespace

std::pair<Cell, Cell> divided(const Cell& cell, const CutPlane& plane, const TriangleSurface& solid)
{
    std::vector<double> distance;
    for (const Vector3d& x : cell.surface.vertices) distance.push_back(plane.distance(x));
    Cell behind{cell.walls, side_of(cell.surface, distance, -1), {}};
    Cell before{cell.walls, side_of(cell.surface, distance, 1), {}};
    behind.walls.push_back(plane);
    before.walls.push_back({plane.anchor, -plane.normal});
    for (const Vector3d& x : cell.corners) (plane.distance(x) <= 0 ? behind : before).corners.push_back(x);
    for (const Vector3d& x : corners_on(plane, cell.walls, solid)) {
        behind.corners.push_back(x);
        before.corners.push_back(x);
    }
    return {std::move(behind), std::move(before)};
}

TriangleSurface hull_of(const Cell& cell)
{
    return convex_hull(points_of(cell));
}

double hull_volume_of(const Cell& cell)
{
    return hull_volume(points_of(cell));
}

TriangleSurface coarsened(const TriangleSurface& surface, std::size_t vertices)
{
    if (surface.vertices.size() <= vertices) return surface;
    // A surface of area A passes through some 1.5 A / h^2 boxes of size h.
    const double size = std::sqrt(1.5 * area_of(surface) / static_cast<double>(vertices));
    std::map<std::array<std::int64_t, 3>, int> boxes;
    TriangleSurface coarse;
    std::vector<int> place;
    for (const Vector3d& x : surface.vertices) {
        std::array<std::int64_t, 3> box{};
        for (int k = 0; k < 3; ++k)
            box[k] = static_cast<std::int64_t>(std::floor((x[k] - surface.vertices.front()[k]) / size));
        const auto [entry, is_new] = boxes.try_emplace(box, static_cast<int>(coarse.vertices.size()));
        if (is_new) coarse.vertices.push_back(x);
        place.push_back(entry->second);
    }
    for (const Eigen::Vector3i& t : surface.triangles) {
        const Eigen::Vector3i mapped(place[t[0]], place[t[1]], place[t[2]]);
        if (mapped[0] != mapped[1] && mapped[1] != mapped[2] && mapped[2] != mapped[0])
            coarse.triangles.push_back(mapped);
    }
    return coarse;
}

}  // namespace voussoir::importers::exact
