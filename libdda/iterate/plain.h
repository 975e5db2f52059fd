// The open-close iteration with nothing in it that could be left out: what the fast one is judged against.
#pragma once

#include "libdda/problem/step_problem.h"

namespace voussoir::step
{

/// Newton's iteration on the potential of the step, on one thread, each direction by a Cholesky factor of its own.
/// Fills the report. @returns whether every block is in equilibrium within the tolerance
template <class K>
bool iterate_plain(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                   StepProblem<K>& system, StepReport& report);

}  // namespace voussoir::step
