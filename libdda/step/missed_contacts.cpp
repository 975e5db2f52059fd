#include "libdda/step/missed_contacts.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <utility>

#include "libdda/model/parallel.h"

namespace voussoir::step
{

namespace
{

/// Displacement over the step of the point at `lever` from the centroid at its start [m].
template <class K>
typename K::Vector displacement(const StepProblem<K>& problem, int block, const typename K::Vector& lever)
{
    const BlockStep<K>& step = problem.blocks[block];
    const typename K::Vector turned = step.predicted.map * step.start.map.inverse() * lever;
    typename K::Vector moved = step.predicted.centroid - step.start.centroid + turned - lever;
    if (step.row >= 0)
        moved += K::displacement(problem.d.template segment<K::unknowns>(K::unknowns * step.row), turned);
    return moved;
}

/// No point of the block moved farther in the step than this [m].
template <class K>
double farthest(const StepProblem<K>& problem, int block, double radius)
{
    const BlockStep<K>& step = problem.blocks[block];
    typename K::Vector moved = step.predicted.centroid - step.start.centroid;
    double turned = (step.predicted.map - step.start.map).norm();
    if (step.row >= 0) {
        const typename K::Unknowns d = problem.d.template segment<K::unknowns>(K::unknowns * step.row);
        moved += d.template head<K::dimension>();
        turned += (K::gradient(d) * step.predicted.map).norm();
    }
    // Of the difference of two rotations no vector grows by more than its Frobenius norm over the root of two.
    constexpr bool is_rigid = K::unknowns < K::dimension * (1 + K::dimension);
    return moved.norm() + (is_rigid ? std::numbers::sqrt2 / 2 : 1) * turned * radius;
}

using PartOfBlock = std::pair<int, int>;

template <int D>
std::pair<PartOfBlock, PartOfBlock> parts_of(const ContactPatchIn<D>& patch)
{
    return std::minmax({PartOfBlock(patch.block_a, patch.part_a), PartOfBlock(patch.block_b, patch.part_b)});
}

template <int D>
std::vector<std::pair<PartOfBlock, PartOfBlock>> pairs_in(const ContactSetIn<D>& contacts)
{
    std::vector<std::pair<PartOfBlock, PartOfBlock>> pairs;
    for (const ContactPatchIn<D>& patch : contacts.patches) pairs.push_back(parts_of(patch));
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace

template <class K>
bool misses_a_contact(const Model& model, const State& state, const StepProblem<K>& problem,
                      const ContactSetIn<K::dimension>& contacts, const std::vector<Extent>& extents,
                      const std::vector<double>& reach, int threads)
{
    constexpr int D = K::dimension;
    std::atomic<bool> any = false;
    in_parallel(reach.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t b = first; b < end; ++b)
            if (!(farthest(problem, static_cast<int>(b), extents[b].radius) <= reach[b])) any = true;
    });
    if (!any) return false;
    std::vector<double> went = reach;
    for (std::size_t b = 0; b < reach.size(); ++b) {
        const double moved = farthest(problem, static_cast<int>(b), extents[b].radius);
        if (!(moved <= reach[b])) went[b] = moved;
    }
    contact::SearchMemory<D> memory;
    ContactSetIn<D> all;
    contact::find_contacts(model, state, went, threads, memory, all);
    const auto known = pairs_in(contacts);
    for (const ContactPatchIn<D>& patch : all.patches) {
        if (std::binary_search(known.begin(), known.end(), parts_of(patch))) continue;
        const double allowed =
            -contact::contact_distance * std::min(size_of(model, patch.block_a), size_of(model, patch.block_b));
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const VectorIn<D>& place = all.points[i].position;
            const auto moved = [&](int block) {
                return displacement(problem, block, VectorIn<D>(place - problem.blocks[block].start.centroid));
            };
            if (all.points[i].gap + patch.normal.dot(moved(patch.block_a) - moved(patch.block_b)) < allowed)
                return true;
        }
    }
    return false;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                   \
    template bool misses_a_contact(const Model&, const State&, const StepProblem<K>&,             \
                                   const ContactSetIn<K::dimension>&, const std::vector<Extent>&, \
                                   const std::vector<double>&, int)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
