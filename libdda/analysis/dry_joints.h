// Joints that were given strength and have none.
#pragma once

#include <optional>

#include "libdda/model/diagnosis.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// A warning when stones meet that a joint with cohesion or tensile strength should bond, but gape at a corner:
/// such joints are dry from the start, and the user may not know it.
/// @param start the state in which the run begins; nothing is said of one that has gone on
std::optional<Diagnosis> dry_joints_warning(const Model& model, const State& start);

}  // namespace voussoir
