// Coulomb friction between two blocks.
#pragma once

#include "libdda/model/model.h"

namespace voussoir
{

/// The coefficient of friction between two blocks, at rest and at a speed. Whoever needs friction asks here:
/// steps, impacts, strength.
struct FrictionLaw {
    double at_rest = 0;                    // -
    double factor = 1;                     // -, of the two blocks; `at_rest` has it already
    const JointMaterial* joint = nullptr;  // only where friction depends on the speed

    /// @param speed of slip [m/s]
    double at(double speed) const { return joint ? factor * friction_coefficient(*joint, speed) : at_rest; }
    /// Whether the blocks rub on one another at any speed.
    bool rubs() const { return at_rest > 0 || (joint && factor > 0); }
};

/// @param has_speeds whether slip takes time; in a static stage it does not, and friction is that at rest
FrictionLaw friction_between(const Model& model, int block_a, int block_b, bool has_speeds);

}  // namespace voussoir
