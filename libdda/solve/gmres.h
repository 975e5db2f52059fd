// Generalised minimal residuals for systems that are not symmetric, preconditioned from the right.
// Source: [SaadSchultz1986].
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "libdda/solve/linear_solver.h"
#include "libdda/solve/pieces.h"

namespace voussoir::solve
{

/// Solves A x = b by building one Krylov space, without restarts. Memory is kept from call to call. Vectors in
/// several pieces are preconditioned in single precision (IncompleteFactor): what became of each is kept then, for
/// the rounding of their sum would be another, and the solution another than the one whose residual is known
/// ([Saad1993]).
class Gmres
{
 public:
    using Operator = std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& y)>;  // y = A x

    /// @param tolerance |b - A x| / |b|
    /// @param pieces of the vectors
    /// @returns not solved after max_iterations; x is then the best of the space
    LinearReport solve(const Operator& multiply, const Operator& precondition, const Eigen::VectorXd& b,
                       double tolerance, int max_iterations, Pieces pieces, Eigen::VectorXd& x);

 private:
    /// Takes from w, one piece, what it has of vectors 0 ... k, one after the other: column k of the Hessenberg
    /// matrix. @returns |w|^2 of what is left
    double orthogonalise(int k);
    /// The same of several pieces, all products before anything is taken: w is read from memory twice, not once
    /// for every vector. Rounding leaves more of the vectors in it, some eps (|b| / |residual|)^2, which is
    /// nothing at the tolerances of a step ([GiraudLangouRozloznikEshof2005]).
    double orthogonalise_together(int k, Pieces& pieces);

    std::vector<Eigen::VectorXd> basis_;
    std::vector<Eigen::VectorXd> improved_;  // the same, preconditioned, if they are in several pieces
    Eigen::MatrixXd upper_;                  // of the Hessenberg matrix, as the rotations leave it
    Eigen::VectorXd rest_, cosine_, sine_;
    Eigen::MatrixXd shares_;  // of the pieces in those products, scratch
    Eigen::VectorXd z_, w_;
};

}  // namespace voussoir::solve
