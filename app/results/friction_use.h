// How much of its friction a joint uses.
#pragma once

#include <optional>

#include "libdda/analysis/joints_now.h"

namespace voussoir::app::results
{

/// What a joint can carry along itself.
struct JointBound {
    double friction = 0;  // -, coefficient of the joint at rest
    double cohesion = 0;  // Pa, while it is bonded
};

/// T / (mu N + c A): the shear of a joint over what friction, and cohesion while a bond holds, can take; both are
/// resultants over the joint, A its area in use. At most 1: Coulomb's law holds at each of its points. Nothing
/// where the joint has nothing to slide on: it is open, or without friction.
std::optional<double> friction_use(const JointBound& bound, bool bonded, const JointNow& now);

}  // namespace voussoir::app::results
