// A planar scene as it would stand in space.
#pragma once

#include "app/results/results_reader.h"

namespace voussoir::app::render
{

/// Prisms over the outlines of a planar mesh, from y = -thickness/2 to thickness/2.
/// @param outlines of dimension 2, the vertices of each face its own and in the order of its loop
results::SurfaceMesh extruded(const results::SurfaceMesh& outlines, double thickness);

/// The model with a mesh in space: of a planar scene the outlines extruded by its thickness.
results::RecordedModel in_space(results::RecordedModel model);

}  // namespace voussoir::app::render
