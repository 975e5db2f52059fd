// The law of a deformable block: St Venant-Kirchhoff, on the Green strain.
#pragma once

#include <Eigen/Core>

#include "libdda/model/model.h"

namespace voussoir
{

/// Lame's constants of a block and its volume. S = lambda tr(E) 1 + 2 mu E in the dimension of the scene.
struct Elasticity {
    double lambda = 0, mu = 0;  // Pa; in plane stress lambda is the reduced 2 lambda mu / (lambda + 2 mu)
    double volume = 0;          // m3, reference

    /// Second Piola-Kirchhoff stress [Pa] of a Green strain.
    template <class Matrix>
    Matrix stress(const Matrix& green_strain) const
    {
        return lambda * green_strain.trace() * Matrix::Identity() + 2 * mu * green_strain;
    }
    /// Strain energy of the block [J].
    template <class Matrix>
    double energy(const Matrix& green_strain) const
    {
        const double trace = green_strain.trace();
        return volume * (0.5 * lambda * trace * trace + mu * green_strain.squaredNorm());
    }
};

/// 0.5 (A^T A - 1)
template <class Matrix>
Matrix green_strain_of(const Matrix& map)
{
    return 0.5 * (map.transpose() * map - Matrix::Identity());
}

/// Those of a block of a model.
Elasticity elasticity_of(const Model& model, int block);

}  // namespace voussoir
