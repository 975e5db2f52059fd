#include "importers/fit/side.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <set>

namespace voussoir::importers::fit
{

using Eigen::Vector3d;

namespace
{

const double same_side = std::cos(25 * EIGEN_PI / 180);  // of normals

/// Half the vector area of a loop: along its normal, as long as its area.
Vector3d area_of(const mesh::PolygonSurface& surface, const std::vector<int>& loop)
{
    const Vector3d& origin = surface.vertices[loop.front()];
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        sum += (surface.vertices[loop[i]] - origin).cross(surface.vertices[loop[i + 1]] - origin);
    return 0.5 * sum;
}

/// How far corners of a face lie off its plane.
double bend_of(const mesh::PolygonSurface& surface, const std::vector<int>& loop, const Vector3d& normal)
{
    Vector3d middle = Vector3d::Zero();
    for (const int v : loop) middle += surface.vertices[v] / static_cast<double>(loop.size());
    double bend = 0;
    if (loop.size() > 3)
        for (const int v : loop) bend = std::max(bend, std::abs(normal.dot(surface.vertices[v] - middle)));
    return bend;
}

using DirectedEdge = std::pair<int, int>;

std::map<DirectedEdge, int> faces_by_edge(const mesh::PolygonSurface& surface)
{
    std::map<DirectedEdge, int> face_of;
    for (int f = 0; f < static_cast<int>(surface.faces.size()); ++f) {
        const std::vector<int>& loop = surface.faces[f];
        for (std::size_t i = 0; i < loop.size(); ++i) face_of[{loop[i], loop[(i + 1) % loop.size()]}] = f;
    }
    return face_of;
}

/// Corners on the boundary of the side and the area that each stands for.
void find_boundary(const mesh::PolygonSurface& surface, Side& side)
{
    std::set<DirectedEdge> edges;
    for (const int f : side.faces) {
        const std::vector<int>& loop = surface.faces[f];
        for (std::size_t i = 0; i < loop.size(); ++i) edges.insert({loop[i], loop[(i + 1) % loop.size()]});
    }
    std::map<int, double> length;
    double total = 0;
    for (const auto& [from, to] : edges) {
        if (edges.contains({to, from})) continue;
        const double edge = (surface.vertices[to] - surface.vertices[from]).norm();
        length[from] += edge / 2;
        length[to] += edge / 2;
        total += edge;
    }
    for (const auto& [corner, share] : length) {
        side.corners.push_back(corner);
        side.weight.push_back(total > 0 ? side.area * share / total : 0);
    }
}

/// The plane through the boundary of a side, by its length: it does not depend on how the side was triangulated.
/// @param outward about its normal, of any length
Frame boundary_plane(const std::vector<Vector3d>& vertices, const Side& side, const Vector3d& outward)
{
    Vector3d centre = Vector3d::Zero();
    for (std::size_t i = 0; i < side.corners.size(); ++i)
        centre += side.weight[i] / side.area * vertices[side.corners[i]];
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < side.corners.size(); ++i) {
        const Vector3d arm = vertices[side.corners[i]] - centre;
        spread += side.weight[i] * arm * arm.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    Vector3d normal = axes.eigenvectors().col(0);
    if (normal.dot(outward) < 0) normal = -normal;
    // A strip has no plane of its own across its length: its faces know better.
    if (normal.dot(outward.normalized()) < same_side) normal = outward.normalized();
    return frame_of(centre, normal);
}

}  // namespace

Frame frame_of(const Vector3d& centre, const Vector3d& normal)
{
    Frame frame;
    frame.centre = centre;
    frame.normal = normal;
    frame.u = normal.unitOrthogonal();
    frame.v = normal.cross(frame.u);
    return frame;
}

std::vector<Eigen::Matrix3d> triangles_of(const mesh::PolygonSurface& surface, int face)
{
    const std::vector<int>& loop = surface.faces[face];
    std::vector<Eigen::Matrix3d> triangles;
    Eigen::Matrix3d corners;
    if (loop.size() == 3) {
        corners << surface.vertices[loop[0]], surface.vertices[loop[1]], surface.vertices[loop[2]];
        return {corners};
    }
    Vector3d middle = Vector3d::Zero();
    for (const int v : loop) middle += surface.vertices[v] / static_cast<double>(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
        corners << middle, surface.vertices[loop[i]], surface.vertices[loop[(i + 1) % loop.size()]];
        triangles.push_back(corners);
    }
    return triangles;
}

Side make_side(const mesh::PolygonSurface& surface, std::vector<int> faces)
{
    Side side;
    side.faces = std::move(faces);
    std::sort(side.faces.begin(), side.faces.end());
    Vector3d outward = Vector3d::Zero();
    for (const int face : side.faces) {
        const Vector3d area = area_of(surface, surface.faces[face]);
        side.bent_face = std::max(side.bent_face, bend_of(surface, surface.faces[face], area.normalized()));
        side.area += area.norm();
        outward += area;
    }
    side.size = std::sqrt(side.area);
    find_boundary(surface, side);
    if (side.corners.size() < 3 || side.area <= 0) return side;
    side.plane = boundary_plane(surface.vertices, side, outward);
    for (const int face : side.faces)
        for (const int v : surface.faces[face])
            side.largest_off = std::max(side.largest_off, std::abs(side.plane.height(surface.vertices[v])));
    return side;
}

Frame plane_of(const Side& side, const std::vector<Vector3d>& vertices)
{
    return boundary_plane(vertices, side, side.plane.normal);
}

std::vector<Side> sides_of(const mesh::PolygonSurface& surface)
{
    const std::map<DirectedEdge, int> face_of = faces_by_edge(surface);
    std::vector<Vector3d> areas;
    for (const std::vector<int>& loop : surface.faces) areas.push_back(area_of(surface, loop));
    std::vector<int> order(surface.faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return areas[a].squaredNorm() > areas[b].squaredNorm(); });
    std::vector<bool> taken(surface.faces.size(), false);
    std::vector<Side> sides;
    for (const int seed : order) {
        if (taken[seed]) continue;
        std::vector<int> faces;
        Vector3d sum = Vector3d::Zero();
        std::queue<int> next;
        const auto take = [&](int face) {
            taken[face] = true;
            faces.push_back(face);
            sum += areas[face];
            next.push(face);
        };
        for (take(seed); !next.empty(); next.pop()) {
            const std::vector<int>& loop = surface.faces[next.front()];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const auto other = face_of.find({loop[(i + 1) % loop.size()], loop[i]});
                if (other == face_of.end() || taken[other->second]) continue;
                const Vector3d& area = areas[other->second];
                if (area.dot(sum) >= same_side * area.norm() * sum.norm()) take(other->second);
            }
        }
        sides.push_back(make_side(surface, std::move(faces)));
    }
    std::erase_if(sides, [](const Side& side) { return side.corners.size() < 3 || side.area <= 0; });
    std::stable_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.area > b.area; });
    return sides;
}

}  // namespace voussoir::importers::fit
