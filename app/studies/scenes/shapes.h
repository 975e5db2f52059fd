// Convex shapes beyond the box.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/geometry/convex_polyhedron.h"

namespace voussoir::app::studies::scenes
{

/// Eight faces, the six corners at `radius` [m] along the axes. @param scale factor along each axis
ConvexPolyhedron octahedron(const Eigen::Vector3d& centre, const Eigen::Vector3d& radius);

/// A pyramid with its broad end up: square sections of side `top` at z_top and of side `tip` at z_tip [m].
ConvexPolyhedron needle(const Eigen::Vector2d& place, double tip, double z_tip, double top, double z_top);

/// A square bar on edge: its section's diagonals, `across` long, are level and upright. @param axis 0 or 1: runs
/// along x or y; @param centre [m]; @param length [m]
ConvexPolyhedron bar_on_edge(const Eigen::Vector3d& centre, int axis, double length, double across);

/// A prism along x. @param section (n) corners (y, z) [m], counter-clockwise seen from +x; @param from, to [m]
ConvexPolyhedron prism(const std::vector<Eigen::Vector2d>& section, double from, double to);

}  // namespace voussoir::app::studies::scenes
