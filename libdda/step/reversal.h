// Where a sliding joint comes to rest or turns round inside a step.
//
// Between reversals friction is constant and the Newmark step exact; a reversal inside a step keeps the friction
// of one direction for all of it and costs up to mu g h of velocity, whatever the integrator. Ending a step there
// makes the whole second order. Source: docs/numerics.md 5.
#pragma once

#include <optional>

#include "libdda/step/step_system.h"

namespace voussoir::step
{

/// The search for one reversal; lives for one step.
struct ReversalSearch {
    int patch = -1;                       // whose reversal is sought
    double before = 0, speed_before = 0;  // s, m/s: a step length that ends while the joint still slides on
    double after = 0, speed_after = 0;    // s, m/s <= 0: one that ends after it has turned
    int passes = 0;
};

/// Judges a converged step: did a joint that slid at its start turn round in it? Regula falsi on the sliding speed
/// at the end of the step, at most four passes.
/// @returns the step length to redo it with, or nothing when it ends well
template <class K>
std::optional<double> step_to_reversal(const ContactSetIn<K::dimension>& contacts, const StepSystem<K>& system,
                                       ReversalSearch& search);

}  // namespace voussoir::step
