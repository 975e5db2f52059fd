// The intrados of an arch and its joints, in the elevation.
#pragma once

#include <vector>

#include "importers/patterns/pattern.h"
#include "libdda/errors.h"

namespace voussoir::importers::patterns
{

/// The line of an intrados.
enum class ArchShape {
    circular,     // one arc; segmental when the rise is less than half the span
    pointed,      // two arcs about centres on the springing line, rise more than half the span
    elliptic,     // half an ellipse
    polycentric,  // three arcs, each tangent to the next: a basket handle
};

/// What an arch is in its elevation. Both springings of the intrados lie at z = 0, its middle at x = 0.
struct ArchCurve {
    ArchShape shape = ArchShape::circular;
    double span = 6, rise = 3;          // m, of the intrados
    double side_arc = 1.0471975511966;  // rad, angle of each side arc of a polycentric arch: 60 degrees
    double thickness = 0.5;             // m, along the joint at the crown
    double springing_thickness = 0;     // m, along the end joints; 0: that of the crown
    int voussoirs = 15;                 // number
};

/// A joint from the intrados to the extrados.
struct ArchJoint {
    Point intrados, extrados;
};

/// Adds what makes no arch, by the names of the case file.
void check_curve(const ArchCurve& curve, std::vector<Fault>& faults);

/// All joints from left to right, symmetric to the last bit, rounded to the nanometre.
///
/// Joints are normal to the intrados and cut it into equal lengths (a circle: into equal angles). The thickness
/// along the joint at the share s of the length from crown to springing is crown + (springing - crown) s^2. The
/// joint at the crown, which even numbers of voussoirs have, is vertical.
/// @pre check_curve found nothing
std::vector<ArchJoint> joints_of(const ArchCurve& curve);

/// The corner in the crown of a pointed arch: intrados and extrados at x = 0.
ArchJoint apex_of(const ArchCurve& curve);

}  // namespace voussoir::importers::patterns
