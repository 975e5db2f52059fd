// Vectors of a scene's own dimension, and where a planar scene lies in space.
//
// A planar scene is a slice of constant thickness in the x-z plane: its first component is x, its second z, and y
// points out of it. Angles count from x to z, that is about -y.
#pragma once

#include <Eigen/Core>

namespace voussoir
{

/// A vector of the scene's dimension.
template <int D>
using VectorIn = Eigen::Matrix<double, D, 1>;
/// A square matrix of the scene's dimension.
template <int D>
using MatrixIn = Eigen::Matrix<double, D, D>;

/// The axis in space (0, 1, 2: x, y, z) of component `k`.
template <int D>
constexpr int axis_in_space(int k)
{
    return D == 3 ? k : 2 * k;
}

/// The components that the scene has.
template <int D>
VectorIn<D> from_space(const Eigen::Vector3d& v)
{
    if constexpr (D == 3)
        return v;
    else
        return {v.x(), v.z()};
}

/// The same of a matrix.
template <int D>
MatrixIn<D> from_space(const Eigen::Matrix3d& m)
{
    MatrixIn<D> own;
    for (int j = 0; j < D; ++j)
        for (int i = 0; i < D; ++i) own(i, j) = m(axis_in_space<D>(i), axis_in_space<D>(j));
    return own;
}

/// The vector in space: of a spatial scene it is that already.
inline Eigen::Vector3d to_space(const Eigen::Vector3d& v)
{
    return v;
}

/// Of a planar scene; y is 0.
inline Eigen::Vector3d to_space(const Eigen::Vector2d& v)
{
    return {v.x(), 0, v.y()};
}

/// A matrix of a planar scene in space. @param out_of_plane the yy component: 1 for a map, 0 for its rate
inline Eigen::Matrix3d to_space(const Eigen::Matrix2d& m, double out_of_plane)
{
    Eigen::Matrix3d space = Eigen::Matrix3d::Zero();
    space(1, 1) = out_of_plane;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) space(axis_in_space<2>(i), axis_in_space<2>(j)) = m(i, j);
    return space;
}

}  // namespace voussoir
