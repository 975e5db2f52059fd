// What must hold of every mesh that a reader accepts, whatever the file: asked by the fuzzer and by the test of
// damaged meshes.
#pragma once

#include <stdexcept>
#include <string>

#include "importers/mesh/polygon_surface.h"

namespace voussoir
{

/// @throws std::logic_error that says what does not hold
inline void check_accepted(const importers::mesh::MeshFile& mesh)
{
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw std::logic_error(std::string("an accepted mesh ") + what);
    };
    require(!mesh.surfaces.empty(), "has no surface");
    for (const importers::mesh::PolygonSurface& surface : mesh.surfaces) {
        require(!surface.faces.empty(), "has a surface without faces");
        for (const Eigen::Vector3d& x : surface.vertices) require(x.allFinite(), "has a vertex that is nowhere");
        for (const std::vector<int>& face : surface.faces)
            for (const int vertex : face)
                require(vertex >= 0 && vertex < static_cast<int>(surface.vertices.size()),
                        "has a face with a vertex that is not there");
    }
    require(!mesh.metres_per_unit || *mesh.metres_per_unit > 0, "has no unit");
}

}  // namespace voussoir
