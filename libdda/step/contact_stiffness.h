// Stiffness of the contacts at the last evaluation, patch by patch.
#pragma once

#include "libdda/step/contact_step.h"

namespace voussoir::step
{

/// Symmetric stiffness of every patch at the last evaluation. @param published spring states instead of tangents
template <class K>
void contact_stiffness(bool published, int threads, ContactStep<K>& step);

}  // namespace voussoir::step
