// Contact of two convex parts: a clipped face polygon, or the crossing point of two edges; planar, a clipped
// segment.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "libdda/contact/placed_part.h"

namespace voussoir
{

/// A corner of a contact polygon, or an end of a contact segment.
template <int D>
struct PolygonPointIn {
    VectorIn<D> position;       // m, on the incident body
    double gap = 0;             // m, over the reference plane
    double area = 0;            // m2, tributary; of a segment its length, m
    std::uint32_t feature = 0;  // labels of the polygon edges that arrive and leave: survives sliding
};

/// What touches what. The reference body owns the normal; the incident body carries the points.
template <int D>
struct ContactPolygonIn {
    bool second_is_reference = false;  // else the first part is
    bool edge_edge = false;
    std::uint32_t reference_feature = 0, incident_feature = 0;
    VectorIn<D> normal = VectorIn<D>::Zero();  // unit, from the reference body to the incident one
    std::vector<PolygonPointIn<D>> points;
};

using PolygonPoint = PolygonPointIn<3>;
using ContactPolygon = ContactPolygonIn<3>;
using ContactSegment = ContactPolygonIn<2>;

/// What touched in the step before, for hysteresis.
struct LastContact {
    bool second_is_reference = false;
    bool edge_edge = false;
    std::uint32_t reference_feature = 0, incident_feature = 0;
};

/// Separating-axis test on faces and edge pairs; the axis of largest signed separation wins, with hysteresis for
/// last step's face and a preference of faces over edge pairs. A face axis clips the incident face against the
/// side planes of the reference face; the tributary area of a corner is half the area of its two triangles with
/// the polygon's area centroid, so that areas and first moments of areas are exact. Polygons below 1e-7 L^2 are
/// skipped (ghost contacts of diagonal neighbours). Source: numerics note 2.5 (clipping: Sutherland and Hodgman
/// 1974).
/// @param margin [m] parts further apart than this do not touch
std::optional<ContactPolygon> contact_polygon(const PlacedPart& first, const PlacedPart& second, double margin,
                                              const std::optional<LastContact>& last);

/// The same for two outlines: the incident edge clipped by the ends of the reference edge, half its length to each
/// end. Segments shorter than 1e-7 L are skipped.
std::optional<ContactSegment> contact_polygon(const PlacedOutline& first, const PlacedOutline& second,
                                              double margin, const std::optional<LastContact>& last);

/// Gives every point of a planar polygon its tributary area. Exposed for its test.
void assign_tributary_areas(std::vector<PolygonPoint>& points, const Eigen::Vector3d& normal);

}  // namespace voussoir
