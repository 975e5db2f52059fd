// How far a surface is from being convex with flat faces.
#pragma once

#include <vector>

#include "importers/exact/surface_checks.h"

namespace voussoir::importers::exact
{

struct Outlier {
    int vertex = -1, face = -1;
    double distance = 0;  // unit of the surface, along the face's outward normal
};

/// The vertex that lies farthest outside the plane of a face; vertex -1 when none lies outside any.
///
/// In plain doubles, relative to the face: the tolerance this is compared with is 1e9 times their rounding.
Outlier worst_outlier(const mesh::PolygonSurface& surface);

/// How far faces bulge [unit of the surface]: the largest distance of a corner from the plane through the middle
/// of its face, or of one of `points`, the corners before faces were merged, from the nearest plane.
double bulge_of(const mesh::PolygonSurface& surface, const std::vector<Eigen::Vector3d>& points);

/// Cuts every face whose corners lie more than `tolerance` off its plane into its triangles.
/// @returns one outlier per face that was cut, with the number of the face before
std::vector<Outlier> cut_bent_faces(mesh::PolygonSurface& surface, const SurfaceExamination& examination,
                                    double tolerance);

}  // namespace voussoir::importers::exact
