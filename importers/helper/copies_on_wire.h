// The places of copies as JSON, for the request to the helper program.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "importers/helper/placed_copy.h"

namespace voussoir::importers::helper
{

/// A list of maps with `linear` (columns), `offset` and `suffix`.
nlohmann::json copies_to_json(const std::vector<PlacedCopy>& copies);

/// @throws nlohmann::json::exception when it is no such list
std::vector<PlacedCopy> copies_from_json(const nlohmann::json& value);

}  // namespace voussoir::importers::helper
