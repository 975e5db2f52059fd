// The surfaces of a file as certified stones.
#pragma once

#include <string>
#include <vector>

#include "importers/helper/geometry.h"
#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::helper
{

/// A file in metres.
struct ReadFile {
    std::vector<mesh::PolygonSurface> surfaces;
    double rounding = 0;  // m, on reading
};

/// Takes the surfaces apart into stones, leaves out those that the request does not want, and certifies the others
/// as it wants them, into `mesh`. @param origin subtracted from all coordinates [m]
void certify_all(ReadFile file, const MeshRequest& request, const Eigen::Vector3d& origin, ImportedMesh& mesh);

/// Three digits.
std::string short_number(double value);

}  // namespace voussoir::importers::helper
