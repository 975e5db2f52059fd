// The tangent of a point's shear force as its bound follows the normal force.
#pragma once

#include "libdda/forces/contact_step.h"
#include "libdda/forces/turning.h"

namespace voussoir::step
{

/// Tangent of the shear force of a point, less what the stiffness with the bound held has of it.
template <class K>
struct FrictionTangent {
    int row_a, row_b;                     // -1: no unknowns
    typename K::Vector lever_a, lever_b;  // m
    typename K::Matrix tangent;           // N/m, not symmetric
};

/// Whether the stiffness with the bound held leaves anything out.
template <int D>
bool follows_its_bound(const PointStep<D>& p)
{
    return p.bound > 0 && (p.status == ContactStatus::sliding || p.turns_round);
}

/// @param p as last evaluated, with the exact bound
template <class K>
FrictionTangent<K> friction_tangent(const PatchStep<K>& patch, const PointStep<K::dimension>& p)
{
    using Matrix = typename K::Matrix;
    const typename K::Vector& n = patch.normal;
    FrictionTangent<K> result{patch.row_a, patch.row_b, p.lever, patch.lever_b(p), Matrix()};
    // mu N falls by mu (-dN/dg) as the gap opens.
    const double bound_by_gap = -p.bound / p.normal * p.normal_tangent;
    if (!p.turns_round) {
        result.tangent = bound_by_gap / p.bound * p.shear * n.transpose();
        return result;
    }
    const TurningChange<K> change(patch, p);
    const Matrix ahead = p.heading * p.heading.transpose();
    const Matrix along = Matrix::Identity() - n * n.transpose();
    result.tangent = bound_by_gap * change.by_bound * n.transpose() + change.by_move - p.tangent_along * ahead -
                     p.tangent_across * (along - ahead);
    return result;
}

/// Displacement of a point of a block by its unknowns [m].
template <class K>
typename K::Vector displacement_of(const typename K::Unknowns& d, const typename K::Vector& lever)
{
    return d.template head<K::dimension>() + K::gradient(d) * lever;
}

/// Force that such a tangent gives for the unknowns of the two blocks; without unknowns a block moves nothing [N].
template <class K>
typename K::Vector shear_of(const FrictionTangent<K>& p, const Eigen::VectorXd& x)
{
    constexpr int n = K::unknowns;
    typename K::Vector apart = K::Vector::Zero();
    if (p.row_a >= 0) apart += displacement_of<K>(x.segment<n>(n * p.row_a), p.lever_a);
    if (p.row_b >= 0) apart -= displacement_of<K>(x.segment<n>(n * p.row_b), p.lever_b);
    return p.tangent * apart;
}

/// The same of all points of a patch of rigid blocks. Their levers from one block and from the other differ by one
/// vector, so that the motion of a relative to b, at a's centroid, moves them all.
template <class K>
struct PatchTangent {
    int row_a, row_b;            // -1: no unknowns
    typename K::Vector between;  // m, lever_b - lever_a of each point
    typename K::Square tangent;  // N/m, N, Nm; not symmetric
};

/// @param patch of which some point follows its bound
template <class K>
PatchTangent<K> patch_tangent(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points)
{
    static_assert(!K::deformable);
    PatchTangent<K> result{patch.row_a, patch.row_b, patch.between, K::Square::Zero()};
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        if (!follows_its_bound(points[i])) continue;
        const FrictionTangent<K> p = friction_tangent(patch, points[i]);
        K::add_stiffness(result.tangent, p.lever_a, p.lever_a, p.tangent);
    }
    return result;
}

/// Generalised force on a for the unknowns of the two blocks [N, Nm].
template <class K>
typename K::Unknowns shear_of(const PatchTangent<K>& p, const Eigen::VectorXd& x)
{
    constexpr int n = K::unknowns;
    typename K::Unknowns apart = K::Unknowns::Zero();
    if (p.row_a >= 0) apart = x.segment<n>(n * p.row_a);
    if (p.row_b >= 0) {
        typename K::Unknowns of_b = x.segment<n>(n * p.row_b);
        of_b.template head<K::dimension>() = K::displacement(of_b, p.between);
        apart -= of_b;
    }
    return p.tangent * apart;
}

/// Generalised forces that a part of the tangent gives on its two blocks.
template <class K>
typename K::Unknowns on_a(const FrictionTangent<K>& p, const typename K::Vector& shear)
{
    typename K::Unknowns force = K::Unknowns::Zero();
    K::add_force(force, p.lever_a, shear);
    return force;
}
template <class K>
typename K::Unknowns on_b(const FrictionTangent<K>& p, const typename K::Vector& shear)
{
    typename K::Unknowns force = K::Unknowns::Zero();
    K::add_force(force, p.lever_b, -shear);
    return force;
}
template <class K>
typename K::Unknowns on_a(const PatchTangent<K>& /*p*/, const typename K::Unknowns& shear)
{
    return shear;
}
template <class K>
typename K::Unknowns on_b(const PatchTangent<K>& p, const typename K::Unknowns& shear)
{
    typename K::Unknowns force = -shear;
    force.template head<K::dimension>().setZero();
    K::add_force(force, p.between, -shear.template head<K::dimension>());
    return force;
}

}  // namespace voussoir::step
