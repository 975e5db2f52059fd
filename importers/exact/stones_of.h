// One surface that holds several stones, taken apart.
#pragma once

#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"
#include "importers/mesh/repair.h"

namespace voussoir::importers::exact
{

/// The stones of one surface.
struct SeparatedStones {
    std::vector<mesh::PolygonSurface>
        stones;                         // named NAME, or NAME.1, NAME.2 ... in the order of their first faces
    std::vector<mesh::Repair> repairs;  // what was done
};

/// The shells of a surface (shell_of_faces), each with vertices of its own.
std::vector<mesh::PolygonSurface> shells_of(const mesh::PolygonSurface& surface);

/// Does a closed shell lie inside another one, without touching it? Directions of faces do not matter.
bool lies_inside(const mesh::PolygonSurface& shell, const mesh::PolygonSurface& host);

/// Takes a surface apart into its closed shells. A shell inside another one is that one's cavity and stays with
/// it. A surface with fewer than two closed shells is left as it is.
/// @param surface in any unit @param weld_tolerance share of its diagonal within which vertices are one
SeparatedStones separate_stones(mesh::PolygonSurface surface, double weld_tolerance);

}  // namespace voussoir::importers::exact
