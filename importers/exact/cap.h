// The flat face that closes a cut.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "importers/exact/triangle_surface.h"

namespace voussoir::importers::exact
{

/// Directed edges, with how often each occurs.
using DirectedEdges = std::map<std::pair<int, int>, int>;

/// Fills the flat region to the left of directed edges, seen against `normal`, with triangles (constrained
/// Delaunay triangulation by CGAL, regions told apart by their winding number).
/// @param normal out of the solid, any length @returns false when the edges bound no region: they cross, or two of
/// their ends coincide
bool fill_cap(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& normal,
              const DirectedEdges& edges, std::vector<Eigen::Vector3i>& triangles);

}  // namespace voussoir::importers::exact
