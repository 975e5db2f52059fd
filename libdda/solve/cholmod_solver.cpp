#include "libdda/solve/cholmod_solver.h"

#include "libdda/solve/cholmod_factor.h"

namespace voussoir::solve
{

namespace
{

class CholmodSolver : public LinearSolver
{
 public:
    LinearReport solve(const BlockMatrix& matrix, const Eigen::VectorXd& right_hand_side,
                       Eigen::VectorXd& solution) override
    {
        LinearReport report;
        report.factorisations = 1;
        if (!factor_.factorise(matrix)) return report;
        report.factor_entries = factor_.entries();
        report.solved = factor_.solve(right_hand_side, columns_);
        if (report.solved) solution = columns_.col(0);
        return report;
    }

    bool prepare(const BlockMatrix& matrix) override { return factor_.factorise(matrix); }
    void precondition(const Eigen::VectorXd& r, Eigen::VectorXd& z) override
    {
        factor_.solve(r, columns_);
        z = columns_.col(0);
    }

 private:
    CholmodFactor factor_;
    Eigen::MatrixXd columns_;  // scratch
};

}  // namespace

std::unique_ptr<LinearSolver> make_cholmod_solver()
{
    return std::make_unique<CholmodSolver>();
}

}  // namespace voussoir::solve
