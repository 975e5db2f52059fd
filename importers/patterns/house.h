// Four walls around a rectangle, in running bond with bonded corners.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "importers/patterns/masonry.h"

namespace voussoir::importers::patterns
{

/// A wall of the house: y = 0, x = length, y = width, x = 0.
enum class Side {
    south,  // along x
    east,   // along y
    north,  // along x
    west,   // along y
};

/// As in block names.
constexpr std::array<const char*, 4> side_names = {"south", "east", "north", "west"};

/// An opening in one of the four walls; its `at` is measured along x (south, north) or y (east, west) from the
/// outer corner of the house.
struct HouseOpening {
    Side side = Side::south;  // whose wall
    Opening opening;          // where in it
};

/// All lengths in m.
struct House {
    std::string name = "house";                     // beginning of the block names
    double length = 6, width = 5, height = 3;       // outside, along x, y, z
    double wall_thickness = 0.4;                    // of all four walls
    double block_length = 0.6, block_height = 0.3;  // m
    std::vector<HouseOpening> openings;             // doors and windows
    Lintel lintel{0.3, 0.3};                        // over every opening that does not reach the top
    MasonryBase base{0.3, 0};                       // one slab
    Imperfection imperfection;                      // none by default
    Placement placement;                            // at the origin by default
};

/// The blocks: NAME_base, then wall by wall NAME_south_c01_b01, ..., NAME_south_lintel_1, ... with north, east,
/// west. The outside of the house is 0 <= x <= length, 0 <= y <= width, the foot of the walls z = 0; then it is
/// placed. Neighbours share coordinates bit for bit before they are turned and disturbed.
///
/// South and north run through to the corners in even courses, counted from 0, east and west in the others. Joints
/// lie whole block lengths from the inner corner where a wall ends there, half a length off where it runs through.
/// All walls have the same courses. The base is one slab under the whole house.
/// @throws InputError with every parameter that makes no house, named as in the case file ("openings[1]")
std::vector<MasonryBlock> house(const House& house);

}  // namespace voussoir::importers::patterns
