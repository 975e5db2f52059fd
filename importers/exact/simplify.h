// A rough stone as a few convex parts that nearly fill it.
#pragma once

#include <string>
#include <vector>

#include "importers/exact/triangle_surface.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::exact
{

/// How simple, and how near.
struct SimplifyOptions {
    int max_parts = 64;       // convex ones
    double volume_error = 0;  // share of the volume by which the parts may exceed the stone; 0: any
    double planarity = 1e-5;  // share of the diagonal by which a face of a part may bulge
};

/// What became of a stone.
struct SimplifiedStone {
    std::vector<ConvexPolyhedron> parts;  // empty when `reason` says why
    double volume_error = 0;              // share of the volume: that of the parts less that of the stone
    double lack = 0;                      // share of the volume of the stone that lies outside the parts
    double smoothed = 0;                  // m: corners that stood out by less were dropped
    double depth = 0;                     // m: how deep a vertex of the stone lies below the surface of the parts
    std::string reason;                   // why it was refused; empty when it was not
};

/// Divides a solid by planes into cells, each time where that brings the hulls of what is in the cells nearest to
/// it. Planes are looked for on a coarse copy of about a thousand vertices; the hulls are those of the solid's own
/// vertices, so that the hull of all parts is the hull of the solid: it stands and tilts on the same points. Hulls
/// never leave their cells, so that parts do not overlap and only add volume. Where the allowed parts add more
/// than is allowed, corners that stand out of the hulls by less than a length are dropped, the smallest that will
/// do, but none on the underside of the whole (facets within 45 degrees of straight down). A face of a part in a
/// cut is glued if other parts cover most of it.
/// @param surface closed, outward, z up [m]
SimplifiedStone simplify(const TriangleSurface& surface, const SimplifyOptions& options,
                         const std::string& name = "stone");

}  // namespace voussoir::importers::exact
