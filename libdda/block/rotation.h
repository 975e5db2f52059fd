// Spins, finite rotations and rotary inertia in space and in the plane.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "libdda/geometry/plane.h"

namespace voussoir::step
{

/// A spin: three components, in the plane one, from the first axis to the second.
template <int D>
using SpinIn = Eigen::Matrix<double, D == 2 ? 1 : D, 1>;

/// The matrix W with W y = r x y.
inline Eigen::Matrix3d skew(const SpinIn<3>& r)
{
    Eigen::Matrix3d m;
    m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return m;
}
inline Eigen::Matrix2d skew(const SpinIn<2>& r)
{
    Eigen::Matrix2d m;
    m << 0, -r[0], r[0], 0;
    return m;
}

/// Twice the axial vector of the antisymmetric part: axial(skew(r)) = 2 r, axial(f y^T) = y x f.
inline SpinIn<3> axial(const Eigen::Matrix3d& m)
{
    return {m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
}
inline SpinIn<2> axial(const Eigen::Matrix2d& m)
{
    return SpinIn<2>(m(1, 0) - m(0, 1));
}

/// The moment y x f of a force f at lever y.
inline SpinIn<3> moment_about(const Eigen::Vector3d& y, const Eigen::Vector3d& f)
{
    return y.cross(f);
}
inline SpinIn<2> moment_about(const Eigen::Vector2d& y, const Eigen::Vector2d& f)
{
    return SpinIn<2>(y.x() * f.y() - y.y() * f.x());
}

/// The velocity r x y of a point at lever y by a spin r.
inline Eigen::Vector3d velocity_by(const SpinIn<3>& r, const Eigen::Vector3d& y)
{
    return r.cross(y);
}
inline Eigen::Vector2d velocity_by(const SpinIn<2>& r, const Eigen::Vector2d& y)
{
    return {-r[0] * y.y(), r[0] * y.x()};
}

inline Eigen::Quaterniond quaternion_of(const SpinIn<3>& vector)
{
    const double angle = vector.norm();
    if (angle == 0) return Eigen::Quaterniond::Identity();
    const double half = 0.5 * angle;
    Eigen::Quaterniond q;
    q.w() = std::cos(half);
    q.vec() = std::sin(half) / angle * vector;
    return q;
}

/// The finite rotation by a vector [rad].
inline Eigen::Matrix3d rotation_by(const SpinIn<3>& vector)
{
    return quaternion_of(vector).toRotationMatrix();
}
inline Eigen::Matrix2d rotation_by(const SpinIn<2>& vector)
{
    return Eigen::Rotation2Dd(vector[0]).toRotationMatrix();
}

/// The rotation that done twice is this one, of less than half a turn.
inline Eigen::Matrix3d half_of(const Eigen::Matrix3d& rotation)
{
    Eigen::Quaterniond q(rotation);
    if (q.w() < 0) q.coeffs() = -q.coeffs();
    q.w() += 1;
    return q.normalized().toRotationMatrix();
}
inline Eigen::Matrix2d half_of(const Eigen::Matrix2d& rotation)
{
    return Eigen::Rotation2Dd(0.5 * std::atan2(rotation(1, 0), rotation(0, 0))).toRotationMatrix();
}

/// Rotary inertia of a body with second moment `spread` [kg m2]: tr(s) 1 - s, in the plane tr(s).
inline Eigen::Matrix3d inertia_tensor(const Eigen::Matrix3d& spread)
{
    return spread.trace() * Eigen::Matrix3d::Identity() - spread;
}
inline Eigen::Matrix<double, 1, 1> inertia_tensor(const Eigen::Matrix2d& spread)
{
    return Eigen::Matrix<double, 1, 1>(spread.trace());
}

/// The spin of a body with angular momentum `momentum` [Nms]. @param spread second moment [kg m2]
template <int D>
SpinIn<D> spin_of(const MatrixIn<D>& spread, const SpinIn<D>& momentum)
{
    if constexpr (D > 2)
        return inertia_tensor(spread).inverse() * momentum;
    else
        return momentum / spread.trace();
}

/// How a rigid block lies: a unit quaternion w, x, y, z, or an angle that counts whole turns.
template <int D>
struct OrientationIn;
template <>
struct OrientationIn<3> {
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    static OrientationIn read(const double* x) { return {Eigen::Quaterniond(x[0], x[1], x[2], x[3])}; }
    OrientationIn turned_by(const SpinIn<3>& vector) const { return {(quaternion_of(vector) * q).normalized()}; }
    Eigen::Matrix3d matrix() const { return q.toRotationMatrix(); }
    void write(double* x) const
    {
        x[0] = q.w();
        x[1] = q.x();
        x[2] = q.y();
        x[3] = q.z();
    }
};
template <>
struct OrientationIn<2> {
    double angle = 0;
    static OrientationIn read(const double* x) { return {x[0]}; }
    OrientationIn turned_by(const SpinIn<2>& vector) const { return {angle + vector[0]}; }
    Eigen::Matrix2d matrix() const { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }
    void write(double* x) const { x[0] = angle; }
};

}  // namespace voussoir::step
