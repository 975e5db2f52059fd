// The volume of a solid between planes.
#pragma once

#include <vector>

#include "importers/exact/cut_solid.h"

namespace voussoir::importers::exact
{

/// Volume of what of a closed, outward surface lies behind all planes [m3]. Cuts are closed by signed fans, whose
/// volumes add up to that of the cap whatever its shape: no cap is triangulated, and none can fail.
double clipped_volume(TriangleSurface surface, const std::vector<CutPlane>& planes);

}  // namespace voussoir::importers::exact
