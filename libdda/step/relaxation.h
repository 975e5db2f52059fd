// Blocks brought into equilibrium one after the other, each with the others where they are.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/step/contact_step.h"

namespace voussoir::step
{

template <class K>
struct StepSystem;

/// Nonlinear block Gauss-Seidel sweeps. Most changes of state of an iteration are a matter of one stone and its
/// neighbours, and a direction for all stones at once goes no farther than to the first of them. A sweep settles
/// them stone by stone, going down the same potential; what is left for the direction is smooth. Source:
/// docs/numerics.md 3; [GraserKornhuber2009].
template <class K>
class Relaxation
{
 public:
    /// To be called when the contacts of a step are known.
    void begin() { is_ready_ = false; }
    /// Sweeps, there and back, over the blocks that are out of balance by more than the tolerance and by not much
    /// less than the worst: two over all, and more over few. The friction bound is frozen within a sweep and
    /// follows after it. Contacts and residual are known at system.d, with the exact bound, and are so afterwards.
    /// @param tolerance share of a block's load; @param worst residual / tolerance of the worst block
    void sweep(double tolerance, double worst, StepSystem<K>& system);

 private:
    using Unknowns = typename K::Unknowns;
    /// Finds the patches of each row, and the rows that something beside contacts ties to others or to the ground.
    void gather(const StepSystem<K>& system);
    bool is_balanced(int row, double unbalanced, const StepSystem<K>& system) const;
    void relax(int row, double unbalanced, StepSystem<K>& system);
    /// Where stones were moved the friction bound follows, and their rows and those of their neighbours are due.
    void follow_moves(double unbalanced, StepSystem<K>& system);
    typename K::Square tangent_of(int row, const StepSystem<K>& system) const;
    /// Moves a block to `to`, and contacts and residual with it.
    void move(int row, const Unknowns& to, StepSystem<K>& system);
    void add_forces(const PatchStep<K>& patch, double sign, StepSystem<K>& system) const;

    std::vector<int> start_, patches_;  // of rows, in compressed form
    std::vector<bool> tied_;            // rows that are left out
    std::vector<int> moved_;            // patches that a sweep has moved
    std::vector<bool> has_moved_;       // (patches)
    std::vector<int> due_;              // rows for the next sweep, ascending
    bool is_ready_ = false;
};

}  // namespace voussoir::step
