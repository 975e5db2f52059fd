// Integrals over a face of a block.
#pragma once

#include <vector>

#include "libdda/block/kinematics_traits.h"
#include "libdda/model/model.h"

namespace voussoir::step
{

/// A face in its block: points and weights that integrate cubics (planar) and quadratics (spatial) exactly.
template <int D>
struct FaceIn {
    /// Where the face is looked at.
    struct Point {
        VectorIn<D> lever;  // m, from the centroid
        double weight;      // m2
    };
    std::vector<Point> points;
    VectorIn<D> normal = VectorIn<D>::Zero();  // unit, outward
};

/// The face of a block that the map deforms.
FaceIn<3> face_of(const Model& model, const BlockFace& face, const Eigen::Matrix3d& map);
/// The same of a planar scene.
FaceIn<2> face_of(const Model& model, const BlockFace& face, const Eigen::Matrix2d& map);

/// Where the middle of a face is drawn [m].
template <int D>
Eigen::Vector3d middle_of(const Model& model, const BlockFace& face);

/// A tensor that is one thing along a unit normal and another across it.
template <int D>
MatrixIn<D> along_and_across(double along, double across, const VectorIn<D>& normal)
{
    const MatrixIn<D> n = normal * normal.transpose();
    return along * n + across * (MatrixIn<D>::Identity() - n);
}

}  // namespace voussoir::step
