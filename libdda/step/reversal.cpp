#include "libdda/step/reversal.h"

#include <algorithm>
#include <cmath>

namespace voussoir::step
{

namespace
{

constexpr int max_passes = 4;
constexpr double at_rest = 1e-3;     // of the speed at the start: near enough to the reversal
constexpr double least_part = 0.01;  // of the step and of its braking: a smaller reversal is left where it is

/// How a joint slides.
struct Slide {
    double start = 0, end = 0;  // m/s, at the start and the end of the step along the direction of the start
    double force = 0;           // N, pressing at the start
    double braking = 0;         // m/s, what friction takes from the lighter block's speed in the step
};

/// Mass of the lighter of two blocks; a held one does not count [kg].
template <class K>
double lighter_mass(const BlockStep<K>& a, const BlockStep<K>& b)
{
    if (a.row < 0 || b.row < 0) return a.row < 0 ? b.mass : a.mass;
    return std::min(a.mass, b.mass);
}

/// Velocity of a material point of a block at the start of the step [m/s].
template <class K>
typename K::Vector start_velocity(const BlockStep<K>& block, const typename K::Vector& lever)
{
    if (block.rotation_held()) return block.start_velocity;
    return block.start_velocity + skew(block.start_spin) * lever;
}

/// The patch as a whole slid at the start when every point that pressed was sliding. Speeds are means weighted by
/// the friction bounds; the mean velocity over the step is displacement / h, so the end is twice that less the
/// start.
template <class K>
std::optional<Slide> slide_of(const ContactSetIn<K::dimension>& contacts, const StepSystem<K>& system, int k)
{
    using Vector = typename K::Vector;
    const auto& found = contacts.patches[k];
    const PatchStep<K>& patch = system.contacts.patches[k];
    const BlockStep<K>&a = system.blocks[found.block_a], &b = system.blocks[found.block_b];
    Vector start = Vector::Zero(), mean = Vector::Zero();
    double weight = 0;
    for (int i = patch.first; i < patch.first + patch.count; ++i) {
        if (contacts.points[i].gap >= 0) continue;
        if (contacts.points[i].status != ContactStatus::sliding) return std::nullopt;
        const PointStep<K::dimension>& p = system.contacts.points[i];
        const double share = p.normal_stiffness * -contacts.points[i].gap;
        const Vector relative = start_velocity(a, p.lever_a) - start_velocity(b, p.lever_b);
        start += share * relative;
        mean += share / system.h * p.displacement;
        weight += share;
    }
    if (weight == 0) return std::nullopt;
    start = (start - patch.normal.dot(start) * patch.normal) / weight;
    mean /= weight;
    const double speed = start.norm();
    if (speed == 0) return std::nullopt;
    const double braking = patch.friction * weight / lighter_mass(a, b) * system.h;
    return Slide{speed, 2 * mean.dot(start) / speed - speed, weight, braking};
}

/// The joint that turned round with the most momentum.
template <class K>
int worst_reversal(const ContactSetIn<K::dimension>& contacts, const StepSystem<K>& system)
{
    int worst = -1;
    double most = 0;
    for (int k = 0; k < static_cast<int>(contacts.patches.size()); ++k) {
        const auto slide = slide_of(contacts, system, k);
        if (!slide || slide->end >= 0) continue;
        if (std::min(slide->start, -slide->end) <= least_part * slide->braking || slide->braking == 0) continue;
        const double part = slide->start / (slide->start - slide->end);  // of the step, up to the reversal
        if (part < least_part || part > 1 - least_part) continue;
        const double size = slide->force * std::min(slide->start, -slide->end);
        if (size <= most) continue;
        most = size;
        worst = k;
    }
    return worst;
}

}  // namespace

template <class K>
std::optional<double> step_to_reversal(const ContactSetIn<K::dimension>& contacts, const StepSystem<K>& system,
                                       ReversalSearch& search)
{
    if (search.patch < 0) {
        search.patch = worst_reversal(contacts, system);
        if (search.patch < 0) return std::nullopt;
    }
    const auto slide = slide_of(contacts, system, search.patch);
    if (!slide) return std::nullopt;
    if (search.passes == 0) search.speed_before = slide->start;
    if (std::abs(slide->end) <= at_rest * slide->start || search.passes == max_passes) return std::nullopt;
    if (slide->end < 0) {
        search.after = system.h;
        search.speed_after = slide->end;
    } else {
        search.before = system.h;
        search.speed_before = slide->end;
    }
    ++search.passes;
    const double part = search.speed_before / (search.speed_before - search.speed_after);
    return search.before + part * (search.after - search.before);
}

#define VOUSSOIR_INSTANTIATE(K)                                                                              \
    template std::optional<double> step_to_reversal(const ContactSetIn<K::dimension>&, const StepSystem<K>&, \
                                                    ReversalSearch&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
