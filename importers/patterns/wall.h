// A straight wall in running bond.
#pragma once

#include <string>
#include <vector>

#include "importers/patterns/masonry.h"

namespace voussoir::importers::patterns
{

/// A wall of blocks that reach through it, or of several leaves. All lengths in m.
struct Wall {
    std::string name = "wall";                       // beginning of the block names
    double length = 4, height = 3, thickness = 0.4;  // m
    double block_length = 0.6, block_height = 0.3;   // m
    int leaves = 1;                           // side by side through the thickness, their joints half a block off
    std::vector<double> leaf_thickness = {};  // m, of each leaf from y = 0; empty: all alike
    int header_every = 0;                     // every so manyth course reaches through all leaves; 0: none
    std::vector<Opening> openings;            // doors and windows
    Lintel lintel{0.3, 0.3};                  // over every opening that does not reach the top
    MasonryBase base;                         // none
    Imperfection imperfection;                // none by default
    Placement placement;                      // at the origin by default
    bool flat = false;                        // a slice of a planar scene: nothing stands out of its faces
};

/// The blocks from the foot up, each course from its beginning: NAME_base, NAME_c01_b01, ..., NAME_lintel_1, ...;
/// with leaves NAME_c01_l1_b01, .... The wall runs along x from 0 to length, its faces are y = 0 and thickness,
/// its foot is z = 0; then it is placed. Neighbours share coordinates bit for bit before they are turned and
/// disturbed.
///
/// Joints of even courses lie whole block lengths from the beginning, those of the others half a length off, so
/// that these begin with half a block; the last block of a course and the last course are cut to fit. Pieces
/// shorter than a third of a block are part of their neighbour. How courses and joints make way for openings is
/// said in facade.h.
/// @throws InputError with every parameter that makes no wall, named as in the case file ("openings[1]")
std::vector<MasonryBlock> wall(const Wall& wall);

}  // namespace voussoir::importers::patterns
