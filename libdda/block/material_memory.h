// A block's memory of its strain within one step: branches of springs and dashpots beside its elasticity.
// Source: docs/method.md, Damping of blocks.
#pragma once

#include <vector>

#include "libdda/model/elasticity.h"
#include "libdda/model/state.h"

namespace voussoir::step
{

/// A branch in a step. Its strain e = E - q is taken in the middle of it, where that of its dashpot q grows at
/// e / time; its own energy, share x that of e, is then exact.
template <class Matrix>
struct BranchStep {
    double share = 0;                // -, of the elasticity
    double half_step = 0;            // step / (2 time); 0: at rest, the branch carries nothing
    Matrix strain = Matrix::Zero();  // e at the start
};

/// All of a block.
template <class Matrix>
struct MemoryStep {
    std::vector<BranchStep<Matrix>> branches;  // none: the material has none
    double blend = 0;                // what they add to the share of the strain of the end: sum share / (1 + a)
    Matrix steady = Matrix::Zero();  // and beside it: sum share / (1 + a) x strain at the start
    bool relaxes = false;            // at rest: the dashpots come to the strain of the end
};

/// Prepares it for a step of length h. @param dynamic whether motion in time is sought, and not rest
template <class Matrix>
void begin_memory(const Model& model, const State& state, int block, bool dynamic, double h,
                  const Matrix& start_strain, MemoryStep<Matrix>& memory);

/// What the branches do in a step in which the strain changes.
struct MemoryWork {
    double stored = 0;  // J, change of what their springs store
    double lost = 0;    // J, taken by their dashpots, >= 0
};

template <class Matrix>
MemoryWork memory_work(const MemoryStep<Matrix>& memory, const Elasticity& elasticity, const Matrix& change);

/// What the springs of its branches store [J]. @param branches with a `share` each @param strain of the block
template <class Branches, class Matrix>
double stored_in(const Branches& branches, const State& state, int block, const Elasticity& elasticity,
                 const Matrix& strain)
{
    double energy = 0;
    int number = 0;
    for (const auto& branch : branches) {
        const Matrix dashpot = branch_strain_in<Matrix::RowsAtCompileTime>(state, block, number++);
        energy += branch.share * elasticity.energy(Matrix(strain - dashpot));
    }
    return energy;
}

/// Brings the strains of the dashpots in the state to the end of an accepted step.
template <class Matrix>
void update_memory(const MemoryStep<Matrix>& memory, const Matrix& start_strain, const Matrix& end_strain,
                   int block, State& state);

}  // namespace voussoir::step
