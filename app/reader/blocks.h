// The part of a case that says which stones there are: `blocks`.
#pragma once

#include <filesystem>

#include "app/reader/initial_state.h"
#include "app/reader/yaml_cursor.h"
#include "importers/helper/stone_choice.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// Reads meshes (through the geometry helper, started only if there is one) and boxes into model.blocks,
/// model.groups and model.origin, and turns those that begin turned; model.materials must have been read. Refusals
/// and overlaps become faults, repairs become warnings.
/// @returns the mesh files that were read, as the case names them
std::vector<std::string> read_blocks(YamlCursor& top, const std::filesystem::path& folder,
                                     const std::vector<InitialEntry>& initial_state, Model& model,
                                     Findings& findings);

using importers::helper::matches_pattern;

}  // namespace voussoir::app::reader
