// Floors, roofs and fill that load stones and move with them.
#pragma once

#include "app/reader/yaml_cursor.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

/// `attached_masses: [{blocks: "south_c09_*", mass: 500 kg, at: top}]`: adds to each matching block `mass`, or its
/// equal share of `total`, at its centroid (the default), at its `top` above the centroid, or at a point [x, y, z]
/// of its own. Blocks and, in a planar scene, the thickness must have been read.
void read_attached_masses(YamlCursor& top, Model& model);

}  // namespace voussoir::app::reader
