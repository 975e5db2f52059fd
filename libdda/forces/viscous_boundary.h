// Viscous boundaries in a step: dashpots on faces, waves that come in through them, and what carries the faces at
// rest. Source: [LysmerKuhlemeyer1969]; docs/method.md, Boundaries.
#pragma once

#include <vector>

#include "libdda/forces/applied_forces.h"

namespace voussoir::step
{

/// Whether the faces of boundaries are carried by springs and not by dashpots: at rest they are.
bool boundaries_carry(const Stage& stage);

/// Integral of T^T C T over a face, C the impedance of its block along its normal and across it: what takes the
/// velocity of the block to the force of the dashpots [Ns/m and so on]. @param map of the block, which must be
/// deformable; levers are taken with it
template <class K>
typename K::Square dashpots_of(const Model& model, const BlockFace& face, const typename K::Matrix& map);

/// Adds the forces of all boundaries of the model in a step.
template <class K>
void add_boundary_forces(const Model& model, const Stage& stage, const State& state, double h, double end_time,
                         const std::vector<BlockStep<K>>& blocks, AppliedForces<K>& forces);

/// Brings the reactions of faces that are carried to the end of an accepted step: to State::boundary_reactions.
template <class K>
void update_reactions(const Model& model, const Stage& stage, const std::vector<BlockStep<K>>& blocks,
                      State& state);

}  // namespace voussoir::step
