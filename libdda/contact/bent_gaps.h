// Gaps of a face as the stones beside it bend, where contacts are found.
// Source: docs/faces.md, "Stones that bend".
#pragma once

#include <span>
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
        const auto [area, middle] = area_of(points);
        if (!(area > 0)) return;
        centre_ = middle;
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
        const double of_slips = couple(patch, points);
        return 0.5 * moment_.dot(slope_) + 0.5 * twist_ * of_slips * of_slips;
    }
    /// Turns the slips of what presses so that they keep the couple that they had. The stones twist far more than
    /// the joint does: slips that went over to other points would else change what they store.
    /// @param old patch and its points, of the last step
    void keep_couple(const ContactPatchIn<D>& old, std::span<const ContactPointIn<D>> old_points,
                     const ContactPatchIn<D>& patch, std::vector<ContactPointIn<D>>& points) const
    {
        if constexpr (twists<D>) {
            if (twist_ == 0) return;
            const auto presses = [&](const ContactPointIn<D>& p) { return p.gap < 0 || patch.intact; };
            const auto [area, middle] = area_of(points, presses);
            double second = 0;
            for (const ContactPointIn<D>& p : points)
                if (presses(p)) second += p.area * patch.normal.cross(p.position - middle).squaredNorm();
            const double stiffness = shear_ * patch.stiffness * second;  // Nm
            if (!(second > least_spread * area * area) || !(twist_ * stiffness > noticeable_twist)) return;
            const double turn = (couple(old, old_points) - couple(patch, points)) / stiffness;
            for (ContactPointIn<D>& p : points)
                if (presses(p)) p.elastic_slip += turn * patch.normal.cross(p.position - middle);
        }
    }
    /// Gap of a point as the stones are drawn [m].
    double drawn(const ContactPointIn<D>& p) const { return p.gap - slope_.dot(p.position - centre_); }
    /// What bending adds to the gap at a place [m].
    double added(const VectorIn<D>& place) const { return slope_.dot(place - centre_); }
    const VectorIn<D>& slope() const { return slope_; }

 private:
    static constexpr double least_spread = 1e-3;  // of the second moment of what presses, over its area squared

    BentGaps() = default;
    struct Area {
        double size = 0;                           // m2
        VectorIn<D> middle = VectorIn<D>::Zero();  // m
    };
    static bool any(const ContactPointIn<D>&) { return true; }
    /// Of the points that count.
    template <class Counts = decltype(any)>
    static Area area_of(std::span<const ContactPointIn<D>> points, const Counts& counts = any)
    {
        Area area;
        for (const ContactPointIn<D>& p : points) {
            if (!counts(p)) continue;
            area.size += p.area;
            area.middle += p.area * p.position;
        }
        if (area.size > 0) area.middle /= area.size;
        return area;
    }
    /// Of the shear of points about their own middle, by which the stones are twisted [Nm].
    double couple(const ContactPatchIn<D>& patch, std::span<const ContactPointIn<D>> points) const
    {
        double sum = 0;
        if constexpr (twists<D>) {
            const VectorIn<D> middle = area_of(points).middle;
            for (const ContactPointIn<D>& p : points)
                sum += shear_ * patch.stiffness * p.area *
                       patch.normal.cross(p.position - middle).dot(p.elastic_slip);
        }
        return sum;
    }

    MatrixIn<D> flexibility_ = MatrixIn<D>::Zero();
    double twist_ = 0, shear_ = 0;
    VectorIn<D> centre_ = VectorIn<D>::Zero(), moment_ = VectorIn<D>::Zero(), slope_ = VectorIn<D>::Zero();
};

}  // namespace voussoir::contact
