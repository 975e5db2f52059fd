// What moving single blocks changes in the residual of a step.
#pragma once

#include <vector>

#include "libdda/problem/step_problem.h"

namespace voussoir::step
{

/// Components that are held have no residual.
template <class K, class Vector>
void clear_held(const BlockStep<K>& block, Vector&& residual)
{
    for (int k = 0; k < K::unknowns; ++k)
        if (block.held[k]) residual[k] = 0;
}

/// Adds the forces of a patch, as last evaluated, to the residual of its two rows. @param sign 1 takes away what
/// they were, for they act against it; -1 lets them act
template <class K>
void add_patch_forces(const PatchStep<K>& patch, double sign, StepProblem<K>& problem)
{
    constexpr int n = K::unknowns;
    const auto add = [&](int row, const typename K::Unknowns& force) {
        if (row < 0) return;
        auto residual = problem.residual.template segment<n>(n * row);
        residual += sign * force;
        clear_held(problem.blocks[problem.block_of_row[row]], residual);
    };
    add(patch.row_a, patch.force_a);
    add(patch.row_b, patch.force_b);
}

/// Moves a block to `to`: its inertia and what it feels inside follow in the residual; its contacts are left to
/// the caller.
template <class K>
void move_row(int row, const typename K::Unknowns& to, StepProblem<K>& problem)
{
    constexpr int n = K::unknowns;
    const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
    auto residual = problem.residual.template segment<n>(n * row);
    auto d = problem.d.template segment<n>(n * row);
    residual += block.inertia * (to - d);
    if constexpr (K::deformable) {
        const InternalForce<K> internal = internal_force(block, to);
        residual += internal.force - problem.internal[row].force;
        problem.internal[row] = internal;
    }
    clear_held(block, residual);
    d = to;
}

/// The rows that something beside contacts ties to others or to the ground. @param tied (rows)
template <class K>
void find_tied_rows(const StepProblem<K>& problem, std::vector<char>& tied)
{
    tied.assign(problem.block_of_row.size(), false);
    problem.others.each([&](const auto& group) { note_tied(problem.blocks, group, tied); });
}

}  // namespace voussoir::step
