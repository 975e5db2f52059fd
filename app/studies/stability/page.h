// docs/stability.md: the maps and what every scene is, written by `voussoir stability`.
#pragma once

#include <string>
#include <vector>

#include "app/studies/stability/runner.h"

namespace voussoir::app::studies::stability
{

/// @param command how the page was made, written at its head
/// @param pictures names of the maps that lie in `stability/NAME.png` beside the page
/// @param of_tables whether maps were left out, so that the page says how they are made
std::string stability_page(const std::vector<StabilityScene>& scenes, const std::vector<CellResult>& results,
                           const std::string& command, const std::vector<std::string>& pictures, bool of_tables);

}  // namespace voussoir::app::studies::stability
