// A planar scene as it would stand in space.
#pragma once

#include "app/results/results_reader.h"

namespace voussoir
{

/// Prisms over the outlines of a planar mesh, from y = -thickness/2 to thickness/2.
/// @param outlines of dimension 2, the vertices of each face its own and in the order of its loop
SurfaceMesh extruded(const SurfaceMesh& outlines, double thickness);

/// The model with a mesh in space: of a planar scene the outlines extruded by its thickness.
RecordedModel in_space(RecordedModel model);

}  // namespace voussoir
