// The work of the geometry helper, in the process that calls it.
#pragma once

#include "importers/helper/geometry.h"

namespace voussoir::importers::helper
{

/// Reads every file, applies unit and up axis, moves all to one local origin, certifies every stone and looks
/// for overlaps between them. Refusals are in the answer. The origin is zero unless a coordinate exceeds 1e4 m;
/// then it is the middle of the bounding box of all meshes, in whole metres.
Geometry import_meshes(const std::vector<MeshRequest>& requests);

}  // namespace voussoir::importers::helper
