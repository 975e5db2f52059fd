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

/// A dome with its lantern: groups foundation, dome, front (the arch of a half dome), lantern.
/// @throws InputError with every parameter that makes no dome
Pattern dome_pattern(const Dome& dome, const std::string& prefix);

/// A cross vault with its ribs: groups foundation, vault, ribs.
/// @throws InputError with every parameter that makes no vault
Pattern cross_vault_pattern(const CrossVault& vault, const std::string& prefix);

}  // namespace voussoir::importers::patterns
