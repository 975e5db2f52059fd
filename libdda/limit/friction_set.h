// The forces that a contact or a bar may bear, and the one among them that is nearest to a given force.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace voussoir::limit
{

/// N >= -tension and |T| <= cohesion + friction N, of a force N n + T. It contains no force and all of one's own.
struct FrictionSet {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, along which it presses
    double friction = 0, cohesion = 0, tension = 0;     // -, N, N; cohesion >= friction x tension
};

/// Along the axis from end a to end b pull on a up to `tension` and push up to `compression`, across it up to
/// `shear`, each by itself.
struct BarSet {
    Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit
    double tension = 0, compression = 0, shear = 0;   // N
};

/// The nearest force and how it follows the one that is given: the derivative, symmetric, between 0 and 1.
struct NearestForce {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Matrix3d derivative = Eigen::Matrix3d::Zero();
};

/// Where there are two derivatives it is one of them.
inline NearestForce nearest_force(const FrictionSet& set, const Eigen::Vector3d& given)
{
    const Eigen::Vector3d& n = set.normal;
    const double pressing = given.dot(n);
    const Eigen::Vector3d across = given - pressing * n;
    const double shear = across.norm();
    NearestForce nearest;
    if (pressing >= -set.tension && shear <= set.cohesion + set.friction * pressing) {
        nearest.force = given;
        nearest.derivative.setIdentity();
        return nearest;
    }
    const Eigen::Matrix3d in_plane = Eigen::Matrix3d::Identity() - n * n.transpose();
    const double least = std::max(0.0, set.cohesion - set.friction * set.tension);  // shear without pressure
    if (shear <= least) {                                                           // torn off
        nearest.force = across - set.tension * n;
        nearest.derivative = in_plane;
        return nearest;
    }
    const Eigen::Vector3d along = across / shear;
    const double slope = 1 + set.friction * set.friction;
    const double beside = (pressing + set.friction * (shear - set.cohesion)) / slope;  // N on the slanted side
    const double bound = beside > -set.tension ? set.cohesion + set.friction * beside : least;
    nearest.force = std::max(beside, -set.tension) * n + bound * along;
    nearest.derivative = bound / shear * (in_plane - along * along.transpose());
    if (beside > -set.tension) {
        const Eigen::Vector3d side = n + set.friction * along;
        nearest.derivative += side * side.transpose() / slope;
    }
    return nearest;
}

/// The same of a bar.
inline NearestForce nearest_force(const BarSet& set, const Eigen::Vector3d& given)
{
    const double along = given.dot(set.axis), kept = std::clamp(along, -set.compression, set.tension);
    const Eigen::Vector3d across = given - along * set.axis;
    const double shear = across.norm();
    const Eigen::Matrix3d in_plane = Eigen::Matrix3d::Identity() - set.axis * set.axis.transpose();
    NearestForce nearest;
    nearest.force = kept * set.axis;
    if (kept == along) nearest.derivative = set.axis * set.axis.transpose();
    if (shear <= set.shear) {
        nearest.force += across;
        nearest.derivative += in_plane;
    } else {
        const Eigen::Vector3d direction = across / shear;
        nearest.force += set.shear * direction;
        nearest.derivative += set.shear / shear * (in_plane - direction * direction.transpose());
    }
    return nearest;
}

}  // namespace voussoir::limit
