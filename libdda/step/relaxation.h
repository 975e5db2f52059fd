// Blocks brought into equilibrium one after the other, each with the others where they are.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/solve/incomplete_factor.h"
#include "libdda/step/contact_step.h"

namespace voussoir::step
{

template <class K>
struct StepSystem;

/// Nonlinear block Gauss-Seidel sweeps. Most changes of state of an iteration are a matter of one stone and its
/// neighbours, and a direction for all stones at once goes no farther than to the first of them. A sweep settles
/// them stone by stone, going down the same potential; what is left for the direction is smooth. Source:
/// docs/numerics.md 3; [GraserKornhuber2009]. Large scenes are swept domain by domain: the pattern of the matrix
/// alone decides, not the number of threads.
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
    /// What is due, and what was moved, inside a domain or at its border.
    struct Moves {
        std::vector<int> due;      // rows to be looked at, ascending
        std::vector<int> patches;  // that were moved
    };

    /// Finds the rows that something beside contacts ties to others or to the ground, and the domains.
    void gather(StepSystem<K>& system);
    /// Finds the domains, the rows at their borders and in which turns these may be relaxed.
    void divide(const solve::BlockMatrix& pattern);
    /// Puts each row that is due to those inside its domain, or to those at its border.
    void share_out();
    /// Calls work(moves) for all that is inside domains and then, turn by turn, for what is at borders; or
    /// the other way round.
    template <class Work>
    void everywhere(bool back, int threads, const Work& work);
    void relax_all(bool back, double unbalanced, Moves& moves, StepSystem<K>& system);
    bool is_balanced(int row, double unbalanced, const StepSystem<K>& system) const;
    void relax(int row, double unbalanced, Moves& moves, StepSystem<K>& system);
    /// Where stones were moved the friction bound follows, and their rows and those of their neighbours are due.
    void follow_moves(double unbalanced, StepSystem<K>& system);
    void follow(Moves& moves, StepSystem<K>& system);
    typename K::Square tangent_of(int row, const StepSystem<K>& system) const;
    /// Moves a block to `to`, and contacts and residual with it.
    void move(int row, const Unknowns& to, Moves& moves, StepSystem<K>& system);

    std::vector<char> tied_;       // rows that are left out
    std::vector<char> has_moved_;  // (patches)
    std::vector<int> due_;         // rows for the next sweep, ascending
    std::vector<char> is_due_;     // scratch
    // Rows without neighbours in other domains are relaxed domain by domain, side by side; then the others, those
    // of domains side by side that do not touch the same rows.
    solve::Domains domains_;
    std::vector<int> columns_, row_start_;  // of the pattern that was divided
    std::vector<char> is_at_border_;        // (rows) whether a row has neighbours in other domains
    std::vector<std::vector<int>> turns_;   // domains whose borders are relaxed side by side
    std::vector<Moves> inside_, border_;    // by domain
    std::vector<Moves*> busy_;              // scratch
    bool is_ready_ = false;
};

}  // namespace voussoir::step
