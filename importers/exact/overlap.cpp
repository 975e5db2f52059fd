#include "importers/exact/overlap.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

#include "libdda/geometry/box_tree.h"
#include "libdda/geometry/moments.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

struct Plane {
    Vector3d anchor, normal;  // outward
    double distance(const Vector3d& x) const { return normal.dot(x - anchor); }
};

Plane plane_of(const ConvexPolyhedron& shape, int face)
{
    return {shape.vertices[shape.faces[face].front()], face_normal(shape, face)};
}

/// A closed surface that is being clipped; every edge is used once in each direction, always.
struct Solid {
    std::vector<Vector3d> vertices;
    std::vector<std::vector<int>> faces;
};

/// Cuts edges where they cross the plane, each once.
class EdgeCutter
{
 public:
    EdgeCutter(Solid& solid, const std::vector<double>& distance) : solid_(solid), distance_(distance) {}

    int cut(int inside, int outside)
    {
        const auto [entry, is_new] =
            cuts_.try_emplace({inside, outside}, static_cast<int>(solid_.vertices.size()));
        if (is_new) {
            const double share = distance_[inside] / (distance_[inside] - distance_[outside]);
            const Vector3d from = solid_.vertices[inside], to = solid_.vertices[outside];
            solid_.vertices.push_back(from + share * (to - from));
        }
        return entry->second;
    }

 private:
    Solid& solid_;
    const std::vector<double>& distance_;
    std::map<std::pair<int, int>, int> cuts_;
};

/// The part of a loop that is inside. Where the loop leaves and comes back it runs along the cut; the lid, which
/// is to close the cut, runs the other way: lid[b] = a.
std::vector<int> clip_loop(const std::vector<int>& loop, const std::vector<double>& distance, EdgeCutter& cutter,
                           std::map<int, int>& lid)
{
    std::vector<int> kept;
    std::vector<std::size_t> leaves;  // places in `kept`; the place after is where the loop comes back
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const int from = loop[i], to = loop[(i + 1) % loop.size()];
        const bool from_inside = distance[from] <= 0, to_inside = distance[to] <= 0;
        if (from_inside) kept.push_back(from);
        if (from_inside == to_inside) continue;
        if (from_inside) leaves.push_back(kept.size());
        kept.push_back(from_inside ? cutter.cut(from, to) : cutter.cut(to, from));
    }
    for (const std::size_t place : leaves) lid[kept[(place + 1) % kept.size()]] = kept[place];
    return kept;
}

void close_with_lids(std::map<int, int> lid, Solid& solid)
{
    while (!lid.empty()) {
        std::vector<int> loop;
        for (auto next = lid.begin(); next != lid.end(); next = lid.find(loop.back())) {
            if (loop.empty()) loop.push_back(next->first);
            loop.push_back(next->second);
            lid.erase(next);
        }
        loop.pop_back();  // the first corner again
        if (loop.size() >= 3) solid.faces.push_back(std::move(loop));
    }
}

void clip(Solid& solid, const Plane& plane)
{
    std::vector<double> distance;
    for (const Vector3d& x : solid.vertices) distance.push_back(plane.distance(x));
    EdgeCutter cutter(solid, distance);
    std::vector<std::vector<int>> faces;
    faces.swap(solid.faces);
    std::map<int, int> lid;
    for (const std::vector<int>& face : faces)
        if (std::vector<int> kept = clip_loop(face, distance, cutter, lid); kept.size() >= 3)
            solid.faces.push_back(std::move(kept));
    close_with_lids(std::move(lid), solid);
}

double volume_of(const Solid& solid)
{
    double six_volumes = 0;
    if (solid.faces.empty()) return 0;
    const Vector3d origin = solid.vertices[solid.faces.front().front()];
    for (const std::vector<int>& face : solid.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            six_volumes +=
                (solid.vertices[face[0]] - origin)
                    .dot((solid.vertices[face[i]] - origin).cross(solid.vertices[face[i + 1]] - origin));
    return std::max(0.0, six_volumes / 6);
}

/// True when a face of `a` has all of `b` in front of it.
bool a_face_separates(const ConvexPolyhedron& a, const ConvexPolyhedron& b)
{
    for (int f = 0; f < static_cast<int>(a.faces.size()); ++f) {
        const Plane plane = plane_of(a, f);
        if (std::all_of(b.vertices.begin(), b.vertices.end(),
                        [&](const Vector3d& x) { return plane.distance(x) >= 0; }))
            return true;
    }
    return false;
}

Eigen::AlignedBox3d bounds_of(const std::vector<ConvexPolyhedron>& parts)
{
    Eigen::AlignedBox3d bounds;
    for (const ConvexPolyhedron& part : parts)
        for (const Vector3d& x : part.vertices) bounds.extend(x);
    return bounds;
}

double volume_of(const std::vector<ConvexPolyhedron>& parts)
{
    double volume = 0;
    for (const ConvexPolyhedron& part : parts) volume += moments_of(part).volume;
    return volume;
}

double overlap_volume(const std::vector<ConvexPolyhedron>& a, const std::vector<ConvexPolyhedron>& b)
{
    double volume = 0;
    for (const ConvexPolyhedron& part_a : a)
        for (const ConvexPolyhedron& part_b : b) volume += exact::overlap_volume(part_a, part_b);
    return volume;
}

}  // namespace

double overlap_volume(const ConvexPolyhedron& a, const ConvexPolyhedron& b)
{
    if (a_face_separates(a, b) || a_face_separates(b, a)) return 0;
    Solid solid{a.vertices, a.faces};
    for (int f = 0; f < static_cast<int>(b.faces.size()) && !solid.faces.empty(); ++f) clip(solid, plane_of(b, f));
    return volume_of(solid);
}

std::vector<OverlappingPair> find_overlaps(std::span<const std::vector<ConvexPolyhedron>> stones, double tolerance)
{
    std::vector<OverlappingPair> pairs;
    if (stones.empty()) return pairs;
    std::vector<Eigen::AlignedBox3d> bounds;
    std::vector<double> volumes;
    for (const auto& parts : stones) {
        bounds.push_back(bounds_of(parts));
        volumes.push_back(volume_of(parts));
    }
    const BoxTree tree(std::move(bounds));
    for (int a = 0; a < static_cast<int>(stones.size()); ++a)
        for (const int b : tree.neighbours_behind(a)) {
            if ((tree[a].intersection(tree[b]).sizes().array() <= 0).any()) continue;  // they only touch
            const double volume = overlap_volume(stones[a], stones[b]);
            const double share = volume / std::min(volumes[a], volumes[b]);
            if (share > tolerance) pairs.push_back({a, b, volume, share});
        }
    return pairs;
}

}  // namespace voussoir::importers::exact
