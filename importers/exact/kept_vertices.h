// The vertices of one side of a surface that is clipped at a plane.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "importers/exact/triangle_surface.h"

namespace voussoir::importers::exact
{

/// Takes over vertices of a whole surface, and makes those where its edges meet the plane, each once.
class KeptVertices
{
 public:
    /// @param distance of the whole's vertices over the plane [m]
    /// @param kept surface that the vertices are added to
    KeptVertices(const TriangleSurface& whole, const std::vector<double>& distance, TriangleSurface& kept)
        : whole_(whole), distance_(distance), kept_(kept), place_(whole.vertices.size(), -1)
    {
    }
    /// Vertex of the kept surface that vertex v of the whole is.
    int keep(int v)
    {
        if (place_[v] < 0) place_[v] = add(whole_.vertices[v]);
        return place_[v];
    }
    /// Where the edge from a to b meets the plane: the same point, to the last bit, from both sides of the plane
    /// and from both triangles at the edge.
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

 private:
    int add(const Eigen::Vector3d& x)
    {
        kept_.vertices.push_back(x);
        return static_cast<int>(kept_.vertices.size()) - 1;
    }

    const TriangleSurface& whole_;
    const std::vector<double>& distance_;
    TriangleSurface& kept_;
    std::vector<int> place_;  // of the whole's vertices
    std::map<std::pair<int, int>, int> cuts_;
};

}  // namespace voussoir::importers::exact
