// What walls and houses have in common: what their user may say, and what comes out.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::patterns
{

/// A hole through the whole thickness of a wall. Lengths in m, from the foot and the beginning of the wall.
struct Opening {
    double at = 0;      // along the wall, to the near jamb
    double sill = 0;    // 0: a door
    double width = 0;   // along the wall
    double height = 0;  // above the sill
};

/// The one block over an opening; an opening up to the wall's top has none.
struct Lintel {
    double height = 0;   // m
    double bearing = 0;  // m, on either side of the opening
};

/// The slab under the first course: one block, NAME_base.
struct MasonryBase {
    double height = 0;      // m; 0: there is none
    double projection = 0;  // m, beyond the walls on all sides
};

/// How far real blocks differ from drawn ones. Every number is drawn evenly from its range, five for each block in
/// the order of the blocks (length, thickness, place along, place across, friction), by a generator of our own:
/// the same seed gives the same wall on every machine, and one amount does not change what the others draw.
///
/// Nothing ever overlaps, and beds stay planar: heights are never touched. A block stays in the space it was
/// drawn in, but for its two faces: across the wall it may stand out by up to `joint`, except on a side where
/// another block stands (the other wall at a corner, another leaf). The base and the lintels keep size and place.
struct Imperfection {
    std::uint64_t seed = 1;  // of the generator
    double size = 0;         // -, blocks are shorter and thinner by 0 to this share, in the middle of their space
    double joint = 0;        // m, then moved by -joint to +joint along the wall and across it
    double friction = 0;     // -, friction factor from 1 - friction to 1 + friction; the base keeps 1
};

/// Where the pattern's own axes lie: turned about z, then moved.
struct Placement {
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m, of the first course's outer lower corner
    double direction = 0;                              // rad, from x to y
};

/// One block of a pattern, in place.
struct MasonryBlock {
    std::string name;  // unique in its pattern
    std::array<Eigen::Vector3d, 8>
        corners;                 // m; number i: upper along the pattern's x, y, z where bit 0, 1, 2 is set
    double friction_factor = 1;  // -, on the coefficient of friction of its joints
};

/// The block as a surface of six faces, for mesh files.
mesh::PolygonSurface to_surface(const MasonryBlock& block);

/// The block as the engine takes it, checked. @throws InputError when rounding at a far origin leaves no box
ConvexPolyhedron to_polyhedron(const MasonryBlock& block);

}  // namespace voussoir::importers::patterns
