// Draws a scene off-screen by software.
#pragma once

#include "app/drawing/color_map.h"
#include "app/render/camera.h"
#include "app/render/canvas.h"
#include "app/render/scene.h"

namespace voussoir::app::render
{

/// Draws scenes of one size.
class Drawing
{
 public:
    /// @throws InputError when the size is too large for the library
    Drawing(int width, int height);

    /// Of the pictures, in pixels.
    int width() const { return canvas_.width() / Canvas::supersampling; }
    int height() const { return canvas_.height() / Canvas::supersampling; }

    /// @param pixel size of one logical pixel (1 at a picture height of 900)
    Image draw(const Scene& scene, const Camera& camera, const drawing::ColorScale& scale, double pixel);

 private:
    Canvas canvas_;
};

/// Colours of marks and of foundations, shared with the legend.
drawing::Rgb opened_color();
drawing::Rgb slid_color();
drawing::Rgb foundation_color();
drawing::Rgb force_color();
drawing::Rgb blank_color();  // of stones without a value

}  // namespace voussoir::app::render
