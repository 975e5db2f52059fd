// Vertices that are meant to be one.
#pragma once

#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::exact
{

struct WeldReport {
    int identical = 0;        // vertices that repeated another one bit for bit
    int moved = 0;            // vertices that lay apart from the one they became
    double largest_move = 0;  // unit of the surface
    int shortened_faces = 0;  // faces that lost repeated corners
    int removed_faces = 0;    // faces that were left with fewer than three corners
};

/// Every vertex within `tolerance` (unit of the surface) of an earlier one becomes that one; faces lose repeated
/// corners, faces without three corners go, and so do vertices that no face uses.
WeldReport weld(mesh::PolygonSurface& surface, double tolerance);

/// Keeps only the vertices that faces use, in their order.
void drop_unused_vertices(mesh::PolygonSurface& surface);

}  // namespace voussoir::importers::exact
