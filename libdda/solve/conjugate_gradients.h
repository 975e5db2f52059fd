// The iterative solver.
#pragma once

#include <memory>

#include "libdda/solve/linear_solver.h"

namespace voussoir::solve
{

/// Conjugate gradients preconditioned by an incomplete Cholesky factor on the pattern of the matrix, block by
/// block: exact for chains (bridge, tower). @param tolerance of |K x - b| / |b|
std::unique_ptr<LinearSolver> make_conjugate_gradient_solver(double tolerance, int max_iterations = 500);

/// y = A x for a symmetric matrix of which the lower triangle is stored.
void multiply(const BlockMatrix& matrix, const Eigen::VectorXd& x, Eigen::VectorXd& y);

}  // namespace voussoir::solve
