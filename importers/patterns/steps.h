// A flight of steps of solid masonry.
#pragma once

#include <string>

#include "importers/patterns/pattern.h"

namespace voussoir::importers::patterns
{

/// All lengths in m.
struct Steps {
    int number = 5;           // of steps
    double rise = 0.18;       // height of each
    double going = 0.32;      // from nosing to nosing
    double width = 3;         // along y
    double landing = 0.64;    // length of the last step, at least going
    double stone_length = 1;  // along y
    double depth = 0;         // of a stone along x; 0: one and a half goings
};

/// Step by step from below, "step_1_b01" ... (group steps) on "slab" (foundation). Each step is a course that
/// reaches from its nosing to the back of the flight, in rows of stones in bond: so the stones of a step bear on
/// those of the one below. x runs up the flight, the first nosing is x = 0, the middle y = 0, the foot z = 0.
/// @param name before all names @throws InputError with what makes no flight
Pattern steps(const Steps& steps, const std::string& name);

}  // namespace voussoir::importers::patterns
