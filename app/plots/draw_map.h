// Draws a map of coloured squares as a picture, with Cairo.
#pragma once

#include <filesystem>

#include "app/plots/diagram.h"

namespace voussoir::app::plots
{

/// @param figure with one map
/// @throws InputError when the file cannot be written
void draw_map(const Figure& figure, const std::filesystem::path& file);

}  // namespace voussoir::app::plots
