// The state at the end of an accepted step.
#pragma once

#include "libdda/contact/find_contacts.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/problem/step_problem.h"

namespace voussoir::step
{

/// Moves all blocks to the end of the step.
template <class K>
void update_blocks(const StepProblem<K>& problem, State& state);

/// Stores the contacts with the forces, gaps and slips of the end of the step. Slips turn with the reference body.
template <class K>
void update_contacts(const Model& model, const Stage& stage, const StepProblem<K>& problem,
                     const ContactSetIn<K::dimension>& contacts, State& state, StepReport& report);

/// Velocities after the step: zero in a static stage, else damped relative to the ground. What that takes is
/// booked.
template <class K>
void damp_velocities(const Model& model, const Stage& stage, const StepProblem<K>& problem, State& state,
                     EnergyLedger& energy);

}  // namespace voussoir::step
