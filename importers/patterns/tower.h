// Round, square and octagonal towers of storeys, in running bond.
#pragma once

#include "importers/patterns/facade.h"
#include "importers/patterns/imperfection.h"

namespace voussoir::importers::patterns
{

/// A hole through the wall of a storey, in the middle of a side. Lengths in m, from the foot of the storey.
struct TowerOpening {
    int side = 0;       // 0 south, then counter-clockwise; of a round tower quarters: south, east, north, west
    double sill = 0;    // 0: a door
    double width = 0;   // outside
    double height = 0;  // above the sill
};

/// From the top of the one below to its own.
struct Storey {
    std::string name;      // begins the names of its stones, and is their group; empty: storey_1, ...
    double height = 0;     // m
    double thickness = 0;  // m, of its wall; outer faces are flush
    double floor = 0;      // kg, of a floor, a vault, bells or a roof, on the stones of its last course alike
    std::vector<TowerOpening> openings;
};

/// All lengths in m.
struct Tower {
    std::string name;  // before the names of its stones; may be empty
    int sides = 4;     // 4, 8; 0: round
    double width = 5;  // outside, across the flats or the diameter
    BlockFormat block{0.8, 0.4};
    double bearing = 0.4;  // of lintels on either side
    std::vector<Storey> storeys;
    double base_height = 0.5;  // of the slab
    double base_projection = 0.3;
    StoneImperfection imperfection;
};

/// "base", then storey by storey "storey_1_c01_b01" ..., "storey_1_lintel_1". x and y from the axis, the south
/// side at y = -width / 2; z up, the foot of the first storey at z = 0.
///
/// Stones reach through the wall. Beds lie at the foot, the top, every sill, every head and the top of every
/// lintel of a storey, and divide the heights between them into equal courses. Head joints are normal to the
/// face, half a stone off in every second course; stones at corners bend round them, of two convex parts glued in
/// the mitre. Lintels are as high as a course.
/// @throws InputError with every parameter that makes no tower
Pattern tower(const Tower& tower);

}  // namespace voussoir::importers::patterns
