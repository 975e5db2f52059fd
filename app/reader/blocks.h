// The part of a case that says which stones there are: `blocks`.
#pragma once

#include <filesystem>

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// Reads meshes (through the geometry helper, started only if there is one) and boxes into model.blocks,
/// model.groups and model.origin; model.materials must have been read. Refusals and overlaps become faults,
/// repairs become warnings.
/// @returns the mesh files that were read, as the case names them
std::vector<std::string> read_blocks(YamlCursor& top, const std::filesystem::path& folder, Model& model,
                                     Findings& findings);

/// Does a name match a pattern in which * stands for any letters and ? for one?
bool matches_pattern(std::string_view name, std::string_view pattern);

}  // namespace voussoir::app::reader
