// How far the blocks of a step are from equilibrium.
#pragma once

#include "libdda/problem/step_problem.h"

namespace voussoir::step
{

/// The block that is farthest from equilibrium.
struct Unbalance {
    double worst = 0;  // residual / tolerance of that block
    double ratio = 0;  // residual / load of that block
    int block = -1;
};

/// Residual / tolerance of the block of a row, as below.
template <class K>
double unbalance_of(int row, double tolerance, const StepProblem<K>& problem);

/// Largest |R_i| / tol_i over the blocks, moments divided by the block's size, at the residual of the problem. The
/// tolerance of a block is a share of its own load, never less than what rounding leaves of its stiffness.
/// @param tolerance that share
template <class K>
Unbalance unbalance(const StepProblem<K>& problem, double tolerance);

/// Whether every block is within its tolerance, or beyond it by no more than what the rounding of the places of
/// blocks does to the gaps of their contacts, times the stiffness of these.
template <class K>
bool is_balanced_but_for_rounding(const StepProblem<K>& problem, double tolerance);

}  // namespace voussoir::step
