// Stones that lie in each other.
#pragma once

#include <span>
#include <vector>

#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::exact
{

/// Volume shared by two convex polyhedra [m3].
///
/// Pairs that a face plane of either one separates share exactly nothing. Otherwise one is clipped by the planes
/// of the other as a closed surface: each vertex is judged once for all faces that use it, so that rounding moves
/// the answer by rounding only, also where faces coincide.
double overlap_volume(const ConvexPolyhedron& a, const ConvexPolyhedron& b);

/// Two entries of a list that overlap.
struct OverlappingPair {
    int a = 0, b = 0;     // a < b
    double volume = 0;    // m3
    double fraction = 0;  // of the smaller one's volume
};

/// All pairs of stones, each a list of convex parts, whose shared volume exceeds `tolerance` times that of the
/// smaller one. Bounding boxes are swept along x first.
std::vector<OverlappingPair> find_overlaps(std::span<const std::vector<ConvexPolyhedron>> stones,
                                           double tolerance = 1e-6);

}  // namespace voussoir::importers::exact
