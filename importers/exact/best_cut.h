// The plane that brings two hulls nearest to a rough solid.
#pragma once

#include <optional>

#include "importers/exact/cell.h"

namespace voussoir::importers::exact
{

/// A cut of a cell and what it leaves.
struct BestCut {
    CutPlane plane;
    double volume = 0;  // m3, of the two hulls together
};

/// Tries planes across the principal axes of the cell's content and the diagonals between them, across the largest
/// faces, and through the places that lie deepest below the hull; then tilts and moves the best of them. A plane
/// that part of the surface lies in is none: a face of a part belongs to the surface or to a cut, never to both.
/// @param cell of a coarse surface, some thousand triangles at most; @param solid all of that
/// @param tolerance [m] within which a triangle lies in a plane; @param least volume of a piece [m3]
/// @returns nothing when no plane leaves two hulls that are smaller than the one
std::optional<BestCut> best_cut(const Cell& cell, const TriangleSurface& solid, double tolerance, double least);

}  // namespace voussoir::importers::exact
