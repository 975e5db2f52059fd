// Convex hulls without the small corners.
#pragma once

#include <vector>

#include "importers/exact/triangle_surface.h"

namespace voussoir::importers::exact
{

/// The hull of so many of a hull's vertices that none of the others lies outside it by more than `height` [m].
/// @param kept vertices that stay in any case, by their coordinates
TriangleSurface smoothed_hull(const TriangleSurface& hull, const std::vector<Eigen::Vector3d>& kept,
                              double height);

/// Vertices of the facets of a hull that look down, within 45 degrees: what it may stand on, upright or tilted.
std::vector<Eigen::Vector3d> underside_of(const TriangleSurface& hull);

}  // namespace voussoir::importers::exact
