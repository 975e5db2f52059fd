#include "libdda/step/friction_coupling.h"

#include <algorithm>

#include "libdda/model/parallel.h"
#include "libdda/step/part_timer.h"
#include "libdda/step/step_system.h"

namespace voussoir::step
{

namespace
{

constexpr int max_vectors = 100;  // of the Krylov space
// In a large scene each vector more is dear, and where the best of so many leads is looked at before it is taken.
constexpr int max_vectors_in_large = 50;

/// What blocks feel of others that feel nothing of them: the free fields of a boundary. y += C x.
template <class K>
void add_one_sided(const StepSystem<K>& system, const Eigen::VectorXd& x, Eigen::VectorXd& y)
{
    constexpr int n = K::unknowns;
    for (const Coupling<K>& coupling : system.applied.couplings) {
        const int row = system.blocks[coupling.block].row, column = system.blocks[coupling.other].row;
        if (coupling.mutual || row < 0 || column < 0) continue;
        const typename K::Unknowns force = coupling.matrix * x.segment<n>(n * column);
        for (int k = 0; k < n; ++k)
            if (!system.blocks[coupling.block].held[k]) y[n * row + k] -= force[k];
    }
}

}  // namespace

template <class K>
template <class Part, class CountOf, class Make>
void FrictionCoupling<K>::gather_parts(const StepSystem<K>& system, const CountOf& count_of, const Make& make,
                                       std::vector<Part>& parts)
{
    const std::vector<PatchStep<K>>& patches = system.contacts.patches;
    first_of_patch_.assign(patches.size() + 1, 0);
    in_parallel(patches.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k)
            if (patches[k].row_a >= 0 || patches[k].row_b >= 0) first_of_patch_[k + 1] = count_of(patches[k]);
    });
    for (std::size_t k = 0; k < patches.size(); ++k) first_of_patch_[k + 1] += first_of_patch_[k];
    parts.resize(first_of_patch_.back());
    in_parallel(patches.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k)
            if (first_of_patch_[k] < first_of_patch_[k + 1]) make(patches[k], parts.data() + first_of_patch_[k]);
    });
}

template <class K>
bool FrictionCoupling<K>::gather(const StepSystem<K>& system)
{
    const std::vector<PointStep<K::dimension>>& points = system.contacts.points;
    has_held_.resize(system.block_of_row.size());
    in_parallel(has_held_.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t row = first; row < end; ++row) {
            const auto& held = system.blocks[system.block_of_row[row]].held;
            has_held_[row] = std::find(held.begin(), held.end(), true) != held.end();
        }
    });
    const auto count_of = [&](const PatchStep<K>& patch) {
        const auto first = points.begin() + patch.first;
        return static_cast<int>(std::count_if(first, first + patch.count, follows_its_bound<K::dimension>));
    };
    if constexpr (!K::deformable) {
        by_patches_ = is_large(system);
        if (by_patches_) {
            gather_parts(
                system, [&](const PatchStep<K>& patch) { return std::min(count_of(patch), 1); },
                [&](const PatchStep<K>& patch, PatchTangent<K>* part) { *part = patch_tangent(patch, points); },
                patches_);
            return !patches_.empty();
        }
    }
    gather_parts(
        system, count_of,
        [&](const PatchStep<K>& patch, FrictionTangent<K>* part) {
            for (int i = patch.first; i < patch.first + patch.count; ++i)
                if (follows_its_bound(points[i])) *part++ = friction_tangent(patch, points[i]);
        },
        points_);
    return !points_.empty();
}

template <class K>
void FrictionCoupling<K>::add_to_free(const StepSystem<K>& system, int row, const typename K::Unknowns& force,
                                      Eigen::VectorXd& y) const
{
    constexpr int n = K::unknowns;
    if (!has_held_[row]) {
        y.segment<n>(n * row) += force;
        return;
    }
    const auto& held = system.blocks[system.block_of_row[row]].held;
    for (int k = 0; k < n; ++k)
        if (!held[k]) y[n * row + k] += force[k];
}

template <class K>
template <class Part, class Shear>
void FrictionCoupling<K>::add_parts(const std::vector<Part>& parts, std::vector<Shear>& shears,
                                    StepSystem<K>& system, const Eigen::VectorXd& x, Eigen::VectorXd& y) const
{
    shears.resize(parts.size());
    in_parallel(parts.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) shears[i] = shear_of(parts[i], x);
    });
    const auto add = [&](int i, bool to_a) {
        const Part& part = parts[i];
        if (to_a)
            add_to_free(system, part.row_a, on_a(part, shears[i]), y);
        else
            add_to_free(system, part.row_b, on_b(part, shears[i]), y);
    };
    if (system.threads <= 1) {
        for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
            if (parts[i].row_a >= 0) add(i, true);
            if (parts[i].row_b >= 0) add(i, false);
        }
        return;
    }
    // Row by row, in the same order.
    system.patches_of_rows.find(system.contacts.patches, system.block_of_row.size());
    in_parallel(system.block_of_row.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row)
            for (const int k : system.patches_of_rows.of(row))
                for (int i = first_of_patch_[k]; i < first_of_patch_[k + 1]; ++i) add(i, parts[i].row_a == row);
    });
}

template <class K>
void FrictionCoupling<K>::add_product(StepSystem<K>& system, const Eigen::VectorXd& x, Eigen::VectorXd& y)
{
    if constexpr (!K::deformable)
        if (by_patches_) return add_parts(patches_, patch_shears_, system, x, y);
    add_parts(points_, shears_, system, x, y);
}

template <class K>
bool FrictionCoupling<K>::solve_direction(const StepControl& control, double tolerance, StepSystem<K>& system,
                                          StepReport& report)
{
    using Eigen::VectorXd;
    {
        const PartTimer timer(report.seconds, Part::assembly);
        assemble_matrix(false, control.threads, system);
    }
    const PartTimer timer(report.seconds, Part::linear_solve);
    if (!system.solver->prepare(system.matrix)) return false;
    ++report.factorisations;
    const auto multiply = [&](const VectorXd& x, VectorXd& y) {
        system.solver->multiply(system.matrix, x, y);
        add_product(system, x, y);
        add_one_sided(system, x, y);
    };
    const auto precondition = [&](const VectorXd& r, VectorXd& z) { system.solver->precondition(r, z); };
    const bool large = is_large(system);
    const solve::LinearReport linear = gmres_.solve(
        multiply, precondition, system.residual, tolerance, large ? max_vectors_in_large : max_vectors,
        solve::Pieces(system.matrix.rows(), K::unknowns, system.threads), system.direction);
    system.direction = -system.direction;
    report.linear_iterations += linear.iterations;
    return (linear.solved || (large && linear.iterations > 0)) && system.direction.allFinite();
}

#define VOUSSOIR_INSTANTIATE(K) template class FrictionCoupling<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
