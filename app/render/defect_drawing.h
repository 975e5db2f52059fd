// Draws stones and marks; stones that are seen through lie over the marks they hide.
#pragma once

#include "app/render/camera.h"
#include "app/render/canvas.h"
#include "app/render/defect_pictures.h"

namespace voussoir::app::render
{

/// @param area that the camera was made for; @param pixel size of one logical pixel
Image draw_defect(Canvas& canvas, const std::vector<PictureShape>& shapes, const DefectPicture& picture,
                  const Camera& camera, const PictureArea& area, double pixel);

}  // namespace voussoir::app::render
