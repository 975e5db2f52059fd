// Convex polygons: the outline of a block of a planar scene, or of a part of a glued one.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "libdda/geometry/moments.h"

namespace voussoir
{

/// A convex polygon in the (x, z) plane. Made only by make_convex_polygon, so that whoever holds one may rely on
/// it.
struct ConvexPolygon {
    std::vector<Eigen::Vector2d> vertices;  // m, in the sense from x to z, no three on a line
};

/// Checks convexity; turns the loop round when it runs the other way and drops corners on straight lines.
/// @param vertices (n) [m] the loop; @param name names the stone in error messages
/// @param tolerance share of the bounding diagonal a corner may lie off a straight line or inside the hull
/// @throws InputError when the outline is degenerate, not convex or crosses itself
ConvexPolygon make_convex_polygon(std::vector<Eigen::Vector2d> vertices, const std::string& name = "outline",
                                  double tolerance = 1e-9);

/// An axis-aligned rectangle. @param lower, upper opposite corners [m]
ConvexPolygon make_rectangle(const Eigen::Vector2d& lower, const Eigen::Vector2d& upper);

/// The outline of a prism whose axis is y: the face that looks along -y. @param depth its extent in y [m]
/// @throws InputError when the shape is not such a prism
ConvexPolygon outline_of(const ConvexPolyhedron& prism, double& depth, const std::string& name = "prism",
                         double tolerance = 1e-6);

/// Moments of outlines of one thickness about their common centroid, in space: y is 0 and does not enter.
/// Source: [Shi1988] (simplex integration), triangles from a vertex of each outline.
Moments moments_of(const std::vector<ConvexPolygon>& outlines, double thickness);

}  // namespace voussoir
