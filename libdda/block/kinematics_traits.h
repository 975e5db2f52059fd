// What the unknowns of a block do to its points: the only place where the kinematics of a scene enters the step.
//
// A step moves the material point at lever y (from the centroid, in the predicted configuration) by T(y) D, D the
// block's unknowns. Shi's twelve are translation u, rotation r and strain e (planar: u, v, r, ex, ey, gxy); here
// the last nine (four) are the displacement gradient L = skew(r) + e, the same numbers in another basis, in which
// points are linear in the unknowns, masses are simple and a rigid rotation makes no false strain. A rigid block
// has u and r alone. Source: docs/numerics.md 2.1.
#pragma once

#include <Eigen/Core>

#include "libdda/block/rotation.h"
#include "libdda/model/kinematics.h"

namespace voussoir::step
{

/// 12 unknowns, planar 6: u, then L column by column.
template <int D>
struct DeformableIn {
    static constexpr Kinematics kinematics =
        D == 2 ? Kinematics::planar_deformable : Kinematics::spatial_deformable;
    static constexpr bool deformable = true;
    static constexpr int dimension = D;
    static constexpr int unknowns = D + D * D;
    using Vector = VectorIn<D>;
    using Matrix = MatrixIn<D>;
    using Spin = SpinIn<D>;
    using Unknowns = Eigen::Matrix<double, unknowns, 1>;
    using Square = Eigen::Matrix<double, unknowns, unknowns>;

    /// L of the unknowns.
    static Matrix gradient(const Unknowns& d) { return Eigen::Map<const Matrix>(d.data() + D); }

    /// T(y) D = u + L y
    static Vector displacement(const Unknowns& d, const Vector& y)
    {
        Vector moved = d.template head<D>();
        for (int j = 0; j < D; ++j) moved += y[j] * d.template segment<D>(D + D * j);
        return moved;
    }
    /// forces += T(y)^T f
    static void add_force(Unknowns& forces, const Vector& y, const Vector& f)
    {
        forces.template head<D>() += f;
        for (int j = 0; j < D; ++j) forces.template segment<D>(D + D * j) += y[j] * f;
    }
    /// stiffness += T(ya)^T C T(yb): with w = (1, y) the blocks are w_i w_j C.
    static void add_stiffness(Square& stiffness, const Vector& ya, const Vector& yb, const Matrix& c)
    {
        for (int j = 0; j <= D; ++j)
            for (int i = 0; i <= D; ++i)
                stiffness.template block<D, D>(D * i, D * j) +=
                    (i == 0 ? 1 : ya[i - 1]) * (j == 0 ? 1 : yb[j - 1]) * c;
    }
    /// M of a block of mass m with second moment s (density included) about its centroid [kg, kg m2].
    static Square mass_matrix(double m, const Matrix& s)
    {
        Square mass = Square::Zero();
        mass.diagonal().template head<D>().setConstant(m);
        for (int j = 0; j < D; ++j)
            for (int k = 0; k < D; ++k)
                mass.template block<D, D>(D + D * j, D + D * k).diagonal().setConstant(s(j, k));
        return mass;
    }
    /// Moment about the centroid of a generalised force [Nm].
    static Spin moment_of(const Unknowns& forces) { return axial(gradient(forces)); }
};

/// 6 unknowns, planar 3: u, r.
template <int D>
struct RigidIn {
    static constexpr Kinematics kinematics = D == 2 ? Kinematics::planar_rigid : Kinematics::spatial_rigid;
    static constexpr bool deformable = false;
    static constexpr int dimension = D;
    static constexpr int spins = SpinIn<D>::SizeAtCompileTime;
    static constexpr int unknowns = D + spins;
    using Vector = VectorIn<D>;
    using Matrix = MatrixIn<D>;
    using Spin = SpinIn<D>;
    using Unknowns = Eigen::Matrix<double, unknowns, 1>;
    using Square = Eigen::Matrix<double, unknowns, unknowns>;

    static Matrix gradient(const Unknowns& d) { return skew(Spin(d.template tail<spins>())); }

    static Vector displacement(const Unknowns& d, const Vector& y)
    {
        if constexpr (D > 2)
            return d.template head<3>() + d.template tail<3>().cross(y);
        else
            return {d[0] - d[2] * y.y(), d[1] + d[2] * y.x()};
    }
    static void add_force(Unknowns& forces, const Vector& y, const Vector& f)
    {
        forces.template head<D>() += f;
        forces.template tail<spins>() += moment_about(y, f);
    }
    static void add_stiffness(Square& stiffness, const Vector& ya, const Vector& yb, const Matrix& c)
    {
        if constexpr (D > 2) {
            const Matrix c_yb = c * skew(yb), ya_skew = skew(ya);
            stiffness.template topLeftCorner<3, 3>() += c;
            stiffness.template topRightCorner<3, 3>() -= c_yb;
            stiffness.template bottomLeftCorner<3, 3>() += ya_skew * c;
            stiffness.template bottomRightCorner<3, 3>() -= ya_skew * c_yb;
        } else {
            const Vector turned_a(-ya.y(), ya.x()), turned_b(-yb.y(), yb.x());  // r x y per unit r
            stiffness.template topLeftCorner<2, 2>() += c;
            stiffness.template topRightCorner<2, 1>() += c * turned_b;
            stiffness.template bottomLeftCorner<1, 2>() += turned_a.transpose() * c;
            stiffness(2, 2) += turned_a.dot(c * turned_b);
        }
    }
    static Square mass_matrix(double m, const Matrix& s)
    {
        Square mass = Square::Zero();
        mass.diagonal().template head<D>().setConstant(m);
        mass.template bottomRightCorner<spins, spins>() = inertia_tensor(s);
        return mass;
    }
    static Spin moment_of(const Unknowns& forces) { return forces.template tail<spins>(); }
};

using SpatialDeformable = DeformableIn<3>;
using SpatialRigid = RigidIn<3>;
using PlanarDeformable = DeformableIn<2>;
using PlanarRigid = RigidIn<2>;

}  // namespace voussoir::step

/// Instantiates a macro for all kinematics.
#define VOUSSOIR_FOR_ALL_KINEMATICS(INSTANTIATE) \
    INSTANTIATE(SpatialDeformable);              \
    INSTANTIATE(SpatialRigid);                   \
    INSTANTIATE(PlanarDeformable);               \
    INSTANTIATE(PlanarRigid)
