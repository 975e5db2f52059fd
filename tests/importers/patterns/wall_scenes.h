// The walls the tests are about.
#pragma once

#include "importers/patterns/wall.h"

namespace voussoir::importers
{

/// `across` blocks of 0.5 m x 0.25 m in a course, `up` courses, 0.3 m thick.
inline patterns::Wall whole_wall(int across, int up)
{
    patterns::Wall wall;
    wall.length = 0.5 * across;
    wall.height = 0.25 * up;
    wall.thickness = 0.3;
    wall.block_length = 0.5;
    wall.block_height = 0.25;
    wall.lintel = {0.25, 0.25};
    return wall;
}

/// One with a door, a window whose sill and head lie between courses, and an opening up to the top.
inline patterns::Wall pierced_wall()
{
    patterns::Wall wall = whole_wall(16, 12);
    wall.openings = {{1, 0, 1, 1.75}, {3.3, 0.85, 0.9, 0.8}, {6, 1.5, 1, 1.5}};
    wall.base = {0.3, 0.1};
    return wall;
}

}  // namespace voussoir::importers
