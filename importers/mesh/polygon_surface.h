// Polygon surfaces as mesh files hold them: nothing is promised about them yet.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace voussoir::importers::mesh
{

/// One named surface, one stone to be. Faces are loops of vertex indices in the order of the file.
struct PolygonSurface {
    std::string name;                       // of the stone
    std::vector<Eigen::Vector3d> vertices;  // in the unit and axes of whoever holds it
    std::vector<std::vector<int>> faces;    // every index names a vertex; nothing else is known
};

/// What a mesh file holds, in its own unit and axes, with the transforms of its nodes applied.
struct MeshFile {
    std::vector<PolygonSurface> surfaces;   // with unique names
    double rounding = 0;                    // file units: largest rounding on reading; 0: every digit was kept
    std::optional<double> metres_per_unit;  // as the file or its format states it; absent: it does not say
    std::optional<char> up;                 // 'x', 'y' or 'z', likewise
    std::vector<std::string> repairs;       // what was changed or left out on reading, in words
};

}  // namespace voussoir::importers::mesh
