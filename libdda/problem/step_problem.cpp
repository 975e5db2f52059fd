#include "libdda/problem/step_problem.h"

#include <algorithm>
#include <atomic>
#include <span>

#include "libdda/forces/contact_stiffness.h"
#include "libdda/model/parallel.h"

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

/// Whether all that is closed of a joint slides.
template <int D>
bool slides(const ContactSetIn<D>& contacts, const ContactPatchIn<D>& patch)
{
    bool any = false;
    for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
        const ContactPointIn<D>& point = contacts.points[i];
        if (point.gap >= 0) continue;
        if (point.status != ContactStatus::sliding) return false;
        any = true;
    }
    return any;
}

/// An elastic stone that slides with constant friction is unstable without damping: its strains and its friction
/// feed each other, at a rate that does not depend on the step, until it chatters and its mean friction falls.
/// While a stone slides its elastic force is therefore that of the end of the step. On a joint without friction
/// nothing feeds anything, and it keeps its energy. Source: docs/numerics.md 5.
template <class K>
void damp_sliding_blocks(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                         std::vector<BlockStep<K>>& blocks)
{
    if (!K::deformable || end_share(stage) == 1) return;
    for (const ContactPatchIn<K::dimension>& patch : contacts.patches)
        if (friction_between(model, patch.block_a, patch.block_b, true).rubs() && slides(contacts, patch))
            for (const int b : {patch.block_a, patch.block_b}) take_elasticity_at_end(blocks[b]);
}

}  // namespace

template <class K>
void assemble_blocks(const Model& model, const Stage& stage, const State& state,
                     const ContactSetIn<K::dimension>& contacts, double h, const std::vector<Jump<K>>& jumps,
                     StepProblem<K>& problem)
{
    const int count = static_cast<int>(model.blocks.size());
    const double end_time = state.stage_time + h;
    problem.h = h;
    problem.patch_threads = stage.control.threads;
    problem.fracture = 0;
    problem.stays = false;
    problem.blocks.resize(count);
    problem.block_of_row.clear();
    for (BlockStep<K>& block : problem.blocks) block.is_foundation = false;
    for (const Foundation& foundation : model.foundations) problem.blocks[foundation.block].is_foundation = true;
    in_parallel(model.blocks.size(), stage.control.threads, [&](std::size_t first, std::size_t end) {
        const auto earlier = [](const Jump<K>& jump, std::size_t block) {
            return jump.block < static_cast<int>(block);
        };
        auto jump = std::lower_bound(jumps.begin(), jumps.end(), first, earlier);
        for (int b = static_cast<int>(first); b < static_cast<int>(end); ++b) {
            const auto own = jump;
            while (jump != jumps.end() && jump->block == b) ++jump;
            begin_block(model, stage, state, b, h, end_time, std::span<const Jump<K>>(own, jump),
                        problem.blocks[b]);
        }
    });
    for (int b = 0; b < count; ++b) {
        BlockStep<K>& block = problem.blocks[b];
        bool all_held = true;
        for (const bool held : block.held) all_held = all_held && held;
        block.row = all_held ? -1 : static_cast<int>(problem.block_of_row.size());
        if (!all_held) problem.block_of_row.push_back(b);
    }
    damp_sliding_blocks<K>(model, stage, contacts, problem.blocks);
    problem.others.each(
        [&](auto& group) { begin_forces(model, stage, state, h, end_time, problem.blocks, group); });
    add_body_accelerations(stage, h, end_time, problem.blocks);
    begin_contacts(model, stage, h, contacts, problem.blocks, problem.contacts);
    problem.patches_of_rows.begin();

    const int rows = static_cast<int>(problem.block_of_row.size());
    problem.threads = rows < blocks_worth_threads ? 1 : stage.control.threads;
    problem.pairs.clear();
    for (const PatchStep<K>& patch : problem.contacts.patches)
        if (patch.row_a >= 0 && patch.row_b >= 0)
            problem.pairs.emplace_back(std::max(patch.row_a, patch.row_b), std::min(patch.row_a, patch.row_b));
    problem.others.each([&](const auto& group) { add_pairs(problem.blocks, group, problem.pairs); });
    if (problem.pairs != problem.known_pairs || problem.matrix.rows() != rows) {
        problem.known_pairs = problem.pairs;
        solve::set_pattern(problem.matrix, K::unknowns, rows, problem.pairs);
    }
    problem.d.setZero(rows * K::unknowns);
    problem.residual.setZero(rows * K::unknowns);
    problem.contact_force.setZero(rows * K::unknowns);
    problem.internal.resize(rows);
    problem.load.assign(rows, 0.0);
}

