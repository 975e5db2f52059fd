// Stones that land: the impulses by which approaching stones meet.
//
// Springs alone answer an impact as the time step, their stiffness and the integrator make them: a stiff contact
// that closes in the middle of a step leaves the stones with a speed between the negative and the positive of what
// they had. Here the landing is found before the step, when and where it happens, and answered by Newton's law:
// the normal speed afterwards is `restitution` times the approach speed. Closed joints pass impulses on; a joint
// that stays closed loses nothing. The springs of the step then see the flight after the impact. Source:
// docs/method.md, "Landing".
#pragma once

#include <optional>
#include <vector>

#include "libdda/step/step_system.h"

namespace voussoir::step
{

/// Finds the stones that land in a step of length h.
/// @param also points (indices into contacts.points, ascending) that are known to close in it, whatever a straight
/// flight says
/// @returns their jumps, in ascending order of the block; none where nothing lands
template <class K>
std::vector<Jump<K>> find_jumps(const Model& model, const Stage& stage, const State& state,
                                const ContactSetIn<K::dimension>& contacts, double h,
                                const std::vector<int>& also);

/// The part of a step that may be done before the first of the jumps, so that what presses until then does so for
/// as long as it does [s]; nothing where they are all at its start, or slower than gravity makes
/// a stone in a step. @param h of the step [s]
template <class K>
std::optional<double> step_to_landing(const Stage& stage, const std::vector<Jump<K>>& jumps, double h);

/// The points that closed in a converged step although a straight flight did not bring their stones together, and
/// that were approaching fast enough for a landing: forces bent their way. In ascending order.
template <class K>
std::vector<int> missed_landings(const Model& model, const Stage& stage, const State& state,
                                 const ContactSetIn<K::dimension>& contacts, const StepSystem<K>& system);

}  // namespace voussoir::step
