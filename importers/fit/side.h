// The sides of a stone: what a mason would call a face of it, however many triangles it was drawn with.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::fit
{

/// A plane with directions of its own.
struct Frame {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m
    // Unit, right-handed; the normal points out of the stone.
    Eigen::Vector3d u = Eigen::Vector3d::UnitX(), v = Eigen::Vector3d::UnitY(), normal = Eigen::Vector3d::UnitZ();

    /// Distance over the plane [m].
    double height(const Eigen::Vector3d& x) const { return normal.dot(x - centre); }
};

/// Adjacent faces of a stone that bend by less than an edge of it.
struct Side {
    std::vector<int> faces;      // of the surface
    std::vector<int> corners;    // vertices on its boundary, ascending
    Frame plane;                 // as near as can be to its boundary
    double area = 0;             // m2
    double size = 0;             // m: the root of the area
    double bent_face = 0;        // m: how far a corner of one of its faces lies off the plane of that face
    double largest_off = 0;      // m: how far a vertex of it lies off that plane
    std::vector<double> weight;  // of each corner in `corners` [m2]: the side's area shared out by boundary length
};

/// The sides of a closed surface whose faces point outward, largest first. Faces join a side as long as they turn
/// from it by less than 25 degrees: a quad that is warped by a fifth of its length is one side still, two sides of
/// an octagonal drum are two.
std::vector<Side> sides_of(const mesh::PolygonSurface& surface);

/// A side that consists of these faces of a closed surface.
Side make_side(const mesh::PolygonSurface& surface, std::vector<int> faces);

/// The plane nearest to the boundary of a side whose vertices are elsewhere now; its normal points as it did.
Frame plane_of(const Side& side, const std::vector<Eigen::Vector3d>& vertices);

/// The triangles that stand for a face: its own when it has three corners, else those between its edges and the
/// mean of its corners, so that no diagonal is preferred. @returns three points each [m]
std::vector<Eigen::Matrix3d> triangles_of(const mesh::PolygonSurface& surface, int face);

/// A frame by its centre and normal; u and v are any.
Frame frame_of(const Eigen::Vector3d& centre, const Eigen::Vector3d& normal);

}  // namespace voussoir::importers::fit
