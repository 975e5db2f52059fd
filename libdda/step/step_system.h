// The equations of one step, shared by both open-close iterations.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "libdda/contact/find_contacts.h"
#include "libdda/model/parallel.h"
#include "libdda/solve/linear_solver.h"
#include "libdda/step/applied_forces.h"
#include "libdda/step/bars.h"
#include "libdda/step/block_step.h"
#include "libdda/step/contact_step.h"
#include "libdda/step/friction_coupling.h"
#include "libdda/step/local_newton.h"
#include "libdda/step/patches_of_rows.h"
#include "libdda/step/relaxation.h"

namespace voussoir::step
{

/// Everything a step works on; memory is reused from step to step.
template <class K>
struct StepSystem {
    double h = 0;                      // s
    int threads = 1;                   // of loops over rows, which many rows alone are worth
    std::vector<BlockStep<K>> blocks;  // of the scene
    std::vector<int> block_of_row;     // blocks that have unknowns
    ContactStep<K> contacts;
    PatchesOfRows patches_of_rows;
    AppliedForces<K> applied;                // of viscous boundaries, tied sides, mass damping; empty without
    std::vector<BarStep<K>> bars;            // of the model
    double end_share = 0;                    // of the forces of bars, taken at the end of the step
    double fracture = 0;                     // J, tension energy lost by joints that broke in this step
    Eigen::VectorXd d;                       // unknowns, the accepted ones after the iteration
    Eigen::VectorXd residual;                // inertia + internal - external
    Eigen::VectorXd contact_force;           // generalised forces of contacts and applied ones
    std::vector<InternalForce<K>> internal;  // per row
    std::vector<double> load;                // N per row: weight plus contact forces, the scale of its residual
    solve::BlockMatrix matrix;
    std::vector<std::pair<int, int>> pairs;        // scratch of the pattern
    std::vector<std::pair<int, int>> known_pairs;  // those of the step before: they make the pattern that is there
    solve::RowPlaces places;                       // of the rows, for the solver
    Eigen::VectorXd direction, trial;              // scratch
    std::vector<ContactStatus> statuses;           // scratch, per contact point
    std::vector<int> states;                       // the same, as the iteration left them
    FrictionCoupling<K> coupling;
    Relaxation<K> relaxation;
    LocalNewton<K> local;
    std::unique_ptr<solve::LinearSolver> solver;
    LinearSolverKind solver_kind = LinearSolverKind::automatic;
};

/// Whether so many blocks move that a direction for all of them is dear beside anything done among a few.
template <class K>
bool is_large(const StepSystem<K>& system)
{
    return system.block_of_row.size() >= static_cast<std::size_t>(blocks_worth_threads);
}

/// Sets up blocks, contacts and pattern for a step of length h. @param jumps of blocks that land in it, ascending
template <class K>
void assemble_blocks(const Model& model, const Stage& stage, const State& state,
                     const ContactSetIn<K::dimension>& contacts, double h, const std::vector<Jump<K>>& jumps,
                     StepSystem<K>& system);

/// The stiffness at the last evaluation, with the bound frozen: system.matrix.
template <class K>
void assemble_matrix(bool published, int threads, StepSystem<K>& system);

/// Residual and loads at the iterate `d` from the contact forces last evaluated. @returns false if a block inverts
template <class K>
bool evaluate_residual(const Eigen::VectorXd& d, StepSystem<K>& system);

/// Solves K direction = -residual with the stiffness at the last evaluation.
/// @param slack how many times `linear_tolerance` will do
template <class K>
bool solve_direction(const StepControl& control, bool published, double slack, StepSystem<K>& system,
                     StepReport& report);

}  // namespace voussoir::step
