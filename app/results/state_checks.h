// What must hold of a state that was read from a file before anything is computed from it.
#pragma once

#include "libdda/model/state.h"

namespace voussoir::app::results
{

/// Every patch has its points, every point a status that there is, and no count is negative or about to overflow.
bool is_sound(const State& state);

/// The state has a place and a velocity for every block of the model, an anchor for every foundation, and contacts
/// between parts that there are.
bool fits(const State& state, const Model& model);

}  // namespace voussoir::app::results
