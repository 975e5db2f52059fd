// Obelisks and pinnacles: stones one on another that grow thinner to a point.
#pragma once

#include <string>

#include "importers/patterns/pattern.h"

namespace voussoir::importers::patterns
{

/// A square shaft on a pedestal. Lengths in m.
struct Obelisk {
    double height = 8;           // of the shaft, from its foot to that of the pyramidion
    double width = 1;            // of the shaft at its foot
    double top_width = 0.7;      // of the shaft at its top
    double pyramidion = 0.8;     // height of the point above the shaft
    int stones = 1;              // of the shaft, of equal height; the last one carries the pyramidion
    double pedestal_height = 0;  // 0: none
    double pedestal_width = 1.5;
};

/// A shaft that weighs down a buttress, with a spire on it. Lengths in m.
struct Pinnacle {
    double width = 0.6;    // of the square shaft; the spire is an octagon within it
    double height = 1;     // of the shaft
    int courses = 2;       // of the shaft, one stone each
    double spire = 1.8;    // height of the spire
    int spire_stones = 3;  // of equal height; the last one ends in the point
};

/// "slab" (group foundation), "pedestal" (pedestal), "shaft_1" ... (shaft). z is up, the axis is x = y = 0, the
/// foot of the lowest stone on the slab z = 0. @param name before all names @throws InputError with what makes
/// none
Pattern obelisk(const Obelisk& obelisk, const std::string& name);

/// "slab" (foundation), "shaft_1" ... (shaft), "spire_1" ... (spire). Axes as of an obelisk.
/// @param name before all names @throws InputError with what makes none
Pattern pinnacle(const Pinnacle& pinnacle, const std::string& name);

}  // namespace voussoir::importers::patterns
