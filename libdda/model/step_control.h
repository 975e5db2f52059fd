// How the steps of a stage are made.
#pragma once

#include <algorithm>
#include <optional>

namespace voussoir
{

/// Shares of the end-of-step value in the force of a step; the inertia is Newmark's (1/2, 1) in all.
///
/// The step is v1 = v0 + h a, q1 = q0 + h (v0 + v1)/2 with M a = F. `newmark` takes F at the end of the step
/// (Shi's Newmark beta = 1/2, gamma = 1): damping ratio omega h / 4. `energy_decaying` takes, term by term, the
/// discrete gradient of the potential (which conserves energy exactly) plus `dissipation` times the difference to
/// the end-of-step force: damping ratio dissipation x omega h / 4, and never a gain of energy, for every term's
/// loss is >= 0 by convexity; loads are means over the step. A contact that was open or sliding at the start of
/// the step keeps the end-of-step force.
enum class Integrator { newmark, energy_decaying };

/// Iterations that the plain iteration may take: nothing shortens it, and it shall end where it leads.
constexpr int plain_open_close = 1000;

/// How the state of contacts is found.
enum class OpenClose {
    newton,     // Newton iteration with a line search
    plain,      // the same with nothing that makes it fast: slow, and what `newton` is judged against
    published,  // Shi's: states and friction loads from the previous pass, a few passes, else cut the step
};

/// Who solves the linear systems.
enum class LinearSolverKind {
    automatic,            // conjugate gradients, and CHOLMOD where they do not converge
    cholmod,              // sparse Cholesky factors
    conjugate_gradients,  // preconditioned by block-incomplete Cholesky
};

/// Time step, integrator, tolerances.
struct StepControl {
    double time_step = 1e-3;  // s, nominal; cut steps return to this grid
    // time_step is halved in the course of the run where steps take too much of the energy that is put in.
    bool automatic = false;
    double min_time_step = 1e-9;  // s; below it the run gives up
    // m, by which a step may displace a block wrongly; 0: all steps are as long as time_step, else at most as long
    double step_error = 0;
    Integrator integrator = Integrator::energy_decaying;  // of the step
    // 0..1, of energy_decaying; none: as much as keeps the method second order, 10/s x time_step, at most 0.1
    std::optional<double> dissipation;
    OpenClose open_close = OpenClose::newton;  // the others are for comparison
    // Steps end just before stones land, and the rest of the step follows, in scenes of at most this many blocks
    // with unknowns. In a large structure something lands in nearly every step, and none of it decides.
    int divide_up_to_blocks = 10;
    int max_open_close = 80;  // Newton iterations before the step is cut (published: 6; see plain_open_close)
    double force_tolerance = 1e-5;  // unbalanced force of a block / (its weight + its contact forces)
    LinearSolverKind linear_solver = LinearSolverKind::automatic;  // who solves
    double linear_tolerance =
        1e-3;         // relative residual of conjugate gradients; the force residual is exact anyway
    int threads = 1;  // answers do not depend on it

    /// Whether contacts are iterated on as published.
    bool is_published() const { return open_close == OpenClose::published; }
    /// The dissipation of energy_decaying, given or by the rule.
    double dissipation_used() const { return dissipation.value_or(std::min(0.1, 10 * time_step)); }
};

}  // namespace voussoir
