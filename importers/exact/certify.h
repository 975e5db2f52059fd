// From a surface as it comes to a convex polyhedron that is proven valid, or to the reason why not.
#pragma once

#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir
{

struct CertifyOptions {
    // vertices closer than weld_tolerance x bounding diagonal become one
    double weld_tolerance = 1e-6;
    // a vertex may lie outside a face's plane, or a corner off it, by planarity_tolerance x bounding diagonal
    double planarity_tolerance = 1e-6;
    // less than smallest_volume x bounding diagonal^3 is no volume
    double smallest_volume = 1e-9;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m, added to coordinates in messages
};

/// What is proven about one stone.
struct Certificate {
    std::string name;
    bool closed = false, convex = false;
    std::string reason;                   // why it was refused; empty when accepted
    std::vector<std::string> repairs;     // every repair, in words, with numbers
    std::vector<ConvexPolyhedron> parts;  // one convex part; empty when refused
};

/// Welds, then proves in this order: closed, consistently oriented (faces are turned if need be, and it is said),
/// one shell, faces with area, not crossing itself, outward (a shell inside out is turned), a volume, convex.
/// Coplanar faces are merged into polygons.
/// @param surface in metres, z up, near the origin
Certificate certify(PolygonSurface surface, const CertifyOptions& options = {});

}  // namespace voussoir
