// Soft shade in creases, as at the foot of a stone that stands on the ground, from the depths of a picture alone.
#pragma once

#include <vector>

#include "app/render/camera.h"
#include "app/render/canvas.h"

namespace voussoir::app::render
{

/// The share of the light that arrives, in cells as those of `Depths`.
struct Shade {
    int width = 0, height = 0;
    std::vector<float> light;  // (height x width) 0 to 1, rows from the top
};

/// A place that lies deeper than the middle between two others, one on either side, is in a crease: they hide a
/// part of the sky from it. Flat faces stay as bright as they are, however they are seen, as do edges that stick
/// out; what stands far in front casts nothing. Source: [LuftColditzDeussen2006], the idea of a shade from depths
/// alone.
/// @param reach pixels, of the farthest places that are looked at
Shade crease_shade(const Depths& depths, const Camera& camera, double reach);

/// Darkens what is opaque. Marks are not quite, and keep their colours.
void darken(Image& image, const Shade& shade);

}  // namespace voussoir::app::render
