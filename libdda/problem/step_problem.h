// The equations of one step: what is to be solved, by whatever iteration.
//
// The unknowns D of all blocks that have any are what forces change in the free flight of the step. Sought is
//
//   R(D) = 2 M / h^2 D + internal(D) - steady - contacts(D) - others(D) = 0,
//
// M the mass, `steady` the weight, the contacts with friction at its bound mu N of the same D. Were the bound
// held, R would be the gradient of a convex function and K = dR/dD symmetric and positive definite: this is the
// matrix here. What the bound adds to it as it follows the normal force is in forces/friction_tangent.h. Source:
// docs/numerics.md 2 and 3.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "libdda/block/block_step.h"
#include "libdda/contact/find_contacts.h"
#include "libdda/forces/contact_step.h"
#include "libdda/forces/other_forces.h"
#include "libdda/model/parallel.h"
#include "libdda/problem/patches_of_rows.h"
#include "libdda/solve/block_matrix.h"

namespace voussoir::step
{

/// Knows no solver. Memory is reused from step to step.
template <class K>
struct StepProblem {
    double h = 0;                      // s
    int threads = 1;                   // of loops over rows, which many rows alone are worth
    int patch_threads = 1;             // of loops over contacts
    std::vector<BlockStep<K>> blocks;  // of the scene
    std::vector<int> block_of_row;     // blocks that have unknowns
    ContactStep<K> contacts;
    PatchesOfRows patches_of_rows;
    OtherForces<K> others;                   // that are no contacts
    bool stays = false;                      // nothing moves, and what is unbalanced is rounding
    double fracture = 0;                     // J, tension energy lost by joints that broke in this step
    Eigen::VectorXd d;                       // unknowns, the accepted ones after the iteration
    Eigen::VectorXd residual;                // inertia + internal - external
    Eigen::VectorXd contact_force;           // generalised forces of contacts and applied ones
    std::vector<InternalForce<K>> internal;  // per row
    std::vector<double> load;                // N per row: weight plus contact forces, the scale of its residual
    solve::BlockMatrix matrix;               // K at the last evaluation, the bound held
    std::vector<std::pair<int, int>> pairs;  // scratch of the pattern
    std::vector<std::pair<int, int>> known_pairs;  // those of the step before: they make the pattern that is there
};

/// Sets up blocks, contacts and pattern for a step of length h. @param jumps of blocks that land in it, ascending
template <class K>
void assemble_blocks(const Model& model, const Stage& stage, const State& state,
                     const ContactSetIn<K::dimension>& contacts, double h, const std::vector<Jump<K>>& jumps,
                     StepProblem<K>& problem);

/// The stiffness at the last evaluation, with the bound held: problem.matrix.
template <class K>
void assemble_matrix(bool published, StepProblem<K>& problem);

/// Residual and loads at the iterate `d` from the contact forces last evaluated. @returns false if a block inverts
template <class K>
bool evaluate_residual(const Eigen::VectorXd& d, StepProblem<K>& problem);

}  // namespace voussoir::step
