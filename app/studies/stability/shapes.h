// Shapes and motions that several extreme scenes share.
#pragma once

#include <Eigen/Core>

#include "app/studies/stability/cell.h"
#include "libdda/geometry/convex_polyhedron.h"
#include "libdda/model/model.h"

namespace voussoir::stability
{

/// Block 1 of the scene slides for 1 s along x down a plane that dips by `angle` [degrees], which lies in the x-y
/// plane while gravity leans. It starts as a rigid block does: at rest with its friction mobilised. Error:
/// distance from g (sin a - mu cos a) t^2 / 2 at the end / that distance; of a block that must not slide, its
/// displacement since it stood at rest / its size.
/// @param friction coefficient
void run_down(const Model& model, double angle, double friction, double g, double time_step, CellRun& cell);

/// Eight faces, the six corners at `radius` [m] along the axes. @param scale factor along each axis
ConvexPolyhedron octahedron(const Eigen::Vector3d& centre, const Eigen::Vector3d& radius);

/// A pyramid with its broad end up: square sections of side `top` at z_top and of side `tip` at z_tip [m].
ConvexPolyhedron needle(const Eigen::Vector2d& place, double tip, double z_tip, double top, double z_top);

/// A square bar on edge: its section's diagonals, `across` long, are level and upright. @param axis 0 or 1: runs
/// along x or y; @param centre [m]; @param length [m]
ConvexPolyhedron bar_on_edge(const Eigen::Vector3d& centre, int axis, double length, double across);

}  // namespace voussoir::stability
