// Area, centroid and second moment of a plane polygon.
#pragma once

#include <Eigen/Core>
#include <span>

namespace voussoir
{

/// Of a convex polygon, whichever way its corners run.
struct PolygonMoments {
    double area = 0;                                     // m2
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  // m
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();    // m4, integral of (x - c)(x - c)^T, c the centroid

    /// @param corners at least one; what has no area has its centroid in the first corner
    explicit PolygonMoments(std::span<const Eigen::Vector2d> corners);
};

}  // namespace voussoir
