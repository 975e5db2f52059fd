// Forces on blocks by themselves that are linear in their unknowns: what viscous boundaries do, and damping that
// grows with mass. A scene without them has none.
#pragma once

#include <vector>

#include "libdda/model/report.h"
#include "libdda/step/block_step.h"

namespace voussoir::step
{

/// constant - resistance D, on one block.
template <class K>
struct AppliedForce {
    /// In which term of the energy it goes.
    enum class Kind { boundary, damping };
    Kind kind = Kind::boundary;                           // its own
    int block = 0;                                        // index into Model::blocks
    typename K::Unknowns constant = K::Unknowns::Zero();  // N, Nm, conjugate to D
    typename K::Square resistance = K::Square::Zero();    // N per unit of D, symmetric, >= 0
    typename K::Vector ground_move = K::Vector::Zero();   // m, of what the force is fixed to; of damping only
    typename K::Unknowns at(const typename K::Unknowns& d) const { return constant - resistance * d; }
};

/// All such forces in a step of length h, and their resistance in the `base` of their blocks, which are prepared.
/// @param end_time stage time at its end [s]
template <class K>
void find_applied_forces(const Model& model, const Stage& stage, const State& state, double h, double end_time,
                         std::vector<BlockStep<K>>& blocks, std::vector<AppliedForce<K>>& forces);

/// Adds their work in an accepted step: on the way that blocks went, and what that way differs by from the one
/// that the momentum balance knows, to the terms of EnergyLedger. The blocks of `state` are where the step left
/// them. @param d all unknowns of the step
template <class K>
void book_applied_forces(const State& state, const std::vector<BlockStep<K>>& blocks, const Eigen::VectorXd& d,
                         double h, const std::vector<AppliedForce<K>>& forces, EnergyLedger& energy);

}  // namespace voussoir::step
