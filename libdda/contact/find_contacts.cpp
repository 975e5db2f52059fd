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
    OldContacts(const Model& model, const ContactSetIn<D>& contacts, SearchMemory<D>& memory)
        : contacts_(contacts), of_parts_(memory.old)
    {
        const std::vector<int>& first_part = memory.first_part;
        of_parts_.clear();
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
    std::vector<std::pair<PairKey, int>>& of_parts_;  // ascending
    std::map<PairKey, std::vector<int>> of_stones_;   // only where stones need not fit
};

/// The contact of two parts, with the history that goes with it, if they are close enough; else no points.
template <int D>
void find_patch(const Model& model, const State& state, const SearchMemory<D>& memory,
                const std::vector<double>& reach, const PairKey& pair, const History<D>& history,
                NewOverlap overlap, FoundPatch<D>& found)
{
    found.points.clear();
    const PlacedPartIn<D>& first = memory.parts[pair.first];
    const PlacedPartIn<D>& second = memory.parts[pair.second];
    std::optional<LastContact> last;
    if (history.patch)
        last = LastContact{history.patch->block_b == second.block, history.patch->edge_edge,
                           history.patch->feature_b, history.patch->feature_a};
    const double margin = reach[first.block] + reach[second.block];
    const std::optional<ContactPolygonIn<D>> polygon =
        polygon_between(first, second, margin, last, model.fit_tolerance);
    if (polygon) attach_history(model, state, memory.fully_held, first, second, *polygon, history, overlap, found);
}

/// Puts the first `count` of what was found in a row.
template <int D>
void gather(std::size_t count, int threads, SearchMemory<D>& memory, ContactSetIn<D>& contacts)
{
    int points = 0;
    memory.kept.clear();
    for (std::size_t k = 0; k < count; ++k) {
        FoundPatch<D>& found = memory.found[k];
        if (found.points.empty()) continue;
        found.patch.first_point = points;
        found.patch.point_count = static_cast<int>(found.points.size());
        points += found.patch.point_count;
        memory.kept.push_back(&found);
    }
    contacts.patches.resize(memory.kept.size());
    contacts.points.resize(points);
    in_parallel(memory.kept.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            const FoundPatch<D>& found = *memory.kept[k];
            contacts.patches[k] = found.patch;
            std::copy(found.points.begin(), found.points.end(), contacts.points.begin() + found.patch.first_point);
        }
    });
}

}  // namespace

template <int D>
void find_contacts(const Model& model, const State& state, const std::vector<double>& reach, int threads,
                   SearchMemory<D>& memory, ContactSetIn<D>& found, NewOverlap overlap)
{
    place_parts(model, state, threads, memory.parts);
    const std::vector<PlacedPartIn<D>>& parts = memory.parts;
    memory.fully_held.assign(model.blocks.size(), false);
    for (const Foundation& foundation : model.foundations)
        if (foundation.fully_held()) memory.fully_held[foundation.block] = true;
    memory.first_part.assign(model.blocks.size() + 1, 0);
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        memory.first_part[b + 1] = memory.first_part[b] + static_cast<int>(ShapeIn<D>::of(model.blocks[b]).size());

    const OldContacts<D> old(model, contacts_in<D>(state), memory);
    find_candidates(parts, reach, memory.fully_held, threads, memory.candidates);
    const std::vector<PairKey>& pairs = memory.candidates.pairs;
    if (memory.found.size() < pairs.size()) memory.found.resize(pairs.size());
    in_parallel(pairs.size(), threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i)
            find_patch(
                model, state, memory, reach, pairs[i],
                old.between(pairs[i], std::minmax(parts[pairs[i].first].block, parts[pairs[i].second].block)),
                overlap, memory.found[i]);
    });

    gather(pairs.size(), threads, memory, found);
}

template <int D>
double spring_energy(const Model& model, const ContactSetIn<D>& contacts)
{
    double energy = 0;
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        const double shear = model.joint_between(patch.block_a, patch.block_b).shear_to_normal_stiffness;
        energy += patch.bending_energy;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPointIn<D>& point = contacts.points[i];
            const double depth = patch.intact ? point.gap : std::min(point.gap, 0.0);
            energy +=
                0.5 * patch.stiffness * point.area * (depth * depth + shear * point.elastic_slip.squaredNorm());
        }
    }
    return energy;
}

#define VOUSSOIR_INSTANTIATE(D)                                                                                \
    template void find_contacts(const Model&, const State&, const std::vector<double>&, int, SearchMemory<D>&, \
                                ContactSetIn<D>&, NewOverlap);                                                 \
    template double spring_energy(const Model&, const ContactSetIn<D>&)
VOUSSOIR_INSTANTIATE(3);
VOUSSOIR_INSTANTIATE(2);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::contact
