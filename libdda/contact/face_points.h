// Points at which a face rests besides the corners of its contact.
//
// Springs at the corners alone, each with its share of the area, have the right area and turn over about the right
// edge; against bending they are three times too stiff (b^4/4 of a square for b^4/12), against turning on the face
// 1.85 times too strong (their mean distance from the centroid is 0.707 a for 0.383 a). Here the corners keep a
// share of the area, and twice as many points inside carry the rest: one towards each corner, one towards the
// middle of each side. An affine map of these about the centroid makes first and second moments those of the
// polygon, exactly; with the share of the corners the mean distance is right as well. All that a face does which
// presses and sticks all over is then exact, and the edge that it turns over about is its own.
//
// A segment has the points of a rectangle as they are seen from its side.
// Source: docs/method.md, "Faces".
#pragma once

#include <vector>

#include "libdda/contact/contact_polygon.h"

namespace voussoir::contact
{

/// Adds the inner points behind the corners, and gives all of them their areas. A needle, narrower than a
/// thousandth of its length, stays as it is.
/// @param normal unit, of the reference face
/// @param points the corners of a convex polygon in their order, or the ends of a segment: their positions lie in
/// one plane, their gaps are linear over it, their areas tributary
void add_inner_points(const Eigen::Vector3d& normal, std::vector<PolygonPointIn<3>>& points);
void add_inner_points(const Eigen::Vector2d& normal, std::vector<PolygonPointIn<2>>& points);

}  // namespace voussoir::contact
