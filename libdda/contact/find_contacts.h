// The contacts at the start of a step, with their history attached.
#pragma once

#include <vector>

#include "libdda/contact/placed_part.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// What becomes of an overlap that no force has made: of a contact that goes over to another face, or is found
/// late.
enum class NewOverlap {
    presses,   // the contact springs push the stones apart
    forgiven,  // they store no more than before; what is too much is kept as the points' rest_gap until the stones
               // part
};

/// Finds all contacts of the state as it stands. Every point takes over the slip of the point of the same feature,
/// or of the nearest old point of its pair, or the pair's area-weighted mean, in this order; slips are projected
/// on the new tangent plane. @param reach (blocks) [m] how far a block may move in the step, plus the contact
/// distance
template <int D>
void find_contacts(const Model& model, const State& state, const std::vector<double>& reach, int threads,
                   std::vector<PlacedPartIn<D>>& parts, ContactSetIn<D>& found,
                   NewOverlap overlap = NewOverlap::presses);

/// Energy stored in the normal and shear springs [J].
template <int D>
double spring_energy(const Model& model, const ContactSetIn<D>& contacts);

}  // namespace voussoir
