// What a stage lets its steps do.
#pragma once

#include "libdda/contact/contact_history.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::step
{

/// What a step makes of overlaps that no force has made.
contact::NewOverlap new_overlaps_in(const Model& model, const Stage& stage, const State& state);

/// Whether a step may end before its stones land. @param moving blocks that have unknowns
bool may_divide(const Stage& stage, int moving);

/// Whether stones that land do it by impulses, where their joints have a law for it. With the integrator of the
/// papers impacts are left to the springs, as in the papers.
bool stones_land(const Stage& stage);

}  // namespace voussoir::step
