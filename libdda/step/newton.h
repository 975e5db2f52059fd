// The open-close iteration as Newton's method: with the friction bound frozen at mu N of the current iterate the
// step minimises a convex function, and every Newton step goes down it. The bound follows N from one iterate to
// the next; where that overshoots and the iterates would take turns (wedges under high friction), the line search
// follows the exact bound instead, which shortens the step until they meet. Before each direction stones that are
// far out of balance are relaxed one by one (relaxation.h), and where few change their state any more whole steps
// along the tangent with the bound in it take over (bold_steps.h). Source: docs/numerics.md 3.
#pragma once

#include "libdda/step/step_system.h"

namespace voussoir::step
{

/// Newton iteration on the step's potential with a line search on its derivative; joints that exceed their
/// strength break one by one. Fills the report. @returns whether every block is in equilibrium within the
/// tolerance
template <class K>
bool iterate_newton(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                    StepSystem<K>& system, StepReport& report);

}  // namespace voussoir::step
