// Draws a scene off-screen by software.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "app/render/camera.h"
#include "app/render/color_map.h"
#include "app/render/scene.h"

namespace voussoir
{

/// Pixels as 0xAARRGGBB with premultiplied alpha, rows from the top; transparent where nothing was drawn.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};

/// A software OpenGL context of one size, drawn at twice the resolution and averaged.
class Drawing
{
 public:
    /// @throws InputError when the size is too large for the library
    Drawing(int width, int height);
    ~Drawing();
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;

    /// @param pixel size of one logical pixel (1 at a picture height of 900)
    Image draw(const Scene& scene, const Camera& camera, const ColorScale& scale, double pixel);

 private:
    struct Context;
    std::unique_ptr<Context> context_;
};

/// Colours of marks and of foundations, shared with the legend.
Rgb opened_color();
Rgb slid_color();
Rgb foundation_color();

}  // namespace voussoir
