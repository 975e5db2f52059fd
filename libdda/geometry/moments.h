// Volume and moments of polyhedra by exact simplex integration.
#pragma once

#include <Eigen/Core>
#include <span>

#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir
{

/// Volume, centroid and second moment of a shape, of density one.
struct Moments {
    double volume = 0;                                   // m3
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  // m
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();    // integral of (x-c)(x-c)^T about the centroid, m5
};

/// Exact for polyhedra: each outward triangle (p,q,r) seen from a vertex of the shape contributes the moments of
/// its tetrahedron. A vertex is subtracted first, so that large coordinates cancel nothing.
/// Source: [Shi1988] (simplex integration); docs/numerics.md 2.2.
Moments moments_of(const ConvexPolyhedron& shape);

/// Sums of parts about their common centroid (the glued block).
Moments moments_of(std::span<const ConvexPolyhedron> parts);

/// The same for a closed, outward-oriented triangle surface that need not be convex.
Moments moments_of_surface(std::span<const Eigen::Vector3d> vertices, std::span<const Eigen::Vector3i> triangles);

}  // namespace voussoir
