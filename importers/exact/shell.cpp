#include "importers/exact/shell.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

struct Use {
    int forward = 0, backward = 0;
};

// rad. No stone is as sharp as this: a face so near to another one, on its inside, is the neighbour's, whose
// survey rounded or which is triangulated along the other diagonal.
constexpr double touching_angle = 0.02;

/// A face at an edge, and whether it runs along it from the smaller vertex to the larger.
struct FaceAtEdge {
    int face = 0;
    bool forward = false;
};

using FacesAtEdges = std::map<std::pair<int, int>, std::vector<FaceAtEdge>>;

FacesAtEdges faces_at_edges(const mesh::PolygonSurface& surface)
{
    FacesAtEdges edges;
    for (int f = 0; f < static_cast<int>(surface.faces.size()); ++f)
        for (std::size_t i = 0; i < surface.faces[f].size(); ++i) {
            const int from = surface.faces[f][i], to = surface.faces[f][(i + 1) % surface.faces[f].size()];
            edges[std::minmax(from, to)].push_back({f, from < to});
        }
    return edges;
}

Vector3d normal_of(const mesh::PolygonSurface& surface, int face)
{
    const std::vector<int>& loop = surface.faces[face];
    const Vector3d& origin = surface.vertices[loop.front()];
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        sum += (surface.vertices[loop[i]] - origin).cross(surface.vertices[loop[i + 1]] - origin);
    return sum.normalized();
}

/// Angles of the faces at an edge, counted from a face that runs forward, round through its inside.
class Fan
{
 public:
    Fan(const mesh::PolygonSurface& surface, const std::pair<int, int>& edge, const FaceAtEdge& start)
    {
        along_ = (surface.vertices[edge.second] - surface.vertices[edge.first]).normalized();
        inward_ = -normal_of(surface, start.face);
        into_ = into(surface, start);
    }
    double angle(const mesh::PolygonSurface& surface, const FaceAtEdge& other) const
    {
        const Vector3d direction = into(surface, other);
        const double a = std::atan2(direction.dot(inward_), direction.dot(into_));
        return a < touching_angle ? a + 2 * std::numbers::pi : a;
    }

 private:
    /// From the edge into the face.
    Vector3d into(const mesh::PolygonSurface& surface, const FaceAtEdge& at) const
    {
        return (at.forward ? 1 : -1) * normal_of(surface, at.face).cross(along_);
    }
    Vector3d along_, inward_, into_;
};

bool some_coincide(const mesh::PolygonSurface& surface, const std::pair<int, int>& edge,
                   const std::vector<FaceAtEdge>& faces)
{
    for (const FaceAtEdge& a : faces)
        for (const FaceAtEdge& b : faces)
            if (a.face < b.face && a.forward != b.forward &&
                std::abs(Fan(surface, edge, a).angle(surface, b) - 2 * std::numbers::pi) < touching_angle)
                return true;
    return false;
}

/// Pairs of faces that continue each other at an edge where more than two meet: from each forward face the first
/// backward one on the way round through the inside. Empty when that is ambiguous.
std::vector<std::pair<int, int>> pairs_at(const mesh::PolygonSurface& surface, const std::pair<int, int>& edge,
                                          const std::vector<FaceAtEdge>& faces)
{
    std::vector<std::pair<int, int>> pairs;
    std::map<int, int> taken;
    for (const FaceAtEdge& start : faces) {
        if (!start.forward) continue;
        const Fan fan(surface, edge, start);
        int nearest = -1;
        double least = 1e300;
        for (const FaceAtEdge& other : faces)
            if (!other.forward && fan.angle(surface, other) < least) {
                least = fan.angle(surface, other);
                nearest = other.face;
            }
        if (nearest < 0 || taken[nearest]++ > 0) return {};
        pairs.emplace_back(start.face, nearest);
    }
    return 2 * pairs.size() == faces.size() ? pairs : std::vector<std::pair<int, int>>{};
}

}  // namespace

EdgeUse edge_use(const mesh::PolygonSurface& surface)
{
    std::map<std::pair<int, int>, Use> uses;
    for (const std::vector<int>& face : surface.faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int from = face[i], to = face[(i + 1) % face.size()];
            Use& use = uses[std::minmax(from, to)];
            ++(from < to ? use.forward : use.backward);
        }
    EdgeUse result;
    for (const auto& [edge, use] : uses) {
        if (use.forward + use.backward == 1) result.open.push_back(edge);
        if (use.forward + use.backward > 2) result.branching.push_back(edge);
        if (use.forward + use.backward == 2 && use.forward != 1) result.clashing.push_back(edge);
    }
    return result;
}

double winding_number(const mesh::PolygonSurface& surface, const Vector3d& point)
{
    double sum = 0;
    for (const std::vector<int>& face : surface.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const Vector3d a = surface.vertices[face[0]] - point, b = surface.vertices[face[i]] - point,
                           c = surface.vertices[face[i + 1]] - point;
            const double la = a.norm(), lb = b.norm(), lc = c.norm();
            sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
        }
    return sum / (4 * std::numbers::pi);
}

std::vector<int> shell_of_faces(const mesh::PolygonSurface& surface, TouchingEdges touching)
{
    std::vector<int> leader(surface.faces.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](int f) {
        while (leader[f] != f) f = leader[f] = leader[leader[f]];
        return f;
    };
    const auto join = [&](int a, int b) { leader[find(std::max(find(a), find(b)))] = std::min(find(a), find(b)); };
    for (const auto& [edge, faces] : faces_at_edges(surface)) {
        std::vector<std::pair<int, int>> pairs;
        if (faces.size() > 2 && (touching == TouchingEdges::part || some_coincide(surface, edge, faces)))
            pairs = pairs_at(surface, edge, faces);
        if (pairs.empty())
            for (const FaceAtEdge& other : faces) pairs.emplace_back(faces.front().face, other.face);
        for (const auto& [a, b] : pairs) join(a, b);
    }
    std::vector<int> number(surface.faces.size());
    std::map<int, int> numbers;
    for (int f = 0; f < static_cast<int>(surface.faces.size()); ++f)
        number[f] = numbers.emplace(find(f), static_cast<int>(numbers.size())).first->second;
    return number;
}

}  // namespace voussoir::importers::exact
