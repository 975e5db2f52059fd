// A closed triangle surface in plain doubles, and what is asked of it.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace voussoir::importers::exact
{

/// Triangles by vertex indices.
struct TriangleSurface {
    std::vector<Eigen::Vector3d> vertices;   // m
    std::vector<Eigen::Vector3i> triangles;  // counter-clockwise from outside
};

/// Twice the area times the unit normal.
Eigen::Vector3d normal_of(const TriangleSurface& surface, const Eigen::Vector3i& triangle);

double volume_of(const TriangleSurface& surface);  ///< Negative of a surface that is inside out [m3].
double area_of(const TriangleSurface& surface);    ///< Of all triangles [m2].

/// Of the bounding box.
double diagonal_of(const std::vector<Eigen::Vector3d>& vertices);

/// The convex hull of points by exact predicates (CGAL); no triangles when the points lie in a plane.
TriangleSurface convex_hull(const std::vector<Eigen::Vector3d>& points);

}  // namespace voussoir::importers::exact
