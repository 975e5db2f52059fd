// Fewer triangles for a surface.
#pragma once

#include <string>

#include "importers/exact/triangle_surface.h"

namespace voussoir::importers::exact
{

/// Collapses edges, the least noticed first, until at most `triangles` are left or no edge can go. Source:
/// [LindstromTurk1998], by CGAL.
/// @param surface closed, outward, every edge of two triangles @param name for messages
/// @throws InputError when shells touch in a vertex
TriangleSurface decimated(const TriangleSurface& surface, int triangles, const std::string& name);

}  // namespace voussoir::importers::exact
