// Shapes given by their corners and faces.
#pragma once

#include <string>
#include <vector>

#include "app/reader/yaml_cursor.h"
#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::app::reader
{

/// `[{vertices: [[x, y, z], ...], faces: [[0, 1, 2], ...], glued: [0]}, ...]`, convex parts of one body. None,
/// with faults, when they cannot be used.
std::vector<ConvexPolyhedron> read_convex_parts(const YamlCursor& list, const std::string& name);

}  // namespace voussoir::app::reader
