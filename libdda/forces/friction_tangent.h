// The tangent of a point's shear force as its bound follows the normal force.
#pragma once

#include "libdda/forces/contact_step.h"
#include "libdda/forces/turning.h"

namespace voussoir::step
{

/// Tangent of the shear force of a point, less what the stiffness with the bound held has of it.
template <int D>
struct FrictionTangent {
    VectorIn<D> by_gap;   // N/m, as its bound follows the gap
    MatrixIn<D> by_move;  // N/m, beside that; not symmetric
};

/// Whether the stiffness with the bound held leaves anything out.
template <int D>
bool follows_its_bound(const PointStep<D>& p)
{
    return p.bound > 0 && (p.status == ContactStatus::sliding || p.turns_round);
}

/// @param p as last evaluated, with the exact bound
template <class K>
FrictionTangent<K::dimension> friction_tangent(const PatchStep<K>& patch, const PointStep<K::dimension>& p)
{
    using Matrix = typename K::Matrix;
    const typename K::Vector& n = patch.normal;
    // mu N falls by mu (-dN/dg) as the gap opens.
    const double bound_by_gap = -p.bound / p.normal * p.normal_tangent;
    if (!p.turns_round) return {bound_by_gap / p.bound * p.shear, Matrix::Zero()};
    const TurningChange<K> change(patch, p);
    const Matrix ahead = p.heading * p.heading.transpose();
    const Matrix along = Matrix::Identity() - n * n.transpose();
    return {bound_by_gap * change.by_bound,
            change.by_move - p.tangent_along * ahead - p.tangent_across * (along - ahead)};
}

/// The same of all points of a patch. Their levers from one block and from the other differ by one vector, so that
/// the motion of a relative to b, at a's centroid, moves them all.
template <class K>
struct PatchTangent {
    int row_a, row_b;            // -1: no unknowns
    typename K::Vector between;  // m, lever_b - lever_a of each point
    typename K::Square tangent;  // N/m, N, Nm; not symmetric
};

/// How far the gaps of a patch open as its stones bend, by the unknowns of a relative to b.
template <class K>
class BendingOfGaps
{
 public:
    BendingOfGaps(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points)
        : centre_(patch.stones.centre)
    {
        contact::MomentOf<K::dimension> sum;
        for (int i = patch.first; i < patch.first + patch.count; ++i) {
            const PointStep<K::dimension>& p = points[i];
            const typename K::Vector place = p.lever - centre_;
            typename K::Unknowns opening = K::Unknowns::Zero();
            K::add_force(opening, p.lever, patch.normal);
            moment_ += p.normal_tangent * place * opening.transpose();
            sum.add(0, p.normal_tangent, place);
        }
        const auto& bending = patch.stones.bending;
        turn_ = -contact::give_of(bending.flexibility, bending.end_weight(), sum.second) * moment_;
    }
    /// By the unknowns, of a point [m].
    typename K::Unknowns at(const PointStep<K::dimension>& p) const
    {
        return turn_.transpose() * (p.lever - centre_);
    }

 private:
    using Moments = Eigen::Matrix<double, K::dimension, K::unknowns>;
    typename K::Vector centre_;
    Moments moment_ = Moments::Zero(), turn_;
};

/// @param patch of which some point follows its bound
template <class K>
PatchTangent<K> patch_tangent(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points)
{
    PatchTangent<K> result{patch.row_a, patch.row_b, patch.between, K::Square::Zero()};
    const auto each = [&](const auto& add) {
        for (int i = patch.first; i < patch.first + patch.count; ++i)
            if (follows_its_bound(points[i])) add(points[i], friction_tangent(patch, points[i]));
    };
    each([&](const auto& p, const auto& tangent) {
        K::add_stiffness(result.tangent, p.lever, p.lever,
                         typename K::Matrix(tangent.by_gap * patch.normal.transpose() + tangent.by_move));
    });
    if constexpr (K::deformable) {
        if (!patch.stones.acts) return result;
        const BendingOfGaps<K> bent(patch, points);
        each([&](const auto& p, const auto& tangent) {
            typename K::Unknowns force = K::Unknowns::Zero();
            K::add_force(force, p.lever, tangent.by_gap);
            result.tangent += force * bent.at(p).transpose();
        });
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

/// Generalised forces that it gives on its two blocks.
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
