// The contacts of a state at rest, before any step.
#pragma once

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Finds the contacts of the state as it stands (gaps, areas, no forces): for `check` and the first frame.
void find_initial_contacts(const Model& model, State& state);

}  // namespace voussoir
