// What a survey makes of drawn stones: joints that are not flat, corners measured twice, diagonals of one's own.
#pragma once

#include <cstdint>

#include "importers/mesh/polygon_surface.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{

/// How quadrilaterals are cut into triangles.
enum class Diagonals {
    none,    // they are not
    shared,  // the two stones at a joint cut it along the same diagonal
    random,  // each stone cuts it along a diagonal of its own
};

/// How far surveyed stones differ from drawn ones. Every number is drawn evenly from its range by a generator of
/// our own: the same seed gives the same stones on every machine, and one amount does not change what the others
/// draw. The size of a stone is the cube root of its volume.
struct Survey {
    std::uint64_t seed = 1;  // of the generator
    double warp = 0;   // -, corners of joints are moved by up to this share of the smallest stone at the corner
                       // along x, y and z, for all stones at the corner alike: joints stay shared
    double noise = 0;  // -, then every stone's own vertices by up to this share of its size
    Diagonals diagonals = Diagonals::none;
};

/// The stones of a grid as they are surveyed, counter-clockwise from outside, each with vertices of its own.
/// Corners that the grid holds are not warped. @throws InputError with every amount that is out of its range
std::vector<mesh::PolygonSurface> surveyed(const StoneGrid& grid, const Survey& survey);

}  // namespace voussoir::importers::patterns
