// A solid cut in two by a plane.
#pragma once

#include <optional>
#include <vector>

#include "importers/exact/triangle_surface.h"

namespace voussoir::importers::exact
{

/// Where to cut.
struct CutPlane {
    Eigen::Vector3d anchor, normal;  // m; unit
    /// How far a point lies before the plane [m].
    double distance(const Eigen::Vector3d& x) const { return normal.dot(x - anchor); }
};

/// What a cut leaves on the two sides of its plane.
struct Halves {
    std::vector<TriangleSurface> behind, before;  // each connected piece for itself, with its cavities
};

/// Cuts a closed surface, and closes both sides. Vertices within `tolerance` [m] of the plane count as lying in
/// it, so that a cut through edges that are nearly in a plane makes no slivers; the pieces together have the
/// volume of the whole to `tolerance` times the area of the cut.
/// @returns nothing when the plane misses the solid or the cut is no sound region
std::optional<Halves> cut_solid(const TriangleSurface& solid, const CutPlane& plane, double tolerance);

}  // namespace voussoir::importers::exact
