// A concave outline as convex ones.
#pragma once

#include <vector>

#include "importers/patterns/pattern.h"

namespace voussoir::importers::patterns
{

/// Convex outlines, counter-clockwise, that fill a simple one; they share whole sides and have no corners of
/// their own. @param outline in either order [m]
/// @throws InputError when the outline crosses itself or has no area
/// Source: [HertelMehlhorn1983], from triangles by clipping ears.
std::vector<std::vector<Point>> convex_outlines(const std::vector<Point>& outline);

}  // namespace voussoir::importers::patterns
