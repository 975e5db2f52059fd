// The register of all forces that are no contacts. A new one is a group with a header of its own, with seven verbs
// as overloads, and one member here: step, relaxation, modes and energies then know it.
//
// - begin_forces sets up a step; the blocks are prepared. What stays the same in a step may go to the `base` of a
//   block.
// - add_pairs names the rows that it couples, the larger one first.
// - note_tied marks the rows that it acts on: their stones are not relaxed one by one.
// - add_forces adds its forces at the iterate d, and their size [N] for each row.
// - add_stiffness adds the symmetric tangent at the last iterate.
// - book_forces adds the terms of an accepted step to the energies: the work on the way that blocks went, and what
//   that way differs by from the one of the momentum balance. The blocks of `state` are where the step left them.
// - update_forces brings what it remembers to the end of the step.
//
// Two places still ask by name: the whole tangent for what a free field adds to one side alone
// (iterate/directions.cpp), and the modes for the blocks that bars touch (analysis/vibration.cpp).
#pragma once

#include "libdda/forces/applied_forces.h"
#include "libdda/forces/bars.h"

namespace voussoir::step
{

/// The groups, in the order in which they are added up.
template <class K>
struct OtherForces {
    AppliedForces<K> applied;  // viscous boundaries, tied sides, damping that grows with mass
    Bars<K> bars;              // tie rods, cramps, dowels

    /// Calls visit(group) for each.
    template <class Visit>
    void each(const Visit& visit)
    {
        visit(applied);
        visit(bars);
    }
    template <class Visit>
    void each(const Visit& visit) const
    {
        visit(applied);
        visit(bars);
    }
};

/// Instantiates the verbs of a group for kinematics K.
#define VOUSSOIR_INSTANTIATE_FORCES(Group, K)                                                                  \
    template void begin_forces(const Model&, const Stage&, const State&, double, double,                       \
                               std::vector<BlockStep<K>>&, Group<K>&);                                         \
    template void add_pairs(const std::vector<BlockStep<K>>&, const Group<K>&,                                 \
                            std::vector<std::pair<int, int>>&);                                                \
    template void note_tied(const std::vector<BlockStep<K>>&, const Group<K>&, std::vector<char>&);            \
    template void add_forces(const Eigen::VectorXd&, const std::vector<BlockStep<K>>&, Group<K>&,              \
                             Eigen::VectorXd&, std::vector<double>&);                                          \
    template void add_stiffness(const std::vector<BlockStep<K>>&, const Group<K>&, solve::BlockMatrix&);       \
    template void book_forces(const State&, const std::vector<BlockStep<K>>&, const Eigen::VectorXd&, double,  \
                              const Group<K>&, EnergyLedger&);                                                 \
    template void update_forces(const Model&, const Stage&, const std::vector<BlockStep<K>>&, const Group<K>&, \
                                State&)

}  // namespace voussoir::step
