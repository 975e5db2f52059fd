// A convex hull as a part of a stone.
#pragma once

#include <string>
#include <vector>

#include "importers/exact/cut_solid.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::exact
{

/// The hull with corners that are next to each other as one and nearly coplanar triangles as one face each; faces
/// that lie in one of `cuts` are marked as glued.
/// @param planarity share of `diagonal` [m] within which corners are one and faces flat
/// @throws InputError when the hull is too thin for that
ConvexPolyhedron part_of_hull(const TriangleSurface& hull, const std::vector<CutPlane>& cuts, double planarity,
                              double diagonal, const std::string& name);

}  // namespace voussoir::importers::exact
