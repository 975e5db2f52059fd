// A rigid block that rocks on springs under its two lower corners.
#pragma once

#include <vector>

#include "app/studies/verify/references/rocking.h"

namespace voussoir::app::studies::verify::references
{

/// The springs under each corner, and the mass on them.
struct CornerSprings {
    double mass = 0;      // kg
    double normal = 0;    // N/m, of each corner; it pushes and does not pull
    double shear = 0;     // N/m, of each corner
    double friction = 0;  // coefficient: the shear force of a corner is at most friction x its normal force
};

/// Angle of the block at the given times [rad], positive towards +x; in rest on its springs at time 0. The corner
/// that is going to lift sticks or slips and then opens for good, each at a located moment; the other sticks. Up
/// to the first impact and not beyond the pulse of the ground. @param times ascending, >= 0 [s]
std::vector<double> rocking_angles_on_springs(const RockingBlock& block, const CornerSprings& springs,
                                              const std::vector<double>& times);

}  // namespace voussoir::app::studies::verify::references
