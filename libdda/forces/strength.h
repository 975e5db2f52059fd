// Strength of bonded joints: what breaks, and when.
#pragma once

#include <optional>

#include "libdda/forces/contact_step.h"

namespace voussoir::step
{

/// Breaks the intact patch that most exceeds its strength on its linear stress field: another structure, which has
/// not been iterated on yet. Any number may break in a step.
/// @returns what it had stored in tension [J]; nothing if none broke
template <class K>
std::optional<double> break_weakest_joint(const Model& model, const ContactSetIn<K::dimension>& contacts,
                                          ContactStep<K>& step);

}  // namespace voussoir::step
