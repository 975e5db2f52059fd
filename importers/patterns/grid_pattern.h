// Vaults of stones that share their joints, as patterns of convex parts.
#pragma once

#include "importers/patterns/imperfection.h"
#include "importers/patterns/stone_grid.h"
#include "importers/patterns/vaults.h"

namespace voussoir::importers::patterns
{

/// The stones of a grid. Those named support* are in group foundation, the others in `group`.
/// @param prefix of all names @throws InputError when a face is warped
Pattern pattern_of(const StoneGrid& grid, const std::string& prefix, const std::string& group);

}  // namespace voussoir::importers::patterns
