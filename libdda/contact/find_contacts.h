// The contacts at the start of a step, with their history attached.
#pragma once

#include <utility>
#include <vector>

#include "libdda/contact/broad_phase.h"
#include "libdda/contact/contact_history.h"

namespace voussoir::contact
{

/// Of a block's size: closer parts are candidates whatever their speed.
constexpr double contact_distance = 1e-3;

/// The memory of a search, used again by the next.
template <int D>
struct SearchMemory {
    std::vector<PlacedPartIn<D>> parts;
    std::vector<bool> fully_held;                          // (blocks)
    std::vector<int> first_part;                           // (blocks + 1), of all parts
    std::vector<std::pair<std::pair<int, int>, int>> old;  // parts that touched, ascending, and their patch
    Candidates candidates;
    std::vector<FoundPatch<D>> found;        // (candidates) without points where parts are apart
    std::vector<const FoundPatch<D>*> kept;  // those with points
};

/// Finds all contacts of the state as it stands, with their history. @param reach (blocks) [m] how far a block may
/// move in the step, plus the contact distance
template <int D>
void find_contacts(const Model& model, const State& state, const std::vector<double>& reach, int threads,
                   SearchMemory<D>& memory, ContactSetIn<D>& found, NewOverlap overlap = NewOverlap::presses);

/// Energy stored in the normal and shear springs [J].
template <int D>
double spring_energy(const Model& model, const ContactSetIn<D>& contacts);

}  // namespace voussoir::contact
