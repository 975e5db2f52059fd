#include "libdda/step/friction_coupling.h"

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

template <class K>
void add_to_free(const StepSystem<K>& system, int row, const typename K::Vector& lever,
                 const typename K::Vector& f, Eigen::VectorXd& y)
{
    constexpr int n = K::unknowns;
    typename K::Unknowns force = K::Unknowns::Zero();
    K::add_force(force, lever, f);
    const auto& held = system.blocks[system.block_of_row[row]].held;
    for (int k = 0; k < n; ++k)
        if (!held[k]) y[n * row + k] += force[k];
}

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
bool FrictionCoupling<K>::gather(const StepSystem<K>& system)
{
    const std::vector<PatchStep<K>>& patches = system.contacts.patches;
    const auto visit = [&](std::size_t k, const auto& each) {
        if (patches[k].row_a < 0 && patches[k].row_b < 0) return;
        for (int i = patches[k].first; i < patches[k].first + patches[k].count; ++i) {
            const PointStep<K::dimension>& p = system.contacts.points[i];
            if (follows_its_bound(p)) each(p);
        }
    };
    first_of_patch_.assign(patches.size() + 1, 0);
    in_parallel(patches.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) visit(k, [&](const auto&) { ++first_of_patch_[k + 1]; });
    });
    for (std::size_t k = 0; k < patches.size(); ++k) first_of_patch_[k + 1] += first_of_patch_[k];
    points_.resize(first_of_patch_.back());
    in_parallel(patches.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            int next = first_of_patch_[k];
            visit(k, [&](const PointStep<K::dimension>& p) { points_[next++] = friction_tangent(patches[k], p); });
        }
    });
    return !points_.empty();
}

template <class K>
void FrictionCoupling<K>::add_product(StepSystem<K>& system, const Eigen::VectorXd& x, Eigen::VectorXd& y)
{
    using Vector = typename K::Vector;
    shears_.resize(points_.size());
    in_parallel(points_.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) shears_[i] = shear_of(points_[i], x);
    });
    const auto add = [&](int i, bool to_a) {
        const FrictionTangent<K>& p = points_[i];
        if (to_a)
            add_to_free<K>(system, p.row_a, p.lever_a, shears_[i], y);
        else
            add_to_free<K>(system, p.row_b, p.lever_b, Vector(-shears_[i]), y);
    };
    if (system.threads <= 1) {
        for (int i = 0; i < static_cast<int>(points_.size()); ++i) {
            if (points_[i].row_a >= 0) add(i, true);
            if (points_[i].row_b >= 0) add(i, false);
        }
        return;
    }
    // Row by row, in the same order.
    system.patches_of_rows.find(system.contacts.patches, system.block_of_row.size());
    in_parallel(system.block_of_row.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row)
            for (const int k : system.patches_of_rows.of(row))
                for (int i = first_of_patch_[k]; i < first_of_patch_[k + 1]; ++i) add(i, points_[i].row_a == row);
    });
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
