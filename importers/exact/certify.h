// From a surface as it comes to convex polyhedra that are proven valid, or to the reason why not.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "importers/exact/decompose.h"
#include "importers/exact/simplify.h"
#include "importers/exact/surface_checks.h"
#include "importers/mesh/marked_feature.h"
#include "importers/mesh/polygon_surface.h"
#include "importers/mesh/repair.h"
#include "libdda/geometry/convex_polyhedron.h"
#include "libdda/geometry/moments.h"

namespace voussoir::importers::exact
{

/// What is still accepted.
struct CertifyOptions {
    // vertices closer than weld_tolerance x bounding diagonal become one
    double weld_tolerance = 1e-6;
    // a vertex may lie outside a face's plane, or a corner off it, by planarity_tolerance x bounding diagonal
    double planarity_tolerance = 1e-5;
    // less than smallest_volume x bounding diagonal^3 is no volume
    double smallest_volume = 1e-9;
    int max_parts = 64;              // of a concave stone
    double volume_error = 0.01;      // share of its volume by which the parts of a concave stone may exceed it
    std::vector<CutPlane> joints{};  // of the stone, where they were fitted: concave ones are cut exactly at them
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m, added to coordinates in messages
    int triangles = 0;                                 // the surface is decimated to so many first; 0: it is not
    std::optional<SimplifyOptions> simplify{};         // a concave stone becomes a few parts, near enough
    bool hull = false;                                 // the convex hull takes the place of the stone
    bool hull_if_refused = false;                      // the same of a stone that is refused otherwise
    std::string refuse_because{};                      // what is known against it already; empty: nothing
};

/// What is proven about one stone.
struct Certificate {
    std::string name;                     // of the stone
    bool closed = false, convex = false;  // proven
    std::string reason;                   // why it was refused; empty when accepted
    std::string cure;                     // of a refused one what would help: "hull", "skip" or "simplify"
    std::vector<mesh::Repair> repairs;    // every repair, in words, with numbers
    std::vector<ConvexPolyhedron> parts;  // one, or the glued parts of a concave stone; empty when refused
    Moments moments;          // of the surface as drawn, known when it is closed and does not cross itself
    double volume_error = 0;  // share of the volume by which the parts differ from it
    std::vector<mesh::MarkedFeature> features;  // what is wrong where
    mesh::PolygonSurface surface;               // as it was judged
    SurfaceExamination examination;             // of that surface
    double diagonal = 0;                        // m, of the surface as it came
};

/// Welds, mends what has one cure (repeated faces, triangles without area, faces that meet without sharing their
/// corners), then proves in this order: closed, consistently oriented (faces are turned if need be, and it is
/// said), one outside with or without cavities, faces with area, not crossing itself, outward (a shell inside out
/// is turned), a volume. A convex stone becomes one part with coplanar faces merged into polygons, a concave one
/// several (decompose).
/// @param surface in metres, z up, near the origin
Certificate certify(mesh::PolygonSurface surface, const CertifyOptions& options = {});

/// The first half of it, all that concerns the surface: welded, mended, proven closed, oriented, not crossing
/// itself, outward, with a volume. No parts yet.
Certificate certify_surface(mesh::PolygonSurface surface, const CertifyOptions& options = {});

/// The second half: the convex parts of a surface that was proven sound, or what becomes of one that was refused.
Certificate certify_shape(Certificate sound, const CertifyOptions& options = {});

}  // namespace voussoir::importers::exact
