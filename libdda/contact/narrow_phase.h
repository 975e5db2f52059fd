// Contact of two convex parts: a clipped face polygon, or the crossing point of two edges.
#pragma once

#include <optional>
#include <vector>

#include "libdda/contact/contact_polygon.h"
#include "libdda/contact/placed_part.h"

namespace voussoir::contact
{

/// Separating-axis test on faces and edge pairs; the axis of largest signed separation wins, with hysteresis for
/// last step's face and a preference of faces over edge pairs. A face axis clips the incident face against the
/// side planes of the reference face; the tributary area of a corner is half the area of its two triangles with
/// the polygon's area centroid, so that areas and first moments of areas are exact. Polygons below 1e-7 L^2 are
/// skipped (ghost contacts of diagonal neighbours). Source: docs/numerics.md 2.5; clipping:
/// [SutherlandHodgman1974].
/// @param margin [m] parts further apart than this do not touch
/// @param fit_tolerance [m] faces that are no deeper than this within one another touch as faces: of two that were
/// drawn a little askew, edges that cross would part them by a shorter shift, and carry them on a point
std::optional<ContactPolygon> contact_polygon(const PlacedPart& first, const PlacedPart& second, double margin,
                                              const std::optional<LastContact>& last, double fit_tolerance = 0);

/// Gives every point of a planar polygon its tributary area. Exposed for its test.
void assign_tributary_areas(std::vector<PolygonPoint>& points, const Eigen::Vector3d& normal);

}  // namespace voussoir::contact
