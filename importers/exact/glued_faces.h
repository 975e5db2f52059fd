// Which faces of parts lie against other parts.
#pragma once

#include <vector>

#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::importers::exact
{

/// Faces marked as glued of which other parts cover less than half are no longer: what lies open is touched by
/// other stones. @param parts of one stone, that do not overlap; @param tolerance [m] within which faces lie in a
/// plane
void free_uncovered_faces(std::vector<ConvexPolyhedron>& parts, double tolerance);

}  // namespace voussoir::importers::exact
