// The motions of large parts of a scene, each as one body: what a factor of near neighbours cannot see.
//
// An incomplete factor passes a load on from stone to stone, and conjugate gradients need the more iterations the
// more stones lie between. In the coarse space whole clusters of stones move as one block of the scene's
// kinematics does (rigid, or with a uniform gradient), P c; the system for c, P^T K P c = P^T r, is small and
// solved exactly. Iterations hardly grow with the number of stones then. Source: docs/numerics.md 3;
// [TangNabbenVuikErlangga2009].
#pragma once

#include <Eigen/Core>
#include <memory>

#include "libdda/solve/block_matrix.h"
#include "libdda/solve/row_places.h"

namespace voussoir::solve
{

class CoarseSpace
{
 public:
    CoarseSpace();
    ~CoarseSpace();
    CoarseSpace(const CoarseSpace&) = delete;
    CoarseSpace& operator=(const CoarseSpace&) = delete;

    /// Where the rows of the matrices to come are.
    void place(const RowPlaces& places);
    /// Gets ready for a matrix, but for factorise(). Results do not depend on the number of threads, here or
    /// below.
    /// @param columns of the matrix
    /// @returns false where it would not pay: no places, few rows, or a chain
    bool prepare(const BlockMatrix& matrix, const ColumnsOf& columns, int threads);
    /// The factor of P^T K P, on one thread.
    void factorise();
    /// x = P (P^T K P)^-1 P^T b
    void start(const Eigen::VectorXd& b, int threads, Eigen::VectorXd& x);
    /// z += P (P^T K P)^-1 P^T (r - K z)
    void correct(const Eigen::VectorXd& r, int threads, Eigen::VectorXd& z);

    /// What works for one kinematics.
    class Implementation;

 private:
    std::unique_ptr<Implementation> implementation_;
    Kinematics kinematics_ = Kinematics::spatial_deformable;
};

}  // namespace voussoir::solve
