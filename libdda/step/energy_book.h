// The energy audit of a step.
#pragma once

#include "libdda/contact/find_contacts.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"
#include "libdda/problem/step_problem.h"

namespace voussoir::step
{

/// Adds work and losses of an accepted step, each from its own forces and displacements: see EnergyLedger. The
/// blocks of `state` are already where the step left them, its velocities not yet damped.
template <class K>
void book_step(const State& state, const StepProblem<K>& problem, const ContactSetIn<K::dimension>& contacts,
               EnergyLedger& energy);

}  // namespace voussoir::step
