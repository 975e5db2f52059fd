#include "libdda/geometry/convex_polyhedron.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>
#include <sstream>

#include "libdda/errors.h"

namespace voussoir
{

using Eigen::Vector3d;
using Loop = std::vector<int>;
using DirectedEdge = std::pair<int, int>;

namespace
{

double bounding_diagonal(const std::vector<Vector3d>& vertices)
{
    if (vertices.empty()) return 0;
    Vector3d lower = vertices.front(), upper = vertices.front();
    for (const Vector3d& x : vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    return (upper - lower).norm();
}

/// Newell: the sum over the loop's triangles seen from its first vertex; length is twice the area.
Vector3d newell(const std::vector<Vector3d>& vertices, const Loop& loop)
{
    Vector3d sum = Vector3d::Zero();
    const Vector3d& origin = vertices[loop.front()];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        sum += (vertices[loop[i]] - origin).cross(vertices[loop[i + 1]] - origin);
    return sum;
}

std::map<DirectedEdge, int> directed_edges(const std::vector<Loop>& faces, const std::string& name)
{
    std::map<DirectedEdge, int> owner;
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
        for (std::size_t i = 0; i < faces[f].size(); ++i) {
            const DirectedEdge edge{faces[f][i], faces[f][(i + 1) % faces[f].size()]};
            if (!owner.emplace(edge, f).second) {
                std::ostringstream found;
                found << "two faces run along the edge from vertex " << edge.first << " to " << edge.second
                      << " in the same direction";
                throw InputError(name, found.str(), "orient every face outward and use every edge twice");
            }
        }
    return owner;
}

std::vector<ConvexPolyhedron::Edge> find_edges(const std::vector<Loop>& faces, const std::string& name)
{
    const std::map<DirectedEdge, int> owner = directed_edges(faces, name);
    std::vector<ConvexPolyhedron::Edge> edges;
    for (const auto& [edge, face] : owner) {
        const auto twin = owner.find({edge.second, edge.first});
        if (twin == owner.end()) {
            std::ostringstream found;
            found << "the edge from vertex " << edge.first << " to " << edge.second << " has only one face";
            throw InputError(name, found.str(), "the surface must be closed");
        }
        if (edge.first < edge.second) edges.push_back({edge.first, edge.second, face, twin->second});
    }
    return edges;
}

void check_indices(const std::vector<Vector3d>& vertices, const std::vector<Loop>& faces, const std::string& name)
{
    if (vertices.size() < 4 || faces.size() < 4)
        throw InputError(name, "fewer than four vertices or faces",
                         "a block needs a closed surface with a volume");
    for (const Vector3d& x : vertices)
        if (!x.allFinite()) throw InputError(name, "a vertex is not finite", "coordinates must be numbers");
    for (const Loop& face : faces) {
        const bool in_range = std::all_of(face.begin(), face.end(),
                                          [&](int v) { return v >= 0 && v < static_cast<int>(vertices.size()); });
        if (face.size() < 3 || !in_range)
            throw InputError(name, "a face has fewer than three vertices or an index out of range",
                             "faces are loops of vertex indices");
    }
}

void check_convexity(const std::vector<Vector3d>& vertices, const std::vector<Loop>& faces,
                     const std::string& name, double tolerance)
{
    const double allowed = tolerance * bounding_diagonal(vertices);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const Vector3d normal = newell(vertices, faces[f]);
        if (normal.norm() == 0) throw InputError(name, "face " + std::to_string(f) + " has no area", "remove it");
        const Vector3d unit = normal.normalized();
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            const double outside = unit.dot(vertices[v] - vertices[faces[f].front()]);
            if (outside <= allowed) continue;
            std::ostringstream found;
            found << "not convex: vertex " << v << " lies " << outside << " m outside the plane of face " << f;
            throw InputError(name, found.str(), "split the stone into convex parts");
        }
    }
}

/// The normals of needles are rounding errors: the large faces have the first say about planes.
std::vector<int> largest_first(const std::vector<Vector3d>& vertices, const std::vector<Loop>& faces)
{
    std::vector<double> area;
    area.reserve(faces.size());
    for (const Loop& face : faces) area.push_back(newell(vertices, face).norm());
    std::vector<int> order(faces.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return area[a] > area[b]; });
    return order;
}

/// Less wide than `allowed`.
bool is_needle(const std::vector<Vector3d>& vertices, const Loop& face, double allowed)
{
    double longest = 0;
    for (std::size_t i = 0; i < face.size(); ++i)
        longest = std::max(longest, (vertices[face[(i + 1) % face.size()]] - vertices[face[i]]).norm());
    return newell(vertices, face).norm() <= allowed * longest;
}

