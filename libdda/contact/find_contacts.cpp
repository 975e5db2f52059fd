#include "libdda/contact/find_contacts.h"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>

#include "libdda/contact/broad_phase.h"
#include "libdda/contact/narrow_phase.h"
#include "libdda/contact/narrow_phase_planar.h"

namespace voussoir::contact
{

namespace
{

using PairKey = std::pair<int, int>;  // global part indices, ascending

template <int D>
History<D> history_of(const ContactSetIn<D>& old, const std::map<PairKey, int>& old_patches, const PairKey& key)
{
    const auto found = old_patches.find(key);
    if (found == old_patches.end()) return {};
    const ContactPatchIn<D>& patch = old.patches[found->second];
    return {&patch, std::span(old.points).subspan(patch.first_point, patch.point_count)};
}

/// The contact of two parts, with the history that goes with it, if they are close enough.
template <int D>
std::optional<FoundPatch<D>> find_patch(const Model& model, const State& state,
                                        const std::vector<bool>& fully_held,
                                        const std::vector<PlacedPartIn<D>>& parts,
                                        const std::vector<double>& reach, const PairKey& pair,
                                        const History<D>& history, NewOverlap overlap)
{
    const PlacedPartIn<D>& first = parts[pair.first];
    const PlacedPartIn<D>& second = parts[pair.second];
    std::optional<LastContact> last;
    if (history.patch)
        last = LastContact{history.patch->block_b == second.block, history.patch->edge_edge,
                           history.patch->feature_b, history.patch->feature_a};
    const double margin = reach[first.block] + reach[second.block];
    const std::optional<ContactPolygonIn<D>> polygon = contact_polygon(first, second, margin, last);
    if (!polygon) return std::nullopt;
    return attach_history(model, state, fully_held, first, second, *polygon, history, overlap);
}

}  // namespace

template <int D>
void find_contacts(const Model& model, const State& state, const std::vector<double>& reach, int threads,
                   std::vector<PlacedPartIn<D>>& parts, ContactSetIn<D>& found, NewOverlap overlap)
{
    place_parts(model, state, parts);
    std::vector<bool> fully_held(model.blocks.size(), false);
    for (const Foundation& foundation : model.foundations)
        if (foundation.fully_held()) fully_held[foundation.block] = true;
    std::vector<int> first_part(model.blocks.size() + 1, 0);
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        first_part[b + 1] = first_part[b] + static_cast<int>(ShapeIn<D>::of(model.blocks[b]).size());

    std::map<PairKey, int> old_patches;
    const ContactSetIn<D>& old = contacts_in<D>(state);
    for (int p = 0; p < static_cast<int>(old.patches.size()); ++p) {
        const ContactPatchIn<D>& patch = old.patches[p];
        const int a = first_part[patch.block_a] + patch.part_a, b = first_part[patch.block_b] + patch.part_b;
        old_patches[{std::min(a, b), std::max(a, b)}] = p;
    }

    const std::vector<PairKey> pairs = candidate_pairs(parts, reach, fully_held);
    std::vector<std::optional<FoundPatch<D>>> slots(pairs.size());
    std::exception_ptr failure;  // memory may run out in any thread, and no exception may leave the loop
#pragma omp parallel for num_threads(threads) schedule(static) if (pairs.size() > 256)
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        try {
            slots[i] = find_patch(model, state, fully_held, parts, reach, pairs[i],
                                  history_of(old, old_patches, pairs[i]), overlap);
        } catch (...) {
#pragma omp critical
            failure = std::current_exception();
        }
    }
    if (failure) std::rethrow_exception(failure);

    found.patches.clear();
    found.points.clear();
    for (std::optional<FoundPatch<D>>& slot : slots) {
        if (!slot) continue;
        slot->patch.first_point = static_cast<int>(found.points.size());
        slot->patch.point_count = static_cast<int>(slot->points.size());
        found.patches.push_back(slot->patch);
        found.points.insert(found.points.end(), slot->points.begin(), slot->points.end());
    }
}

template <int D>
double spring_energy(const Model& model, const ContactSetIn<D>& contacts)
{
    double energy = 0;
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        const double shear = model.joint_between(patch.block_a, patch.block_b).shear_to_normal_stiffness;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts.points[i];
            const double depth = patch.intact ? point.gap : std::min(point.gap, 0.0);
            energy +=
                0.5 * patch.stiffness * point.area * (depth * depth + shear * point.elastic_slip.squaredNorm());
        }
    }
    return energy;
}

#define VOUSSOIR_INSTANTIATE(D)                                                               \
    template void find_contacts(const Model&, const State&, const std::vector<double>&, int,  \
                                std::vector<PlacedPartIn<D>>&, ContactSetIn<D>&, NewOverlap); \
    template double spring_energy(const Model&, const ContactSetIn<D>&)
VOUSSOIR_INSTANTIATE(3);
VOUSSOIR_INSTANTIATE(2);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::contact
