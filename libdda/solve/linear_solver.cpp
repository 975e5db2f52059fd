#include "libdda/solve/linear_solver.h"

#include "libdda/solve/cholmod_solver.h"
#include "libdda/solve/conjugate_gradients.h"

namespace voussoir::solve
{

namespace
{

/// Conjugate gradients first; the direct solver takes over a system they cannot solve.
class FallbackSolver : public LinearSolver
{
 public:
    explicit FallbackSolver(double tolerance) : iterative_(make_conjugate_gradient_solver(tolerance)) {}

    void place(const RowPlaces& places) override { iterative_->place(places); }
    void set_tolerance(double tolerance) override { iterative_->set_tolerance(tolerance); }
    void use_threads(int threads) override { iterative_->use_threads(threads); }

    LinearReport solve(const BlockMatrix& matrix, const Eigen::VectorXd& right_hand_side,
                       Eigen::VectorXd& solution) override
    {
        LinearReport report = iterative_->solve(matrix, right_hand_side, solution);
        if (report.solved) return report;
        if (!direct_) direct_ = make_cholmod_solver();
        const LinearReport second = direct_->solve(matrix, right_hand_side, solution);
        report.solved = second.solved;
        report.factorisations += second.factorisations;
        report.factor_entries = second.factor_entries;
        return report;
    }

    bool prepare(const BlockMatrix& matrix) override { return iterative_->prepare(matrix); }
    void multiply(const BlockMatrix& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& y) override
    {
        iterative_->multiply(matrix, x, y);
    }
    void precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) override { iterative_->precondition(r, z); }

 private:
    std::unique_ptr<LinearSolver> iterative_, direct_;
};

}  // namespace

void LinearSolver::multiply(const BlockMatrix& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& y)
{
    solve::multiply(matrix, x, y);
}

std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind, double tolerance)
{
    switch (kind) {
        case LinearSolverKind::cholmod:
            return make_cholmod_solver();
        case LinearSolverKind::conjugate_gradients:
            return make_conjugate_gradient_solver(tolerance);
        case LinearSolverKind::automatic:
            break;
    }
    return std::make_unique<FallbackSolver>(tolerance);
}

}  // namespace voussoir::solve
