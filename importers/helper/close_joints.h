// Joints that are drawn as gaps, closed.
#pragma once

#include "importers/helper/geometry.h"

namespace voussoir::importers::helper
{

/// Moves facing faces of neighbouring stones that stand apart by at most `width` [m] to the middle between them,
/// as if the mortar belonged to the stones. A face that looks at several neighbours goes half the way to the
/// nearest; faces in one plane of a stone move together. Volumes and moments are those of the grown stones, and
/// every stone that grew says so among its repairs.
void close_joints(double width, ImportedMesh& mesh);

}  // namespace voussoir::importers::helper
