// The colours of pictures of defects, shared by drawing and legend.
#pragma once

#include "app/drawing/color_map.h"
#include "app/render/defect_pictures.h"

namespace voussoir::app::render
{

struct LookColor {
    drawing::Rgb color;
    float opacity;  // 1: not seen through
};

LookColor color_of(StoneLook look);
drawing::Rgb color_of(MarkLook look);

}  // namespace voussoir::app::render
