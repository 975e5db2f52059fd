#include "libdda/contact/find_contacts.h"

#include <algorithm>
#include <map>
#include <optional>

#include "libdda/contact/broad_phase.h"
#include "libdda/contact/narrow_phase.h"
#include "libdda/contact/narrow_phase_planar.h"
#include "libdda/model/parallel.h"

namespace voussoir::contact
{

namespace
{

using PairKey = std::pair<int, int>;  // global part indices, ascending

std::optional<ContactPolygon> polygon_between(const PlacedPart& first, const PlacedPart& second, double margin,
                                              const std::optional<LastContact>& last, double fit_tolerance)
{
    return contact_polygon(first, second, margin, last, fit_tolerance);
}

std::optional<ContactSegment> polygon_between(const PlacedOutline& first, const PlacedOutline& second,
                                              double margin, const std::optional<LastContact>& last, double)
{
    return contact_polygon(first, second, margin, last);
}

/// The contacts of the step before, by what touched.
template <int D>
class OldContacts
{
 public:
    OldContacts(const Model& model, const ContactSetIn<D>& contacts, const std::vector<int>& first_part)
        : contacts_(contacts)
    {
        of_parts_.reserve(contacts.patches.size());
        for (int p = 0; p < static_cast<int>(contacts.patches.size()); ++p) {
            const ContactPatchIn<D>& patch = contacts.patches[p];
            of_parts_.emplace_back(
                std::minmax(first_part[patch.block_a] + patch.part_a, first_part[patch.block_b] + patch.part_b),
                p);
            if (model.fit_tolerance > 0) of_stones_[std::minmax(patch.block_a, patch.block_b)].push_back(p);
        }
        // As they were found they are in order already.
        if (!std::is_sorted(of_parts_.begin(), of_parts_.end())) std::sort(of_parts_.begin(), of_parts_.end());
    }
    History<D> between(const PairKey& parts, const PairKey& blocks) const
    {
        History<D> history{nullptr, {}, &contacts_, {}};
        const auto stones = of_stones_.find(blocks);
        if (stones != of_stones_.end()) history.of_stones = stones->second;
        // The last one, should there be several.
        const auto behind = std::upper_bound(of_parts_.begin(), of_parts_.end(), parts,
                                             [](const PairKey& key, const auto& old) { return key < old.first; });
        if (behind == of_parts_.begin() || std::prev(behind)->first != parts) return history;
        history.patch = &contacts_.patches[std::prev(behind)->second];
        history.points =
            std::span(contacts_.points).subspan(history.patch->first_point, history.patch->point_count);
        return history;
    }

 private:
    const ContactSetIn<D>& contacts_;
    std::vector<std::pair<PairKey, int>> of_parts_;  // ascending
    std::map<PairKey, std::vector<int>> of_stones_;  // only where stones need not fit
};

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
    const std::optional<ContactPolygonIn<D>> polygon =
        polygon_between(first, second, margin, last, model.fit_tolerance);
    if (!polygon) return std::nullopt;
    return attach_history(model, state, fully_held, first, second, *polygon, history, overlap);
}

/// Puts what was found in a row.
template <int D>
void gather(std::vector<std::optional<FoundPatch<D>>>& slots, int threads, ContactSetIn<D>& found)
{
    std::vector<FoundPatch<D>*> patches;
    patches.reserve(slots.size());
    int points = 0;
    for (std::optional<FoundPatch<D>>& slot : slots) {
        if (!slot) continue;
        slot->patch.first_point = points;
        slot->patch.point_count = static_cast<int>(slot->points.size());
        points += slot->patch.point_count;
        patches.push_back(&*slot);
    }
    found.patches.resize(patches.size());
    found.points.resize(points);
    in_parallel(patches.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            found.patches[k] = patches[k]->patch;
            std::copy(patches[k]->points.begin(), patches[k]->points.end(),
                      found.points.begin() + patches[k]->patch.first_point);
        }
    });
}

}  // namespace

template <int D>
void find_contacts(const Model& model, const State& state, const std::vector<double>& reach, int threads,
                   std::vector<PlacedPartIn<D>>& parts, ContactSetIn<D>& found, NewOverlap overlap)
{
    place_parts(model, state, threads, parts);
    std::vector<bool> fully_held(model.blocks.size(), false);
    for (const Foundation& foundation : model.foundations)
        if (foundation.fully_held()) fully_held[foundation.block] = true;
    std::vector<int> first_part(model.blocks.size() + 1, 0);
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        first_part[b + 1] = first_part[b] + static_cast<int>(ShapeIn<D>::of(model.blocks[b]).size());

    const OldContacts<D> old(model, contacts_in<D>(state), first_part);
    const std::vector<PairKey> pairs = candidate_pairs(parts, reach, fully_held, threads);
    std::vector<std::optional<FoundPatch<D>>> slots(pairs.size());
    in_parallel(pairs.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            slots[i] = find_patch(
                model, state, fully_held, parts, reach, pairs[i],
                old.between(pairs[i], std::minmax(parts[pairs[i].first].block, parts[pairs[i].second].block)),
                overlap);
    });

    gather(slots, threads, found);
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
