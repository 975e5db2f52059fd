// Where openings and their lintels leave wall, and where they do not.
#pragma once

#include <cmath>

#include "importers/patterns/masonry.h"

namespace voussoir::importers::patterns
{

constexpr double smallest_piece = 1.0 / 3;  // of a block's length or height
constexpr double same_place = 1e-6;         // of a block's length or height: nearer than that is the same

/// A part of a wall as seen from the front [m].
struct Patch {
    double left = 0, right = 0, foot = 0, top = 0;
    bool has_height(double z) const { return foot < z && z < top; }
};

inline Patch patch_of(const Opening& opening)
{
    return {opening.at, opening.at + opening.width, opening.sill, opening.sill + opening.height};
}

/// The lintel over an opening.
inline Patch patch_of(const Opening& opening, const Lintel& lintel)
{
    const Patch hole = patch_of(opening);
    return {hole.left - lintel.bearing, hole.right + lintel.bearing, hole.top, hole.top + lintel.height};
}

/// Does wall lie above it? @param height of the wall [m]
inline bool needs_lintel(const Opening& opening, double height)
{
    return patch_of(opening).top < height * (1 - 1e-9);
}

}  // namespace voussoir::importers::patterns
