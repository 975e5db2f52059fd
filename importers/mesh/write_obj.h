// Mesh files out.
#pragma once

#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::mesh
{

/// OBJ text: one object per surface, the shortest decimals that read back to the same bits.
/// @param header lines written first as comments
std::string to_obj(const std::vector<PolygonSurface>& surfaces, const std::vector<std::string>& header);

}  // namespace voussoir::importers::mesh
