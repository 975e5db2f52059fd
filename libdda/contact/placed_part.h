// Convex parts where they are now.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// A convex part in world coordinates, with what contact search asks of it.
struct PlacedPart {
    int block = 0, part = 0;
    const ConvexPolyhedron* shape = nullptr;  // topology
    std::vector<Eigen::Vector3d> vertices;    // m
    std::vector<Eigen::Vector3d> normals;     // unit, outward, per face
    Eigen::Vector3d lower, upper;             // m, bounding box
    double size = 0;                          // m, cube root of the reference volume

    double support(const Eigen::Vector3d& direction) const;  // max of direction . x over the vertices
};

/// All parts of all blocks, in order of block and part. Reuses the memory of `parts`.
void place_parts(const Model& model, const State& state, std::vector<PlacedPart>& parts);

}  // namespace voussoir
