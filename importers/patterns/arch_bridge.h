// A segmental stone arch between two abutment blocks.
#pragma once

#include <vector>

#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::patterns
{

/// Mosca's bridge over the Doria Riparia, Turin, 1827, is the default: span, voussoirs and thicknesses as printed
/// in [Ma1996]; the paper is two-dimensional, and 12 m of width is of the order of the real roadway.
struct ArchBridge {
    double span = 45;                // m, between the intrados springings
    double rise = 5.5;               // m, of the intrados circle at the crown above the springings
    int voussoirs = 93;              // number
    double springing_thickness = 2;  // m, along the end joints
    double crown_thickness = 1.5;    // m, at the crown
    double width = 12;               // m, of arch and abutments
    double abutment_length = 6;      // m, of each abutment block along the span, at the intrados springing
    double abutment_depth = 6;       // m, of each abutment block below the springing
};

/// The stones from left to right: abutment_left, voussoir_01 ..., abutment_right; x along the span, y across,
/// z up, the springings at z = 0, symmetric about x = 0 and y = 0 to the last bit.
///
/// The intrados follows the circle through the springings and the crown. Joints are radial to it and cut it into
/// equal angles. The thickness along a joint at the angle phi from the crown is
/// crown + (springing - crown) (phi / phi_springing)^2, level at the crown. The left half is computed, rounded to
/// the nanometre so that the mesh is the same on every machine, and mirrored; neighbours share the corners of
/// their joint bit for bit. Each abutment is a pentagonal prism: its skewback is the end joint of the arch, its
/// front and back are vertical, its top is level with the upper edge of the skewback.
/// @throws InputError with every parameter that makes no bridge
std::vector<mesh::PolygonSurface> arch_bridge(const ArchBridge& bridge);

}  // namespace voussoir::importers::patterns
