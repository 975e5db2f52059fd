// Stiffness of the contacts at the last evaluation, patch by patch.
#pragma once

#include "libdda/step/contact_step.h"

namespace voussoir::step
{

/// Symmetric stiffness of every patch at the last evaluation. @param published spring states instead of tangents
template <class K>
void contact_stiffness(bool published, int threads, ContactStep<K>& step);

/// The same of one patch. @param brake of the shear stiffness, which sliding points keep
template <class K>
void patch_stiffness(bool published, double brake, const std::vector<PointStep<K::dimension>>& points,
                     PatchStep<K>& patch);

/// Adds what the patch at the last evaluation does to one of its two blocks.
template <class K>
void add_block_stiffness(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points, bool of_a,
                         typename K::Square& stiffness);

}  // namespace voussoir::step
