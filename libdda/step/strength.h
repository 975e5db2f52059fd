// Strength of bonded joints: what breaks, and when.
#pragma once

#include "libdda/step/contact_step.h"

namespace voussoir::step
{

/// Breaks the intact patch that most exceeds its strength on its linear stress field, if any.
/// @returns its index, or -1
template <class K>
int break_weakest_patch(const Model& model, const ContactSetIn<K::dimension>& contacts, ContactStep<K>& step);

}  // namespace voussoir::step
