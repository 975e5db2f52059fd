// Small faults of surfaces that have one cure.
#pragma once

#include <vector>

#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::exact
{

/// Drops faces that have the same corners as an earlier one, whatever their direction. @returns how many
int drop_repeated_faces(mesh::PolygonSurface& surface);

/// Drops triangles whose three corners lie on a line: the middle corner goes into the neighbour along the longest
/// side. @param faces numbers of faces without area; others than triangles are left
/// @returns the numbers of the faces that were dropped, the largest first
std::vector<int> drop_collinear_triangles(mesh::PolygonSurface& surface, const std::vector<int>& faces);

/// Where an open edge has another open edge's end on it (within `tolerance`, unit of the surface), that vertex
/// becomes a corner of its face: faces that met without sharing their corners then share them. @returns how many
int insert_corners_on_open_edges(mesh::PolygonSurface& surface, double tolerance);

}  // namespace voussoir::importers::exact
