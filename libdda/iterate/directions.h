// Directions for all stones at once.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "libdda/iterate/friction_coupling.h"
#include "libdda/iterate/iteration_rules.h"
#include "libdda/problem/step_problem.h"
#include "libdda/solve/gmres.h"
#include "libdda/solve/linear_solver.h"

namespace voussoir::step
{

/// Solves for directions; memory is reused from step to step.
template <class K>
class Directions
{
 public:
    /// To be called when a step is set up.
    void begin(const StepControl& control, const StepProblem<K>& problem);
    /// K direction = -R, K the stiffness at the last evaluation with the friction bound held: it leads down the
    /// potential. @param published with the states of contacts held instead of tangents @returns false without one
    bool find(bool published, StepProblem<K>& problem, StepReport& report);
    /// (K + C) direction = -R, C what the bound adds as it follows the normal force: nothing leads down it for
    /// sure.
    /// @param tolerance of what is left of R, as a share of it @returns false without one, or where C is nothing
    bool find_whole(double tolerance, const IterationRules& rules, StepProblem<K>& problem, StepReport& report);

    Eigen::VectorXd direction;  // (rows x unknowns) the one last found

 private:
    void place_rows(const StepProblem<K>& problem);

    std::unique_ptr<solve::LinearSolver> solver_;
    LinearSolverKind kind_ = LinearSolverKind::automatic;
    solve::RowPlaces places_;
    FrictionCoupling<K> coupling_;
    solve::Gmres gmres_;
};

}  // namespace voussoir::step