namespace
{

/// Force scale of a block: what it weighs, what its contacts press, what its own deformation and spin carry.
template <class K>
double load_of(const BlockStep<K>& block, const InternalForce<K>& internal, double pressing)
{
    double load =
        block.body_force.norm() + pressing + block.steady.tail(K::unknowns - K::dimension).norm() / block.size;
    if constexpr (K::deformable) load += internal.force.norm() / block.size;
    return load;
}

template <class K>
void add_contact_force(int row, const typename K::Unknowns& force, double pressing, StepProblem<K>& problem)
{
    constexpr int n = K::unknowns;
    problem.contact_force.template segment<n>(n * row) += force;
    problem.load[row] += pressing;
}

template <class K>
void gather_contact_forces(StepProblem<K>& problem)
{
    const ContactStep<K>& contacts = problem.contacts;
    problem.contact_force.setZero();
    problem.load.assign(problem.load.size(), 0.0);
    if (problem.threads <= 1) {
        for (const PatchStep<K>& patch : contacts.patches) {
            if (patch.pressing == 0 && patch.force_a.isZero(0)) continue;
            if (patch.row_a >= 0) add_contact_force<K>(patch.row_a, patch.force_a, patch.pressing, problem);
            if (patch.row_b >= 0) add_contact_force<K>(patch.row_b, patch.force_b, patch.pressing, problem);
        }
        return;
    }
    // Row by row, in the same order.
    problem.patches_of_rows.find(contacts.patches, problem.block_of_row.size());
    in_parallel(problem.block_of_row.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row)
            for (const int k : problem.patches_of_rows.of(row)) {
                const PatchStep<K>& patch = contacts.patches[k];
                if (patch.pressing == 0 && patch.force_a.isZero(0)) continue;
                const auto& force = patch.row_a == row ? patch.force_a : patch.force_b;
                add_contact_force<K>(row, force, patch.pressing, problem);
            }
    });
}

}  // namespace

template <class K>
bool evaluate_residual(const VectorXd& d, StepProblem<K>& problem)
{
    constexpr int n = K::unknowns;
    gather_contact_forces(problem);
    problem.others.each(
        [&](auto& group) { add_forces(d, problem.blocks, group, problem.contact_force, problem.load); });
    std::atomic<bool> admissible = true;
    in_parallel(problem.block_of_row.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t row = first; row < end; ++row) {
            const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
            const typename K::Unknowns unknowns = d.segment<n>(n * row);
            InternalForce<K>& internal = problem.internal[row];
            internal = internal_force(block, unknowns);
            if (!internal.admissible) admissible = false;
            auto residual = problem.residual.template segment<n>(n * row);
            residual = block.inertia * unknowns + internal.force - block.steady -
                       problem.contact_force.template segment<n>(n * row);
            for (int k = 0; k < n; ++k)
                if (block.held[k]) residual[k] = 0;
            problem.load[row] = load_of(block, internal, problem.load[row]);
        }
    });
    return admissible;
}

namespace
{

/// Held components keep their prescribed value: their rows and columns become those of the identity.
template <class K>
void hold_components(StepProblem<K>& problem)
{
    constexpr int n = K::unknowns;
    using Block = Eigen::Map<typename K::Square>;
    solve::BlockMatrix& matrix = problem.matrix;
    for (int row = 0; row < matrix.rows(); ++row) {
        const auto& held = problem.blocks[problem.block_of_row[row]].held;
        for (int p = matrix.row_start[row]; p < matrix.row_start[row + 1]; ++p) {
            const int column = matrix.columns[p];
            const auto& held_column = problem.blocks[problem.block_of_row[column]].held;
            Block block(matrix.block(p));
            for (int k = 0; k < n; ++k) {
                if (held[k]) block.row(k).setZero();
                if (held_column[k]) block.col(k).setZero();
                if (row == column && held[k]) block(k, k) = 1;
            }
        }
    }
}

}  // namespace

namespace
{

template <class K>
void assemble_contacts(StepProblem<K>& problem)
{
    if (problem.threads <= 1) {
        for (const PatchStep<K>& patch : problem.contacts.patches)
            add_patch_stiffness(patch, patch.row_a, patch.row_b, patch.row_a >= 0, patch.row_b >= 0,
                                problem.matrix);
        return;
    }
    problem.patches_of_rows.find(problem.contacts.patches, problem.block_of_row.size());
    in_parallel(problem.block_of_row.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row)
            for (const int k : problem.patches_of_rows.of(row)) {
                const PatchStep<K>& patch = problem.contacts.patches[k];
                add_patch_stiffness(patch, patch.row_a, patch.row_b, patch.row_a == row, patch.row_b == row,
                                    problem.matrix);
            }
    });
}

}  // namespace

template <class K>
void assemble_matrix(bool published, StepProblem<K>& problem)
{
    using Block = Eigen::Map<typename K::Square>;
    solve::BlockMatrix& matrix = problem.matrix;
    contact_stiffness(published, problem.patch_threads, problem.contacts);
    std::atomic<bool> any_held = false;
    in_parallel(problem.block_of_row.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        for (int row = static_cast<int>(first); row < static_cast<int>(end); ++row) {
            std::fill(matrix.block(matrix.row_start[row]), matrix.block(matrix.row_start[row + 1]), 0.0);
            const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
            Block(matrix.block(matrix.diagonal(row))) = block.base;
            for (const bool held : block.held)
                if (held) any_held = true;
        }
    });
    assemble_contacts(problem);
    problem.others.each([&](const auto& group) { add_stiffness(problem.blocks, group, matrix); });
    if (any_held) hold_components(problem);
}

#define VOUSSOIR_INSTANTIATE(K)                                                                                \
    template void assemble_blocks(const Model&, const Stage&, const State&, const ContactSetIn<K::dimension>&, \
                                  double, const std::vector<Jump<K>>&, StepProblem<K>&);                       \
    template void assemble_matrix(bool, StepProblem<K>&);                                                      \
    template bool evaluate_residual(const VectorXd&, StepProblem<K>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