/// For every face the largest face of its flat patch: edge-adjacent faces in one plane, facing the same way.
std::vector<int> coplanar_groups(const std::vector<Vector3d>& vertices, const std::vector<Loop>& faces,
                                 const std::map<DirectedEdge, int>& owner, double allowed)
{
    std::vector<int> group(faces.size(), -1);
    for (const int seed : largest_first(vertices, faces)) {
        if (group[seed] >= 0) continue;
        const Vector3d unit = newell(vertices, faces[seed]).normalized();
        const Vector3d& anchor = vertices[faces[seed].front()];
        const auto in_plane = [&](const Loop& face) {
            const bool same_side = newell(vertices, face).dot(unit) > 0 || is_needle(vertices, face, allowed);
            return same_side && std::all_of(face.begin(), face.end(), [&](int v) {
                       return std::abs(unit.dot(vertices[v] - anchor)) <= allowed;
                   });
        };
        std::vector<int> members{seed};
        group[seed] = seed;
        for (std::size_t i = 0; i < members.size(); ++i) {
            const Loop& face = faces[members[i]];
            for (std::size_t k = 0; k < face.size(); ++k) {
                const auto twin = owner.find({face[(k + 1) % face.size()], face[k]});
                if (twin == owner.end() || group[twin->second] >= 0 || !in_plane(faces[twin->second])) continue;
                group[twin->second] = seed;
                members.push_back(twin->second);
            }
        }
    }
    return group;
}

/// The boundary of a flat patch: its directed edges whose twin is in another patch, chained into one loop.
Loop outline_of_group(const std::vector<Loop>& faces, const std::map<DirectedEdge, int>& owner,
                      const std::vector<int>& group, int id, const std::vector<int>& members)
{
    std::map<int, int> next;
    for (const int f : members) {
        for (std::size_t k = 0; k < faces[f].size(); ++k) {
            const int from = faces[f][k], to = faces[f][(k + 1) % faces[f].size()];
            const auto twin = owner.find({to, from});
            if (twin == owner.end() || group[twin->second] != id) next[from] = to;
        }
    }
    Loop loop;
    const int start = next.empty() ? -1 : next.begin()->first;
    for (int v = start; v >= 0 && loop.size() < next.size();) {
        loop.push_back(v);
        const auto following = next.find(v);
        v = following == next.end() || following->second == start ? -1 : following->second;
    }
    if (loop.empty() || loop.size() != next.size())
        throw InputError("mesh", "a flat face has a hole, touches itself or is not bounded",
                         "a convex stone is simple");
    return loop;
}

Loop without_straight_corners(const std::map<int, int>& faces_at, const Loop& loop)
{
    Loop kept;
    for (const int v : loop)
        if (faces_at.at(v) > 2) kept.push_back(v);
    return kept.size() >= 3 ? kept : loop;
}

}  // namespace

ConvexPolyhedron make_convex_polyhedron(std::vector<Vector3d> vertices, std::vector<Loop> faces,
                                        const std::string& name, double tolerance)
{
    check_indices(vertices, faces, name);
    ConvexPolyhedron shape;
    shape.edges = find_edges(faces, name);
    check_convexity(vertices, faces, name, tolerance);
    shape.vertices = std::move(vertices);
    shape.faces = std::move(faces);
    return shape;
}

std::vector<Loop> merge_coplanar_faces(const std::vector<Vector3d>& vertices, const std::vector<Loop>& faces,
                                       double tolerance)
{
    const std::map<DirectedEdge, int> owner = directed_edges(faces, "mesh");
    const std::vector<int> group =
        coplanar_groups(vertices, faces, owner, tolerance * bounding_diagonal(vertices));
    std::vector<std::vector<int>> members(faces.size());
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) members[group[f]].push_back(f);
    std::vector<Loop> merged;
    for (int id = 0; id < static_cast<int>(faces.size()); ++id)
        if (group[id] == id) merged.push_back(outline_of_group(faces, owner, group, id, members[id]));

    std::map<int, int> faces_at;  // how many merged faces meet at a vertex; two: it lies inside a straight edge
    for (const Loop& loop : merged)
        for (const int v : loop) ++faces_at[v];
    for (Loop& loop : merged) loop = without_straight_corners(faces_at, loop);
    return merged;
}

ConvexPolyhedron make_box(const Vector3d& lower, const Vector3d& upper)
{
    std::vector<Vector3d> corners;
    corners.reserve(8);
    for (int i = 0; i < 8; ++i)
        corners.emplace_back(i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                             i & 4 ? upper.z() : lower.z());
    return make_convex_polyhedron(
        corners, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}, "box");
}

ConvexPolyhedron translated(ConvexPolyhedron shape, const Vector3d& offset)
{
    for (Vector3d& x : shape.vertices) x += offset;
    return shape;
}

Vector3d face_normal(const ConvexPolyhedron& shape, int face)
{
    return newell(shape.vertices, shape.faces[face]).normalized();
}

}  // namespace voussoir
