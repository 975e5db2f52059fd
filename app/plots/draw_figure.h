// Draws a row of diagrams as one picture, with Cairo.
#pragma once

#include <filesystem>

#include "app/plots/diagram.h"

namespace voussoir::app::plots
{

/// @throws InputError when the file cannot be written
void draw_figure(const Figure& figure, const std::filesystem::path& file);

}  // namespace voussoir::app::plots
