// The lowest eigenvalues of K x = lambda M x and their vectors, K positive semidefinite and M block-diagonal.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/solve/block_matrix.h"
#include "libdda/solve/cholmod_factor.h"

namespace voussoir::solve
{

/// Eigenvalues below this share of the largest K_ii / M_ii are zero but for rounding.
constexpr double vanishing_eigenvalue = 1e-13;

struct LowestModes {
    Eigen::VectorXd eigenvalues;  // (modes) rising; those that vanish are 0
    Eigen::MatrixXd shapes;       // (unknowns x modes), x^T M x = 1
    bool converged = false;       // to rounding; else there are none
};

/// Block Lanczos on (K + s M)^-1 M with full orthogonalisation, so that equal eigenvalues (a square tower, loose
/// blocks) all come; s is too small to be seen in an eigenvalue and makes the matrix definite where stones are
/// loose. Answers are the same bits on every run. Source: [GrimesLewisSimon1994].
/// @param stiffness K; a row that is to be held is that of the identity
/// @param mass (rows x block_size x block_size) blocks of M, column major; 0 in held rows and columns
/// @param factor that of the pattern of K, if it has been analysed already
LowestModes lowest_modes(const BlockMatrix& stiffness, const std::vector<double>& mass, int count,
                         CholmodFactor& factor);

}  // namespace voussoir::solve
