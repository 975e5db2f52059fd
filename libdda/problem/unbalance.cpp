#include "libdda/problem/unbalance.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <vector>

#include "libdda/model/parallel.h"

namespace voussoir::step
{

namespace
{

/// |R| of a row, moments divided by the block's size, and what of it is tolerated [N].
struct Residual {
    double force, allowed;
};

template <class K>
Residual residual_of(int row, double tolerance, const StepProblem<K>& problem)
{
    constexpr int n = K::unknowns, dimension = K::dimension;
    constexpr double rounding = 50 * std::numeric_limits<double>::epsilon();
    const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
    const auto r = problem.residual.template segment<n>(n * row);
    const double force =
        std::max(r.template head<dimension>().norm(), r.template tail<n - dimension>().norm() / block.size);
    const double moved = problem.d.template segment<dimension>(n * row).norm();
    const double stiffness = K::deformable ? (block.elasticity.lambda + 2 * block.elasticity.mu) * block.size : 0;
    const double floor =
        rounding * (stiffness * block.size + block.base.diagonal().template head<dimension>().norm() * moved);
    return {force, tolerance * problem.load[row] + floor + std::numeric_limits<double>::min()};
}

}  // namespace

template <class K>
double unbalance_of(int row, double tolerance, const StepProblem<K>& problem)
{
    const auto [force, allowed] = residual_of(row, tolerance, problem);
    return force / allowed;
}

template <class K>
Unbalance unbalance(const StepProblem<K>& problem, double tolerance)
{
    const auto look_at = [&](int row, Unbalance& most) {
        const auto [force, allowed] = residual_of(row, tolerance, problem);
        if (force / allowed > most.worst)
            most = {force / allowed, problem.load[row] > 0 ? force / problem.load[row] : 0,
                    problem.block_of_row[row]};
    };
    Unbalance worst;
    std::mutex mutex;
    in_parallel(problem.block_of_row.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        Unbalance most;
        for (std::size_t row = first; row < end; ++row) look_at(static_cast<int>(row), most);
        const std::lock_guard lock(mutex);
        // Of equals the first.
        if (most.worst > worst.worst || (most.worst == worst.worst && most.block < worst.block)) worst = most;
    });
    return worst;
}

template <class K>
bool is_balanced_but_for_rounding(const StepProblem<K>& problem, double tolerance)
{
    constexpr double rounding =
        4 * std::numeric_limits<double>::epsilon();             // of places: of a centroid, of a lever
    std::vector<double> noise(problem.block_of_row.size(), 0);  // N
    for (const PatchStep<K>& patch : problem.contacts.patches) {
        double stiffness = 0;  // N/m
        for (int i = patch.first; i < patch.first + patch.count; ++i)
            stiffness += problem.contacts.points[i].normal_stiffness;
        for (const int row : {patch.row_a, patch.row_b}) {
            if (row < 0) continue;
            const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
            noise[row] += rounding * (block.start.centroid.norm() + block.size) * stiffness;
        }
    }
    for (std::size_t row = 0; row < noise.size(); ++row) {
        const auto [force, allowed] = residual_of(static_cast<int>(row), tolerance, problem);
        if (!(force <= allowed + noise[row])) return false;
    }
    return true;
}

#define VOUSSOIR_INSTANTIATE(K)                                       \
    template double unbalance_of(int, double, const StepProblem<K>&); \
    template Unbalance unbalance(const StepProblem<K>&, double);      \
    template bool is_balanced_but_for_rounding(const StepProblem<K>&, double)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
