// The contacts at the start of a step, with their history attached.
#pragma once

#include <vector>

#include "libdda/contact/contact_history.h"

namespace voussoir::contact
{

/// Of a block's size: closer parts are candidates whatever their speed.
constexpr double contact_distance = 1e-3;

/// Finds all contacts of the state as it stands, with their history. @param reach (blocks) [m] how far a block may
/// move in the step, plus the contact distance
template <int D>
void find_contacts(const Model& model, const State& state, const std::vector<double>& reach, int threads,
                   std::vector<PlacedPartIn<D>>& parts, ContactSetIn<D>& found,
                   NewOverlap overlap = NewOverlap::presses);

/// Energy stored in the normal and shear springs [J].
template <int D>
double spring_energy(const Model& model, const ContactSetIn<D>& contacts);

}  // namespace voussoir::contact
