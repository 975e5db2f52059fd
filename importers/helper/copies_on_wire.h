// The places of copies as JSON text, for the request to the helper program.
#pragma once

#include <string>
#include <vector>

#include "importers/helper/placed_copy.h"

namespace voussoir::importers::helper
{

/// A list of maps with `linear` (columns), `offset` and `suffix`.
std::string copies_to_json(const std::vector<PlacedCopy>& copies);

/// @throws std::exception when it is no such list
std::vector<PlacedCopy> copies_from_json(const std::string& text);

}  // namespace voussoir::importers::helper
