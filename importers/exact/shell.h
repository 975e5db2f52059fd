// How the faces of a surface hang together.
#pragma once

#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::exact
{

/// How the edges of a surface are used; an edge is listed as (smaller vertex, larger vertex).
struct EdgeUse {
    std::vector<std::pair<int, int>> open;       // one face only
    std::vector<std::pair<int, int>> branching;  // more than two faces
    std::vector<std::pair<int, int>> clashing;   // two faces that run along it in the same direction
};

EdgeUse edge_use(const mesh::PolygonSurface& surface);

/// What shells that touch in an edge only, no face on a face, are taken for.
enum class TouchingEdges {
    connect,  // that may as well be a mistake
    part,     // they are known to be sound
};

/// For every face the number of its shell, in the order of first faces. Shells are faces connected by edges; where
/// stones touch face to face and share vertices, more than two faces meet in an edge, and each is followed round
/// through the inside of its stone to its own neighbour.
std::vector<int> shell_of_faces(const mesh::PolygonSurface& surface,
                                TouchingEdges touching = TouchingEdges::connect);

/// How often a closed surface winds round a point: 1 inside, 0 outside. Source: [VanOosteromStrackee1983].
double winding_number(const mesh::PolygonSurface& surface, const Eigen::Vector3d& point);

}  // namespace voussoir::importers::exact
