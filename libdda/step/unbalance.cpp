#include "libdda/step/unbalance.h"

#include <algorithm>
#include <limits>

namespace voussoir::step
{

template <class K>
Unbalance unbalance(const StepSystem<K>& system, double tolerance)
{
    constexpr int n = K::unknowns, dimension = K::dimension;
    constexpr double rounding = 50 * std::numeric_limits<double>::epsilon();
    Unbalance most;
    for (std::size_t row = 0; row < system.block_of_row.size(); ++row) {
        const int b = system.block_of_row[row];
        const BlockStep<K>& block = system.blocks[b];
        const auto r = system.residual.template segment<n>(n * row);
        const double force =
            std::max(r.template head<dimension>().norm(), r.template tail<n - dimension>().norm() / block.size);
        const double moved = system.d.template segment<dimension>(n * row).norm();
        const double stiffness =
            K::deformable ? (block.elasticity.lambda + 2 * block.elasticity.mu) * block.size : 0;
        const double floor =
            rounding * (stiffness * block.size + block.base.diagonal().template head<dimension>().norm() * moved);
        const double allowed = tolerance * system.load[row] + floor + std::numeric_limits<double>::min();
        if (force / allowed <= most.worst) continue;
        most = {force / allowed, system.load[row] > 0 ? force / system.load[row] : 0, b};
    }
    return most;
}

#define VOUSSOIR_INSTANTIATE(K) template Unbalance unbalance(const StepSystem<K>&, double)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
