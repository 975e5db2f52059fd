// What of a solid lies in a convex cell of space.
#pragma once

#include <utility>
#include <vector>

#include "importers/exact/cut_solid.h"

namespace voussoir::importers::exact
{

/// A cell bounded by planes, and what is needed for the hull of the solid in it: the solid's own surface is
/// clipped, and no cap is made, which rough surfaces would make hard. The hull's other corners lie where three
/// walls of the cell meet inside the solid.
struct Cell {
    std::vector<CutPlane> walls;           // normals out of the cell
    TriangleSurface surface;               // of the solid within the cell; open at the walls
    std::vector<Eigen::Vector3d> corners;  // m: of three walls, inside the solid
};

/// The two cells that a plane makes of one: behind it and before it.
/// @param solid the whole solid, closed and outward: it decides which corners of walls lie inside
std::pair<Cell, Cell> divided(const Cell& cell, const CutPlane& plane, const TriangleSurface& solid);

/// The convex hull of the solid in a cell; no triangles when that is flat.
TriangleSurface hull_of(const Cell& cell);

/// Its volume, by plain doubles [m3].
double hull_volume_of(const Cell& cell);

/// A surface of fewer vertices: those in a box of a grid become the first of them, and triangles without three
/// different corners go. A closed surface stays closed, though not free of crossings: for estimates.
/// @param vertices about as many at most
TriangleSurface coarsened(const TriangleSurface& surface, std::size_t vertices);

}  // namespace voussoir::importers::exact
