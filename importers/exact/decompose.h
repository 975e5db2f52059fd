// Concave stones as convex parts that are glued together.
#pragma once

#include <string>
#include <vector>

#include "importers/exact/cut_solid.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::exact
{

/// How far to cut.
struct DecomposeOptions {
    double planarity = 1e-5;     // share of the diagonal by which a face may bulge inward and still count as flat
    int max_exact_edges = 48;    // stones with more reentrant edges are approximated
    int max_parts = 64;          // of any stone
    double volume_error = 0.01;  // share of the volume that is allowed to approximating parts
    // Planes of its joints: a stone that has any is cut exactly at the edges that lie in one of them, and only
    // there if the hulls of its pieces exceed it by little.
    std::vector<CutPlane> joints{};
};

/// What became of a solid.
struct Decomposition {
    // Their faces that lie in a cut are marked as glued. Empty when `reason` says why.
    std::vector<ConvexPolyhedron> parts;
    int reentrant_edges = 0;  // of the solid
    double volume_error = 0;  // share of the volume by which the parts together exceed the stone; 0 when exact
    std::string reason;       // why it was not cut; empty when it was
};

/// Cuts a solid by planes through its reentrant edges until every piece is convex. Each plane is chosen to leave
/// as few reentrant edges and pieces as it can, and lies in no face, so that a face of a part belongs to the
/// surface or to a cut, never to both. The parts are convex hulls by exact predicates, and their volume is
/// compared with the solid's. A solid of many reentrant edges is cut where that brings the hulls of the pieces
/// nearest to it, until they exceed it by less than the allowed share of its volume: the hull of a piece never
/// leaves its side of a cut, so that parts do not overlap. Source: [Chazelle1984] (notch resolution); the choice
/// of planes is ours.
/// @param surface closed, outward, not crossing itself [m]
Decomposition decompose(const TriangleSurface& surface, const DecomposeOptions& options = {},
                        const std::string& name = "stone");

}  // namespace voussoir::importers::exact
