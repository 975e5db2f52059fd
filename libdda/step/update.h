// The state at the end of an accepted step.
#pragma once

#include "libdda/contact/find_contacts.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/step/step_system.h"

namespace voussoir::step
{

/// The velocity that complete kinetic damping would leave: that of the ground [m/s]; where supports move
/// differently, the mean of their motions, rest among them. @param time since the stage's start [s]
Eigen::Vector3d ground_velocity(const Model& model, const Stage& stage, double time);

/// Moves all blocks to the end of the step.
template <class K>
void update_blocks(const StepSystem<K>& system, State& state);

/// Stores the contacts with the forces, gaps and slips of the end of the step. Slips turn with the reference body.
template <class K>
void update_contacts(const Model& model, const Stage& stage, const StepSystem<K>& system,
                     const ContactSetIn<K::dimension>& contacts, State& state, StepReport& report);

/// Velocities after the step: zero in a static stage, else damped relative to the ground. What that takes is
/// booked.
template <class K>
void damp_velocities(const Model& model, const Stage& stage, const StepSystem<K>& system, State& state,
                     EnergyLedger& energy);

}  // namespace voussoir::step
