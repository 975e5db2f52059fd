// Diagrams, drawn by the helper program voussoir-plot: voussoir itself does not load Cairo.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/plots/diagram.h"

namespace voussoir::app::plots
{

/// Is the helper program there? A build without rendering has none.
bool can_draw_figures();

/// Draws FOLDER/NAME.png of every figure; the folder is made if it is not there.
/// @returns the figures' names
/// @throws InputError when there is no helper or it fails
std::vector<std::string> draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder);

}  // namespace voussoir::app::plots
