// Sides of a model that are one and the same: springs between two faces that are drawn in different places.
// Source: docs/method.md, Boundaries.
#pragma once

#include <vector>

#include "libdda/forces/applied_forces.h"

namespace voussoir::step
{

/// Adds the forces of all ties of the model in a step, two for each.
template <class K>
void add_side_ties(const Model& model, const Stage& stage, const std::vector<BlockStep<K>>& blocks,
                   AppliedForces<K>& forces);

/// What their springs store in a state [J].
double side_tie_energy(const Model& model, const State& state);

/// Books what the springs store and what the integrator took of it in an accepted step; the blocks of `state` are
/// where the step left them.
template <class K>
void book_side_ties(const State& state, const std::vector<BlockStep<K>>& blocks, const AppliedForces<K>& forces,
                    EnergyLedger& energy);

}  // namespace voussoir::step
