// Where to cut a concave solid.
#pragma once

#include <vector>

#include "importers/exact/cut_solid.h"

namespace voussoir::importers::exact
{

/// An edge at which the solid is concave.
struct ReentrantEdge {
    Eigen::Vector3d from, to;      // m
    Eigen::Vector3d into_first;    // unit, within the first face, at right angles to the edge
    Eigen::Vector3d first_normal;  // unit, outward
    double angle = 0;              // rad, between the two faces through the solid: pi to 2 pi
    double weight = 1;             // how much a cut here is worth
};

/// Edges where a neighbour's corner stands out of a face's plane by more than `tolerance` [m]. The smaller of the
/// two ways to look counts, so that needles with a normal of rounding errors do not.
std::vector<ReentrantEdge> reentrant_edges(const TriangleSurface& surface, double tolerance);

/// Weights edges by length, angle and depth below the hull, for solids that are only approximated.
void weight_by_depth(std::vector<ReentrantEdge>& edges, const TriangleSurface& hull);

/// Planes through reentrant edges that leave no concavity at the edge, best first; at most `count`.
/// @param tolerance [m] below which a point lies in a plane
std::vector<CutPlane> cutting_planes(const TriangleSurface& surface, const std::vector<ReentrantEdge>& edges,
                                     double tolerance, std::size_t count);

}  // namespace voussoir::importers::exact
