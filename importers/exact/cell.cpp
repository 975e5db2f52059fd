#include "importers/exact/cell.h"

#include "importers/exact/hull_volume.h"

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

/// One side of a surface, clipped at a plane.
class Side
{
 public:
    /// @param sign 1 keeps what has positive distances
    Side(const TriangleSurface& whole, const std::vector<double>& distance, double sign)
        : whole_(whole), distance_(distance), sign_(sign), place_(whole.vertices.size(), -1)
    {
        for (const Eigen::Vector3i& t : whole.triangles) clip(t);
    }

    TriangleSurface side;

 private:
    int add(const Vector3d& x)
    {
        side.vertices.push_back(x);
        return static_cast<int>(side.vertices.size()) - 1;
    }
    int keep(int v)
    {
        if (place_[v] < 0) place_[v] = add(whole_.vertices[v]);
        return place_[v];
    }
    /// The same point, to the last bit, from both sides of the plane and from both triangles at the edge.
    int cut(int a, int b)
    {
        const auto [entry, is_new] = cuts_.try_emplace(std::minmax(a, b), -1);
        if (is_new) {
            const auto& [low, high] = entry->first;
            const double share = distance_[low] / (distance_[low] - distance_[high]);
            entry->second = add(whole_.vertices[low] + share * (whole_.vertices[high] - whole_.vertices[low]));
        }
        return entry->second;
    }
    void clip(const Eigen::Vector3i& t)
    {
        std::array<int, 4> loop{};
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            const int from = t[k], to = t[(k + 1) % 3];
            if (sign_ * distance_[from] >= 0) loop[count++] = keep(from);
            if (distance_[from] * distance_[to] < 0) loop[count++] = cut(from, to);
        }
        for (int i = 1; i + 1 < count; ++i) side.triangles.emplace_back(loop[0], loop[i], loop[i + 1]);
    }

    const TriangleSurface& whole_;
    const std::vector<double>& distance_;
    double sign_;
    std::vector<int> place_;  // of the whole's vertices on this side
    std::map<std::pair<int, int>, int> cuts_;
};

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
    Cell behind{cell.walls, Side(cell.surface, distance, -1).side, {}};
    Cell before{cell.walls, Side(cell.surface, distance, 1).side, {}};
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
