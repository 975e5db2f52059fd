// From the spaces blocks were drawn in to the blocks themselves.
#pragma once

#include <string>
#include <vector>

#include "importers/patterns/masonry.h"

namespace voussoir::importers::patterns
{

/// The space one block was drawn in, in the pattern's own axes.
struct Cell {
    enum class Kind { stone, lintel, base };
    std::string name;
    Eigen::Vector3d lower, upper;  // m
    int along = 0;                 // 0, 1: its wall runs along x, y
    Kind kind = Kind::stone;
    bool held_below = false, held_above = false;  // another block stands across the wall, on the lower, upper side
};

/// Draws the imperfections and puts every block in place. @param flat nothing is drawn across the wall
std::vector<MasonryBlock> blocks_in(const std::vector<Cell>& cells, const Imperfection& imperfection, bool flat,
                                    const Placement& placement);

/// Adds the slab under all cells, first. @param flat it projects only along x
void add_base(const std::string& name, const MasonryBase& base, const Eigen::Vector2d& size, bool flat,
              std::vector<Cell>& cells);

}  // namespace voussoir::importers::patterns
