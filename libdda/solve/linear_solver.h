// Solves the symmetric positive definite system of a Newton step.
#pragma once

#include <cstdint>
#include <memory>

#include "libdda/model/step_control.h"
#include "libdda/solve/block_matrix.h"
#include "libdda/solve/row_places.h"

namespace voussoir::solve
{

struct LinearReport {
    bool solved = false;
    int factorisations = 0;
    int iterations = 0;
    std::int64_t factor_entries = 0;  // numbers stored for the factor
};

/// One way of solving K x = b. Members keep what can be reused from call to call (symbolic analysis, memory), and
/// nothing that changes a result.
class LinearSolver
{
 public:
    virtual ~LinearSolver() = default;
    /// Where the rows of the matrices to come are: of use to who looks at more than the numbers of a matrix.
    virtual void place(const RowPlaces& /*places*/) {}
    /// Relative residual that is good enough from now on; nothing to a direct solver.
    virtual void set_tolerance(double /*tolerance*/) {}
    /// On how many threads it may work from now on; results do not depend on it.
    virtual void use_threads(int /*threads*/) {}
    /// @param matrix SPD; @param right_hand_side, solution (rows x block_size)
    virtual LinearReport solve(const BlockMatrix& matrix, const Eigen::VectorXd& right_hand_side,
                               Eigen::VectorXd& solution) = 0;
    /// Gets ready to precondition systems that are near this one. @returns false if that is not possible
    virtual bool prepare(const BlockMatrix& matrix) = 0;
    /// y = K x, K last prepared or solved with.
    virtual void multiply(const BlockMatrix& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& y);
    /// z = K^-1 r, or nearly, with the same.
    virtual void precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) = 0;
};

/// The member asked for. `automatic` is conjugate gradients, with CHOLMOD when they do not converge.
std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind, double tolerance);

}  // namespace voussoir::solve
