// The finished picture of a defect: title, callouts with leaders, legend, what to do; written as PNG.
#pragma once

#include <filesystem>

#include "app/render/canvas.h"
#include "app/render/defect_pictures.h"

namespace voussoir::app::render
{

/// The part of a picture that is free for the drawing.
PictureArea defect_area(int width, int height);

/// @throws InputError when the file cannot be written
void write_defect_page(const Image& drawing, const DefectPicture& picture, const Camera& camera,
                       const std::filesystem::path& path);

/// Draws all pictures into a folder. @returns the files. @throws InputError when one cannot be written
std::vector<std::filesystem::path> draw_defect_pages(const DefectPictures& pictures,
                                                     const std::filesystem::path& folder);

}  // namespace voussoir::app::render
