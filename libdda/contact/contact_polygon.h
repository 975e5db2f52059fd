// What the narrow phase finds: a polygon between two parts, a segment between two outlines, or the point where two
// edges cross.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "libdda/geometry/plane.h"

namespace voussoir::contact
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

}  // namespace voussoir::contact
