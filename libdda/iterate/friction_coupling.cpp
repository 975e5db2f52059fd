#include "libdda/iterate/friction_coupling.h"

#include <algorithm>

#include "libdda/model/parallel.h"

namespace voussoir::step
{

namespace
{

/// Whether the points of a patch make a part.
template <class K>
bool makes_a_part(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points)
{
    if (patch.row_a < 0 && patch.row_b < 0) return false;
    const auto first = points.begin() + patch.first;
    return std::any_of(first, first + patch.count, follows_its_bound<K::dimension>);
}

}  // namespace

template <class K>
bool FrictionCoupling<K>::gather(const StepProblem<K>& problem)
{
    const std::vector<PointStep<K::dimension>>& points = problem.contacts.points;
    has_held_.resize(problem.block_of_row.size());
    in_parallel(has_held_.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t row = first; row < end; ++row) {
            const auto& held = problem.blocks[problem.block_of_row[row]].held;
            has_held_[row] = std::find(held.begin(), held.end(), true) != held.end();
        }
    });
    const std::vector<PatchStep<K>>& patches = problem.contacts.patches;
    first_of_patch_.assign(patches.size() + 1, 0);
    in_parallel(patches.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k)
            first_of_patch_[k + 1] = makes_a_part(patches[k], points) ? 1 : 0;
    });
    for (std::size_t k = 0; k < patches.size(); ++k) first_of_patch_[k + 1] += first_of_patch_[k];
    parts_.resize(first_of_patch_.back());
    in_parallel(patches.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k)
            if (first_of_patch_[k] < first_of_patch_[k + 1])
                parts_[first_of_patch_[k]] = patch_tangent(patches[k], points);
    });
    return !parts_.empty();
}

template <class K>
void FrictionCoupling<K>::add_to_free(const StepProblem<K>& problem, int row, const typename K::Unknowns& force,
                                      Eigen::VectorXd& y) const
{
    constexpr int n = K::unknowns;
    if (!has_held_[row]) {
        y.segment<n>(n * row) += force;
        return;
    }
    const auto& held = problem.blocks[problem.block_of_row[row]].held;
    for (int k = 0; k < n; ++k)
        if (!held[k]) y[n * row + k] += force[k];
}

template <class K>
void FrictionCoupling<K>::add_product(StepProblem<K>& problem, const Eigen::VectorXd& x, Eigen::VectorXd& y)
{
    shears_.resize(parts_.size());
    in_parallel(parts_.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) shears_[i] = shear_of(parts_[i], x);
    });
    const auto add = [&](int i, bool to_a) {
        const Part& part = parts_[i];
        if (to_a)
            add_to_free(problem, part.row_a, on_a(part, shears_[i]), y);
        else
            add_to_free(problem, part.row_b, on_b(part, shears_[i]), y);
    };
    if (problem.threads <= 1) {
        for (int i = 0; i < static_cast<int>(parts_.size()); ++i) {
            if (parts_[i].row_a >= 0) add(i, true);
            if (parts_[i].row_b >= 0) add(i, false);
        }
        return;
    }
    // Row by row, in the same order.
    problem.patches_of_rows.find(problem.contacts.patches, problem.block_of_row.size());
    in_parallel(problem.block_of_row.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row)
            for (const int k : problem.patches_of_rows.of(row))
                for (int i = first_of_patch_[k]; i < first_of_patch_[k + 1]; ++i) add(i, parts_[i].row_a == row);
    });
}

#define VOUSSOIR_INSTANTIATE(K) template class FrictionCoupling<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
