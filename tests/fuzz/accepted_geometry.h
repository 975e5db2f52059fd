// What must hold of every answer of the geometry helper that is believed: asked by the fuzzer and by the test of
// damaged answers.
#pragma once

#include <stdexcept>
#include <string>

#include "importers/helper/geometry.h"

namespace voussoir
{

inline void check_accepted_stone(const importers::helper::Stone& stone)
{
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw std::logic_error(std::string("a believed stone ") + what);
    };
    const Moments& moments = stone.moments;
    require(moments.centroid.allFinite() && moments.second.allFinite(), "lies nowhere");
    require(stone.reason.empty() ? moments.volume > 0 && !stone.parts.empty() : true, "has no volume");
    for (const ConvexPolyhedron& part : stone.parts)
        for (const Eigen::Vector3d& x : part.vertices) require(x.allFinite(), "has a vertex that is nowhere");
    for (const std::vector<int>& face : stone.faces)
        for (const int vertex : face)
            require(vertex >= 0 && vertex < static_cast<int>(stone.vertices.size()),
                    "has a face with a vertex that is not there");
}

/// @throws std::logic_error that says what does not hold
inline void check_accepted(const importers::helper::Geometry& geometry)
{
    if (!geometry.origin.allFinite()) throw std::logic_error("a believed origin is nowhere");
    for (const importers::helper::ImportedMesh& mesh : geometry.meshes) {
        if (!(mesh.metres_per_unit > 0)) throw std::logic_error("a believed mesh has no unit");
        for (const importers::helper::Stone& stone : mesh.stones) check_accepted_stone(stone);
    }
}

}  // namespace voussoir
