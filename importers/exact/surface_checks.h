// Questions about a surface that rounding must not answer: asked of CGAL, with its checks on in every build.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::exact
{

/// Turns faces so that neighbours run along their shared edge in opposite directions.
/// @returns false when no choice of directions does (a one-sided surface), or when shells touch in a vertex only;
/// the surface is then untouched
bool orient_consistently(mesh::PolygonSurface& surface);

/// What an examination found.
struct SurfaceExamination {
    std::vector<Eigen::Vector3i> triangles;           // of all faces, in the faces' direction
    std::vector<int> face_of_triangle;                // by triangle
    std::vector<int> faces_without_area;              // which have no triangles
    std::vector<std::pair<int, int>> crossing_faces;  // pairs that cut or overlap each other, each once
};

/// Triangulates and examines a surface with exact predicates (CGAL, Polygon Mesh Processing).
/// @pre every edge is used once in each direction
/// @throws InputError when CGAL itself refuses
SurfaceExamination examine(const mesh::PolygonSurface& surface);

}  // namespace voussoir::importers::exact
