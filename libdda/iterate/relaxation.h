// Blocks brought into equilibrium one after the other, each with the others where they are.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/iterate/iteration_rules.h"
#include "libdda/problem/step_problem.h"
#include "libdda/solve/incomplete_factor.h"

namespace voussoir::step
{

/// Nonlinear block Gauss-Seidel sweeps. Most changes of state of an iteration are a matter of one stone and its
/// neighbours, and a direction for all stones at once goes no farther than to the first of them. A sweep settles
/// them stone by stone, each along its own tangent; what is left for the direction is smooth. Source:
/// docs/numerics.md 3; [GraserKornhuber2009]. Large scenes are swept domain by domain: the pattern of the matrix
/// alone decides, not the number of threads.
template <class K>
class Relaxation
{
 public:
    /// To be called when the contacts of a step are known.
    void begin() { is_ready_ = false; }
    /// Sweeps, there and back, over the blocks that are out of balance by more than the tolerance and by not much
    /// less than the worst: two over all, and more over few. Contacts and residual are known at problem.d, and are
    /// so afterwards.
    /// @param tolerance share of a block's load; @param worst residual / tolerance of the worst block
    void sweep(double tolerance, double worst, const IterationRules& rules, StepProblem<K>& problem);

 private:
    using Unknowns = typename K::Unknowns;
    /// What is due, and what was moved, inside a domain or at its border.
    struct Moves {
        std::vector<int> due;      // rows to be looked at, ascending
        std::vector<int> patches;  // that were moved
    };

    /// Finds the rows that something beside contacts ties to others or to the ground, and the domains.
    void gather(const IterationRules& rules, StepProblem<K>& problem);
    /// Finds the domains, the rows at their borders and in which turns these may be relaxed.
    void divide(const IterationRules& rules, const solve::BlockMatrix& pattern);
    /// Puts each row that is due to those inside its domain, or to those at its border.
    void share_out();
    /// Calls work(moves) for all that is inside domains and then, turn by turn, for what is at borders; or
    /// the other way round.
    template <class Work>
    void everywhere(bool back, int threads, const Work& work);
    void relax_all(bool back, double unbalanced, const IterationRules& rules, Moves& moves,
                   StepProblem<K>& problem);
    void relax(int row, double unbalanced, const IterationRules& rules, Moves& moves, StepProblem<K>& problem);
    /// Where stones were moved, those of them and of their neighbours are due that are out of balance.
    void find_due(double unbalanced, const StepProblem<K>& problem);
    void note_neighbours(Moves& moves, const StepProblem<K>& problem);
    typename K::Square tangent_of(int row, const StepProblem<K>& problem) const;
    /// Moves a block to `to`, and contacts and residual with it.
    void move(int row, const Unknowns& to, Moves& moves, StepProblem<K>& problem);

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
