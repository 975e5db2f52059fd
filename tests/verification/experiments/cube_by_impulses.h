// A thrown cube whose corners meet a table by impulses alone: Moreau's time stepping with steps so short that they
// do not matter. It knows nothing of the engine: what it gets wrong, the law of impact and friction gets wrong.
#pragma once

#include "tests/verification/experiments/thrown_cube.h"

namespace voussoir::verification
{

/// What a law of impact may do besides the friction and restitution of the setting, at points that approach faster
/// than `slowest`; slower ones always have the friction of the setting and no restitution of the slip.
struct ImpactLaw {
    enum class Restitution { of_the_point, of_the_impulse };  // Newton's, Poisson's
    Restitution restitution = Restitution::of_the_point;
    std::optional<double> friction;  // -, in impacts; none: that of the setting
    double tangential = 0;           // -, slip afterwards over that before, reversed, within what friction allows
    double half_speed = 0;           // m/s, of approach, at which the restitution has half its value; 0: constant
    double slowest = 0.05;           // m/s
};

/// @param step [s]
TrackedMotion cube_by_impulses(const Toss& toss, const CubeSetting& setting, double step,
                               const ImpactLaw& law = {});

}  // namespace voussoir::verification
