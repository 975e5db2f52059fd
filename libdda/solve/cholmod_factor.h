// A sparse Cholesky factor (CHOLMOD) of a block matrix: made once, used for many right-hand sides.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "libdda/solve/block_matrix.h"

namespace voussoir::solve
{

/// What a factor of a pattern takes, known before it is computed.
struct FactorCost {
    double flops = 0;    // of the factorisation
    double entries = 0;  // numbers stored
};

/// The symbolic analysis is kept while the pattern stays. Out of memory it throws std::bad_alloc.
class CholmodFactor
{
 public:
    CholmodFactor();
    ~CholmodFactor();
    CholmodFactor(CholmodFactor&&) noexcept;
    CholmodFactor& operator=(CholmodFactor&&) noexcept;

    /// Orders the unknowns of a pattern, unless it is that of the last call.
    FactorCost analyse(const BlockMatrix& matrix);
    /// @returns false when the matrix is not positive definite
    bool factorise(const BlockMatrix& matrix);
    /// Numbers stored for the factor.
    std::int64_t entries() const;
    /// Solves for all columns of `right_hand_sides` (unknowns x columns). @returns whether all is finite
    bool solve(const Eigen::MatrixXd& right_hand_sides, Eigen::MatrixXd& solutions);

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace voussoir::solve
