// Newton's iteration for the few stones that are out of balance, with all others where they are.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "libdda/solve/gmres.h"
#include "libdda/solve/linear_solver.h"
#include "libdda/step/contact_step.h"
#include "libdda/step/friction_tangent.h"

namespace voussoir::step
{

template <class K>
struct StepSystem;

/// In a large scene most stones have found their balance long before the last few, and a direction for all of
/// them is dear. Here only the stones that are out of balance are moved, and those around them, in whole steps
/// along the whole tangent: a nonlinear solve in part of the unknowns before the next of all. Stones that
/// something beside contacts acts on, or that are held, stay. Source: docs/numerics.md 3; [CaiKeyes2002].
template <class K>
class LocalNewton
{
 public:
    /// To be called when the contacts of a step are known.
    void begin() { is_ready_ = false; }
    /// Takes a few steps, each only if it leaves less out of balance; none in a scene that is not large. Contacts
    /// and residual are known at system.d, with the exact bound, and are so afterwards.
    /// @param tolerance share of a block's load
    /// @returns whether it took any
    bool improve(double tolerance, StepSystem<K>& system);

 private:
    /// Finds the rows to be moved, and the patches that they move.
    /// @returns false where none is out of balance, or too many are
    bool gather(double tolerance, StepSystem<K>& system);
    /// Adds the rows next to those found so far.
    void add_ring(const StepSystem<K>& system);
    void find_patches(const StepSystem<K>& system);
    /// The matrix of the rows, others fixed, and what it leaves out.
    void assemble(StepSystem<K>& system);
    /// (K + C) direction = -residual. @returns false if there is no solution
    bool solve_direction(const StepSystem<K>& system);
    /// Moves the rows, and contacts and residual with them. @param to (rows to be moved x unknowns)
    /// @returns false if a block inverts
    bool move(const Eigen::VectorXd& to, StepSystem<K>& system);
    /// Sum of the squares of residual / tolerance over all rows whose residual may change.
    double unbalanced(double tolerance, const StepSystem<K>& system) const;

    bool is_ready_ = false;
    std::vector<char> stays_;                 // (rows)
    std::vector<int> place_;                  // (rows) among those to be moved; -1: not one of them
    std::vector<int> rows_;                   // to be moved, ascending
    std::vector<int> around_;                 // rows that feel it
    std::vector<int> patches_;                // between any of them
    std::vector<char> is_marked_;             // scratch
    std::vector<std::pair<int, int>> pairs_;  // scratch
    solve::BlockMatrix matrix_;
    std::vector<FrictionTangent<K>> left_out_;  // rows by their places
    Eigen::VectorXd from_, residual_, direction_;
    std::unique_ptr<solve::LinearSolver> solver_;
    solve::Gmres gmres_;
};

}  // namespace voussoir::step
