// Where a block would be at the end of the step if no force acted on it.
#pragma once

#include <span>

#include "libdda/block/block_step.h"

namespace voussoir::step
{

/// A rho y y^T of a block as it is mapped: from the reference to the present configuration.
template <class Matrix>
Matrix spread_of(const Matrix& map, const Matrix& density_second)
{
    return map * density_second * map.transpose();
}

/// Of a block that moves with `velocity` and whose map changes at `rate` [J].
template <class K>
double kinetic_energy(const BlockStep<K>& step, const typename K::Vector& velocity,
                      const typename K::Matrix& rate);

/// Predicts the free flight of a block over the step, and its landing.
/// @param jumps of a block that lands in the step, one after the other
template <class K>
void predict(const State& state, int block, double h, std::span<const Jump<K>> jumps, BlockStep<K>& step);

}  // namespace voussoir::step
