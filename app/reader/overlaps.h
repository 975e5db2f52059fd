// Do stones that came from different places overlap? Mesh files certify their own stones; boxes and polygons are
// checked here.
#pragma once

#include <utility>
#include <vector>

#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// Depth by which two convex shapes overlap [m]: the shortest shift that parts them; <= 0 if they do not.
/// Exact, by the separating axes: face normals of both and cross products of their edges.
/// @param offset of b relative to a [m]
/// Source: [Gottschalk1996].
double overlap_depth(const ConvexPolyhedron& a, const ConvexPolyhedron& b, const Eigen::Vector3d& offset);

/// The same of two outlines, by the normals of their sides.
double overlap_depth(const ConvexPolygon& a, const ConvexPolygon& b, const Eigen::Vector2d& offset);

struct BlockOverlap {
    int block_a = 0, block_b = 0;
    double depth = 0;  // m
};

/// No more are looked for: stones drawn in one place overlap all with all.
constexpr std::size_t max_overlaps = 1000;

/// Pairs of blocks, at least one of them among the first `count`, that overlap by more than 1e-6 of the smaller
/// one's diagonal.
std::vector<BlockOverlap> find_overlaps(const std::vector<Block>& blocks, std::size_t count);

}  // namespace voussoir::app::reader
