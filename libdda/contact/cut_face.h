// Faces cut where they begin to press.
//
// Where the gap of a face changes its sign, the part that presses and the part that is apart have points of their
// own. Points of a polygon have its area, centroid and second moments (face_points.h), so that a gap which is
// linear over the pressing part gives force and moments to rounding: those of an elastic joint without tension.
// The line is that of the beginning of the step. What it moves within the step counts little, for beside it the
// pressure is next to nothing: the error is of second order in its way, and none where stones rest.
// Source: docs/faces.md.
#pragma once

#include <span>
#include <vector>

#include "libdda/contact/contact_polygon.h"

namespace voussoir::contact
{

/// Adds the points inside a face, or inside both parts of one whose gap changes its sign, and gives all of them
/// their areas. The corners stay first, in their order.
/// @param normal unit, of the reference face
/// @param gaps [m] of the corners, as the springs feel them
/// @param points the corners of a convex polygon in their order, or the ends of a segment
template <int D>
void add_points_of_parts(const VectorIn<D>& normal, std::span<const double> gaps,
                         std::vector<PolygonPointIn<D>>& points);

}  // namespace voussoir::contact
