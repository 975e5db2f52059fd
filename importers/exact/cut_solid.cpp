#include "importers/exact/cut_solid.h"

#include <algorithm>
#include <map>

#include "importers/exact/cap.h"
#include "importers/exact/shell.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

/// One side of a plane.
class Half
{
 public:
    /// @param distance of every vertex from the plane, 0 when it lies in it; @param kept -1 behind, 1 before
    Half(const TriangleSurface& solid, const std::vector<double>& distance, int kept)
        : solid_(solid), distance_(distance), kept_(kept), place_(solid.vertices.size(), -1)
    {
    }

    bool make(const Vector3d& front)
    {
        for (const Eigen::Vector3i& triangle : solid_.triangles) add(clipped(triangle));
        DirectedEdges rim;  // of the cap: against the direction of the faces at the cut
        for (const auto& [edge, count] : at_cut_) {
            const auto back = at_cut_.find({edge.second, edge.first});
            const int net = count - (back == at_cut_.end() ? 0 : back->second);
            if (net > 0) rim[{edge.second, edge.first}] = net;
        }
        return fill_cap(half.vertices, -kept_ * front, rim, half.triangles) && !half.triangles.empty();
    }

    TriangleSurface half;

 private:
    int keep(int vertex)
    {
        if (place_[vertex] < 0) place_[vertex] = add_vertex(solid_.vertices[vertex], distance_[vertex] == 0);
        return place_[vertex];
    }

    /// The same point, to the last bit, from both sides of the plane and from both faces at the edge.
    int cut(int a, int b)
    {
        const auto [entry, is_new] = cuts_.try_emplace(std::minmax(a, b), -1);
        if (is_new) {
            const auto& [low, high] = entry->first;
            const double share = distance_[low] / (distance_[low] - distance_[high]);
            const Vector3d &from = solid_.vertices[low], &to = solid_.vertices[high];
            entry->second = add_vertex(from + share * (to - from), true);
        }
        return entry->second;
    }

    int add_vertex(const Vector3d& x, bool in_plane)
    {
        half.vertices.push_back(x);
        in_plane_.push_back(in_plane);
        return static_cast<int>(half.vertices.size()) - 1;
    }

    std::vector<int> clipped(const Eigen::Vector3i& t)
    {
        std::vector<int> loop;
        if (distance_[t[0]] == 0 && distance_[t[1]] == 0 && distance_[t[2]] == 0) return loop;  // the cap has it
        for (int k = 0; k < 3; ++k) {
            const int from = t[k], to = t[(k + 1) % 3];
            if (distance_[from] * kept_ >= 0) loop.push_back(keep(from));
            if (distance_[from] * distance_[to] < 0) loop.push_back(cut(from, to));
        }
        return loop;
    }

    void add(const std::vector<int>& loop)
    {
        if (loop.size() < 3) return;
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            half.triangles.emplace_back(loop[0], loop[i], loop[i + 1]);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int from = loop[i], to = loop[(i + 1) % loop.size()];
            if (in_plane_[from] && in_plane_[to]) ++at_cut_[{from, to}];
        }
    }

    const TriangleSurface& solid_;
    const std::vector<double>& distance_;
    int kept_;
    std::vector<int> place_;      // of the solid's vertices in the half
    std::vector<bool> in_plane_;  // of the half's vertices
    std::map<std::pair<int, int>, int> cuts_;
    DirectedEdges at_cut_;
};

mesh::PolygonSurface polygons_of(const TriangleSurface& surface)
{
    mesh::PolygonSurface result{"", surface.vertices, {}};
    for (const Eigen::Vector3i& t : surface.triangles) result.faces.push_back({t[0], t[1], t[2]});
    return result;
}

std::vector<TriangleSurface> shells_of(const TriangleSurface& surface)
{
    const std::vector<int> shell = shell_of_faces(polygons_of(surface), TouchingEdges::part);
    std::vector<TriangleSurface> shells;
    std::map<std::pair<int, int>, int> place;  // by shell and vertex
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const int s = shell[t];
        if (s >= static_cast<int>(shells.size())) shells.resize(s + 1);
        Eigen::Vector3i corners;
        for (int k = 0; k < 3; ++k) {
            const int vertex = surface.triangles[t][k];
            const auto [entry, is_new] =
                place.try_emplace({s, vertex}, static_cast<int>(shells[s].vertices.size()));
            if (is_new) shells[s].vertices.push_back(surface.vertices[vertex]);
            corners[k] = entry->second;
        }
        shells[s].triangles.push_back(corners);
    }
    return shells;
}

/// Shells that point outward, each with the cavities in it.
std::vector<TriangleSurface> connected_pieces(const TriangleSurface& surface)
{
    std::vector<TriangleSurface> outer, cavities;
    for (TriangleSurface& shell : shells_of(surface))
        (volume_of(shell) < 0 ? cavities : outer).push_back(std::move(shell));
    for (const TriangleSurface& cavity : cavities) {
        const auto host = std::find_if(outer.begin(), outer.end(), [&](const TriangleSurface& shell) {
            return winding_number(polygons_of(shell), cavity.vertices.front()) > 0.5;
        });
        if (host == outer.end()) continue;
        const auto first = static_cast<int>(host->vertices.size());
        host->vertices.insert(host->vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
        for (const Eigen::Vector3i& t : cavity.triangles) host->triangles.emplace_back(t.array() + first);
    }
    return outer;
}

}  // namespace

std::optional<Halves> cut_solid(const TriangleSurface& solid, const CutPlane& plane, double tolerance)
{
    std::vector<double> distance;
    for (const Vector3d& x : solid.vertices) {
        const double d = plane.distance(x);
        distance.push_back(std::abs(d) <= tolerance ? 0 : d);
    }
    const auto [least, most] = std::minmax_element(distance.begin(), distance.end());
    if (*least >= 0 || *most <= 0) return std::nullopt;
    Half behind(solid, distance, -1), before(solid, distance, 1);
    if (!behind.make(plane.normal) || !before.make(plane.normal)) return std::nullopt;
    return Halves{connected_pieces(behind.half), connected_pieces(before.half)};
}

}  // namespace voussoir::importers::exact
