// A body of rock cut by sets of joints.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::exact
{

/// Parallel joints through a body.
struct JointSet {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, upwards
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();   // m, a point of the joint that the others are counted from
    double spacing = 1;                                 // m, between neighbours along the normal
    double scatter = 0;      // -, share of the spacing by which each joint lies off its place, evenly up to this
    double persistence = 1;  // -, chance of a joint to cut a piece; where it does not, it ends at the joints of
                             // earlier sets that bound the piece
};

/// What is cut, and how.
struct RockRequest {
    std::vector<ConvexPolyhedron> domain;  // convex parts that share whole faces, m; one body
    std::vector<JointSet> sets;            // the later ones end at the earlier ones
    std::uint64_t seed = 1;                // of scatter and persistence
    double smallest = 0;                   // m3: smaller blocks are left out
    bool merge = false;                    // or, where they can, become part of a neighbour: see merge_small.h
    std::size_t most = 100'000;            // blocks
};

/// A block, of glued parts where the body is concave.
struct RockBlock {
    std::vector<ConvexPolyhedron> parts;  // m
    double volume = 0;                    // m3, exact until it was rounded
};

/// All blocks, and what was left out.
struct CutRock {
    std::vector<RockBlock> blocks;  // in the order of the joints, not of size
    double domain_volume = 0;       // m3
    double volume = 0;              // m3, of all pieces, those left out among them: summed exactly, then rounded
    int removed = 0;                // blocks
    double removed_volume = 0;      // m3
    int merged = 0;                 // blocks that became part of others
    double merged_volume = 0;       // m3
};

/// Cuts a body by exact constructions: which side of a joint a corner lies on is never a matter of rounding, and
/// the pieces add up to the body. Corners are rounded to doubles at the end.
/// @throws InputError when there are more than `most` blocks
CutRock cut_rock(const RockRequest& request);

}  // namespace voussoir::importers::exact
