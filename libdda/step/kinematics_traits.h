// What the unknowns of a block do to its points: the only place where the kinematics of a scene enters the step.
//
// A step moves the material point at lever y (from the centroid, in the predicted configuration) by T(y) D, D the
// block's unknowns. Shi's twelve are translation u, rotation r and strain e; here the last nine are the
// displacement gradient L = skew(r) + e, the same nine numbers in another basis, in which points are linear in the
// unknowns, masses are simple and a rigid rotation makes no false strain. A rigid block has u and r alone.
#pragma once

#include <Eigen/Core>

#include "libdda/model/kinematics.h"

namespace voussoir
{

inline Eigen::Matrix3d skew(const Eigen::Vector3d& r)
{
    Eigen::Matrix3d m;
    m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return m;
}

/// Twice the axial vector of the antisymmetric part: axial(skew(r)) = 2 r, axial(f y^T) = y x f.
inline Eigen::Vector3d axial(const Eigen::Matrix3d& m)
{
    return {m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)};
}

/// 12 unknowns: u, then L column by column.
struct SpatialDeformable {
    static constexpr Kinematics kinematics = Kinematics::spatial_deformable;
    static constexpr bool deformable = true;
    static constexpr int unknowns = 12;
    using Unknowns = Eigen::Matrix<double, unknowns, 1>;
    using Square = Eigen::Matrix<double, unknowns, unknowns>;

    /// L of the unknowns.
    static Eigen::Matrix3d gradient(const Unknowns& d) { return Eigen::Map<const Eigen::Matrix3d>(d.data() + 3); }

    /// T(y) D = u + L y
    static Eigen::Vector3d displacement(const Unknowns& d, const Eigen::Vector3d& y)
    {
        return d.head<3>() + y[0] * d.segment<3>(3) + y[1] * d.segment<3>(6) + y[2] * d.segment<3>(9);
    }
    /// forces += T(y)^T f
    static void add_force(Unknowns& forces, const Eigen::Vector3d& y, const Eigen::Vector3d& f)
    {
        forces.head<3>() += f;
        forces.segment<3>(3) += y[0] * f;
        forces.segment<3>(6) += y[1] * f;
        forces.segment<3>(9) += y[2] * f;
    }
    /// stiffness += T(ya)^T C T(yb): with w = (1, y) the blocks are w_i w_j C.
    static void add_stiffness(Square& stiffness, const Eigen::Vector3d& ya, const Eigen::Vector3d& yb,
                              const Eigen::Matrix3d& c)
    {
        const double wa[4] = {1, ya[0], ya[1], ya[2]}, wb[4] = {1, yb[0], yb[1], yb[2]};
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) stiffness.block<3, 3>(3 * i, 3 * j) += wa[i] * wb[j] * c;
    }
    /// M of a block of mass m with second moment s (density included) about its centroid [kg, kg m2].
    static Square mass_matrix(double m, const Eigen::Matrix3d& s)
    {
        Square mass = Square::Zero();
        mass.diagonal().head<3>().setConstant(m);
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) mass.block<3, 3>(3 + 3 * j, 3 + 3 * k).diagonal().setConstant(s(j, k));
        return mass;
    }
    /// Moment about the centroid of a generalised force [Nm].
    static Eigen::Vector3d moment_of(const Unknowns& forces) { return axial(gradient(forces)); }
};

/// 6 unknowns: u, r.
struct SpatialRigid {
    static constexpr Kinematics kinematics = Kinematics::spatial_rigid;
    static constexpr bool deformable = false;
    static constexpr int unknowns = 6;
    using Unknowns = Eigen::Matrix<double, unknowns, 1>;
    using Square = Eigen::Matrix<double, unknowns, unknowns>;

    static Eigen::Matrix3d gradient(const Unknowns& d) { return skew(d.tail<3>()); }

    static Eigen::Vector3d displacement(const Unknowns& d, const Eigen::Vector3d& y)
    {
        return d.head<3>() + d.tail<3>().cross(y);
    }
    static void add_force(Unknowns& forces, const Eigen::Vector3d& y, const Eigen::Vector3d& f)
    {
        forces.head<3>() += f;
        forces.tail<3>() += y.cross(f);
    }
    static void add_stiffness(Square& stiffness, const Eigen::Vector3d& ya, const Eigen::Vector3d& yb,
                              const Eigen::Matrix3d& c)
    {
        const Eigen::Matrix3d c_yb = c * skew(yb), ya_skew = skew(ya);
        stiffness.topLeftCorner<3, 3>() += c;
        stiffness.topRightCorner<3, 3>() -= c_yb;
        stiffness.bottomLeftCorner<3, 3>() += ya_skew * c;
        stiffness.bottomRightCorner<3, 3>() -= ya_skew * c_yb;
    }
    static Square mass_matrix(double m, const Eigen::Matrix3d& s)
    {
        Square mass = Square::Zero();
        mass.diagonal().head<3>().setConstant(m);
        mass.bottomRightCorner<3, 3>() = s.trace() * Eigen::Matrix3d::Identity() - s;
        return mass;
    }
    static Eigen::Vector3d moment_of(const Unknowns& forces) { return forces.tail<3>(); }
};

}  // namespace voussoir
