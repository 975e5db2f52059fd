// Stiffness of the contacts at the last evaluation, patch by patch.
#pragma once

#include "libdda/forces/contact_step.h"
#include "libdda/solve/block_matrix.h"

namespace voussoir::step
{

/// Symmetric stiffness of every patch at the last evaluation. @param published spring states instead of tangents
template <class K>
void contact_stiffness(bool published, int threads, ContactStep<K>& step);

/// The same of one patch.
template <class K>
void patch_stiffness(bool published, const std::vector<PointStep<K::dimension>>& points, PatchStep<K>& patch);

/// Adds what the patch at the last evaluation does to one of its two blocks.
template <class K>
void add_block_stiffness(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points, bool of_a,
                         typename K::Square& stiffness);

/// Adds the stiffness of a patch to what a matrix has of its row a and of its row b, as asked for.
/// @param a, b rows of the matrix; -1: none
template <class K>
void add_patch_stiffness(const PatchStep<K>& patch, int a, int b, bool to_a, bool to_b, solve::BlockMatrix& matrix)
{
    using Block = Eigen::Map<typename K::Square>;
    if (to_a) Block(matrix.block(matrix.diagonal(a))) += patch.aa;
    if (to_b) Block(matrix.block(matrix.diagonal(b))) += patch.bb;
    if (a < 0 || b < 0) return;
    // The block between them is in the lower of the two rows.
    if (a > b ? to_a : to_b) {
        if (a > b)
            Block(matrix.block(matrix.position(a, b))) += patch.ab;
        else
            Block(matrix.block(matrix.position(b, a))) += patch.ab.transpose();
    }
}

}  // namespace voussoir::step
