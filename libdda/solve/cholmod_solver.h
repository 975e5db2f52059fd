// The direct solver.
#pragma once

#include <memory>

#include "libdda/solve/linear_solver.h"

namespace voussoir::solve
{

/// Sparse Cholesky (CHOLMOD): the symbolic analysis is kept while the pattern stays.
std::unique_ptr<LinearSolver> make_cholmod_solver();

}  // namespace voussoir::solve
