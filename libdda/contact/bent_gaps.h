// Gaps of a face as the stones beside it bend, where contacts are found.
// Source: docs/faces.md, "Stones that bend".
#pragma once

#include <vector>

#include "libdda/contact/placed_part.h"
#include "libdda/contact/stone_bending.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::contact
{

/// Gaps of a face as the stones beside it bend; of those that do not, as the stones are drawn.
template <int D>
class BentGaps
{
 public:
    static BentGaps none() { return BentGaps(); }
    BentGaps(const Model& model, const std::vector<bool>& fully_held, const PlacedPartIn<D>& incident,
             const PlacedPartIn<D>& reference, const ContactPatchIn<D>& patch,
             const std::vector<ContactPointIn<D>>& points)
    {
        if (patch.edge_edge || !is_deformable(model.kinematics)) return;
        double area = 0;
        for (const ContactPointIn<D>& p : points) {
            area += p.area;
            centre_ += p.area * p.position;
        }
        if (!(area > 0)) return;
        centre_ /= area;
        const HalfStone<D> a{incident.block, incident.pose.map, fully_held[incident.block]},
            b{reference.block, reference.pose.map, fully_held[reference.block]};
        flexibility_ = bending_flexibility(model, a, b, patch.normal, area);
        twist_ = twist_flexibility(model, a, b, patch.normal, area);
        shear_ = model.joint_between(a.block, b.block).shear_to_normal_stiffness;
    }
    /// Bends the stones: gaps become those that the springs feel.
    void bend(const ContactPatchIn<D>& patch, std::vector<ContactPointIn<D>>& points)
    {
        if (flexibility_.isZero(0)) return;
        const auto pressure = [&](const VectorIn<D>& slope) {
            MomentOf<D> sum;
            for (const ContactPointIn<D>& p : points) {
                const VectorIn<D> place = p.position - centre_;
                const double gap = p.gap + (slope - slope_).dot(place), stiffness = patch.stiffness * p.area;
                if (gap < 0 || patch.intact) sum.add(-stiffness * gap, stiffness, place);
            }
            return sum;
        };
        balance_moment(flexibility_, VectorIn<D>(VectorIn<D>::Zero()), 1, pressure, moment_);
        const VectorIn<D> change = flexibility_ * moment_ - slope_;
        for (ContactPointIn<D>& p : points) p.gap += change.dot(p.position - centre_);
        slope_ += change;
    }
    /// What is stored in the stones, which the shear of the points twists [J].
    double energy(const ContactPatchIn<D>& patch, const std::vector<ContactPointIn<D>>& points) const
    {
        if (flexibility_.isZero(0)) return 0;
        return 0.5 * moment_.dot(slope_) + twist_energy(patch, points);
    }
    /// Gap of a point as the stones are drawn [m].
    double drawn(const ContactPointIn<D>& p) const { return p.gap - slope_.dot(p.position - centre_); }
    /// What bending adds to the gap at a place [m].
    double added(const VectorIn<D>& place) const { return slope_.dot(place - centre_); }
    const VectorIn<D>& slope() const { return slope_; }

 private:
    BentGaps() = default;
    /// [J]
    double twist_energy(const ContactPatchIn<D>& patch, const std::vector<ContactPointIn<D>>& points) const
    {
        double couple = 0;
        if constexpr (twists<D>)
            for (const ContactPointIn<D>& p : points)
                couple += shear_ * patch.stiffness * p.area *
                          patch.normal.cross(p.position - centre_).dot(p.elastic_slip);
        return 0.5 * twist_ * couple * couple;
    }

    MatrixIn<D> flexibility_ = MatrixIn<D>::Zero();
    double twist_ = 0, shear_ = 0;
    VectorIn<D> centre_ = VectorIn<D>::Zero(), moment_ = VectorIn<D>::Zero(), slope_ = VectorIn<D>::Zero();
};

}  // namespace voussoir::contact
