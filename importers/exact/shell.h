// What the faces of a surface say about its topology, without any arithmetic.
#pragma once

#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"

namespace voussoir
{

/// How the edges of a surface are used; an edge is listed as (smaller vertex, larger vertex).
struct EdgeUse {
    std::vector<std::pair<int, int>> open;       // one face only
    std::vector<std::pair<int, int>> branching;  // more than two faces
    std::vector<std::pair<int, int>> clashing;   // two faces that run along it in the same direction
};

EdgeUse edge_use(const PolygonSurface& surface);

/// Number of shells: faces connected by edges.
int shells(const PolygonSurface& surface);

}  // namespace voussoir
