// Points at which a face rests besides the corners of its contact.
//
// Springs at the corners alone, each with its share of the area, have the right area and turn over about the right
// edge; against bending they are three times too stiff (b^4/4 of a square for b^4/12), against turning on the face
// 1.85 times too strong (their mean distance from the centroid is 0.707 a for 0.383 a). Here a third of the area
// is at the rim, a ninth at the corners and two ninths at the middles of the sides, and as many points as corners
// lie inside. An affine map of these about the centroid makes first and second moments those of the polygon,
// exactly; with this rim the mean distance is right as well. All that a face does which presses and sticks all
// over is then exact, the edge that it turns over about is its own, and on that edge it resists turning as an
// evenly pressed line does.
//
// A segment has the points of a rectangle as they are seen from its side.
// Source: docs/faces.md, "Which points, and why".
#pragma once

#include <vector>

#include "libdda/contact/contact_polygon.h"
#include "libdda/model/state.h"

namespace voussoir::contact
{

/// In the feature of the ends of a line where a face is cut (cut_face.h). They are no corners and bear nothing.
constexpr std::uint32_t on_cut_line = inner_feature | 0x20000000;

/// Adds the inner points behind the corners, and gives all of them their areas. A needle, narrower than a
/// thousandth of its length, stays as it is.
/// @param normal unit, of the reference face
/// @param points the corners of a convex polygon in their order, or the ends of a segment: their positions lie in
/// one plane, their gaps are linear over it, their areas tributary
void add_inner_points(const Eigen::Vector3d& normal, std::vector<PolygonPointIn<3>>& points);
void add_inner_points(const Eigen::Vector2d& normal, std::vector<PolygonPointIn<2>>& points);

}  // namespace voussoir::contact
