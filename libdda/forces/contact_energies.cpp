// What the contacts of an accepted step have stored, lost and rubbed away.
#include <algorithm>

#include "libdda/forces/contact_step.h"
#include "libdda/forces/turning.h"

namespace voussoir::step
{

template <class K>
typename K::Vector slip_at_end(const PatchStep<K>& patch, const PointStep<K::dimension>& p)
{
    using Vector = typename K::Vector;
    if (p.turns_round) return slip_after_turning(patch, p);
    if (p.status == ContactStatus::locked)
        return p.slip_start + tangential(patch.displacement.at(p.lever), patch.normal);
    if (p.status == ContactStatus::open) return Vector::Zero();
    // Of a published step this is not p.shear, the load it was solved with, but the load of the pass to come.
    // Where friction is more than the spring gives the rest is rubbed away: the spring is stretched by the way
    // only.
    const Vector shear = std::min(1.0, p.bound / p.trial.norm()) * p.trial;
    const double theta = p.shear_blend;
    return (shear / p.shear_stiffness - 0.5 * (1 - theta) * p.slip_start) * (2 / (1 + theta));
}

template <class K>
double energy_of_stones(const PatchStep<K>& patch, const std::vector<PointStep<K::dimension>>& points)
{
    if constexpr (K::deformable) {
        const auto& stones = patch.stones;
        if (!stones.acts) return 0;
        double couple = 0;  // Nm
        if constexpr (contact::twists<K::dimension>)
            for (int i = patch.first; i < patch.first + patch.count; ++i)
                couple += points[i].shear_stiffness *
                          patch.normal.cross(points[i].lever - stones.centre).dot(slip_at_end(patch, points[i]));
        return stones.bending.energy() + 0.5 * (couple * (stones.twist.flexibility(0, 0) * couple));
    }
    return 0;
}

namespace
{

/// Whether the friction of a point is not what its spring gives: it slides on with more, or turns round and has
/// the mean of both ways, of which the springs of the two ends say nothing.
template <int D>
bool rubs_beyond_spring(const PointStep<D>& p)
{
    if (p.turns_round) return true;
    return p.status == ContactStatus::sliding && p.speed > 0 && p.trial.norm() < p.bound;
}

}  // namespace

template <class K>
ContactEnergies contact_energies(int threads, const ContactStep<K>& step)
{
    const auto add_point = [](const PatchStep<K>& patch, const PointStep<K::dimension>& p, ContactEnergies& sum) {
        using Vector = typename K::Vector;
        const double depth_0 = patch.intact ? p.gap_start : std::min(p.gap_start, 0.0);
        const double depth_1 = patch.intact ? p.gap : std::min(p.gap, 0.0);
        const double normal_start = 0.5 * p.normal_stiffness * depth_0 * depth_0;
        const double normal_end = 0.5 * p.normal_stiffness * depth_1 * depth_1;
        const double closing = p.gap_start - p.gap;
        const Vector slip = slip_at_end(patch, p);
        const Vector elastic = slip - p.slip_start;
        const Vector move = tangential(patch.displacement.at(p.lever), patch.normal);
        const double shear_start = 0.5 * p.shear_stiffness * p.slip_start.squaredNorm();
        const double shear_end = 0.5 * p.shear_stiffness * slip.squaredNorm();
        sum.stored += normal_end + shear_end;
        sum.dashpot += (p.normal - p.elastic_normal) * closing;
        sum.friction += p.shear.dot(move - elastic);
        // What closes or opens within the step is pressed for a part of it only, of which the law knows the end.
        const bool switches = !patch.intact && (p.gap_start < 0) != (p.gap < 0);
        double& loss = switches ? sum.closing : sum.loss;
        loss += p.elastic_normal * closing - (normal_end - normal_start);
        // Rubbed away where friction is not what the spring gives, else lost.
        (rubs_beyond_spring(p) ? sum.friction : loss) += p.shear.dot(elastic) - (shear_end - shear_start);
    };
    ContactEnergies sum;
    add_patches_in_order(
        step, threads,
        [&](std::size_t k) {
            const PatchStep<K>& patch = step.patches[k];
            ContactEnergies share;
            for (int i = patch.first; i < patch.first + patch.count; ++i) add_point(patch, step.points[i], share);
            if constexpr (K::deformable) {
                const double stored = energy_of_stones(patch, step.points);
                share.stored += stored;
                share.loss += patch.stones.work() - (stored - patch.stones.energy_start);
            }
            return share;
        },
        [&](const ContactEnergies& share) {
            sum.stored += share.stored;
            sum.dashpot += share.dashpot;
            sum.friction += share.friction;
            sum.loss += share.loss;
            sum.closing += share.closing;
        });
    return sum;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                         \
    template ContactEnergies contact_energies(int, const ContactStep<K>&);                              \
    template double energy_of_stones(const PatchStep<K>&, const std::vector<PointStep<K::dimension>>&); \
    template K::Vector slip_at_end(const PatchStep<K>&, const PointStep<K::dimension>&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
