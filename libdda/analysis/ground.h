// What the ground is in a model.
#pragma once

#include <vector>

#include "libdda/model/model.h"

namespace voussoir
{

/// Blocks that the ground holds: foundations, and those at which the model ends, once for each of their faces
/// there.
std::vector<int> blocks_held_by_ground(const Model& model);

/// Those of them whose mean motion is that of the ground: foundations; without any the blocks at which the model
/// ends.
std::vector<int> blocks_that_are_ground(const Model& model);

}  // namespace voussoir
