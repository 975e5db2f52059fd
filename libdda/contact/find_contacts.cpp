#include "libdda/contact/find_contacts.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <optional>
#include <span>

#include "libdda/contact/broad_phase.h"
#include "libdda/contact/narrow_phase.h"

namespace voussoir
{

namespace
{

constexpr double deformable_stiffness_factor = 10;  // ten times as stiff as a block: a tenth more compliance
constexpr double rigid_stiffness_factor = 1;        // the joint carries the block's own compliance
constexpr double closed_at_start = 1e-4;            // of the part size: a smaller gap is a closed joint
constexpr double nearest_point_reach = 0.05;        // of the patch's extent

using PairKey = std::pair<int, int>;  // global part indices, ascending

bool is_fully_held(const Model& model, int block)
{
    return std::any_of(model.foundations.begin(), model.foundations.end(),
                       [&](const Foundation& f) { return f.block == block && f.fully_held(); });
}

/// What turns a measure of a contact into an area [m]: lengths of a planar scene count times its thickness.
template <int D>
double depth_of(const Model& model)
{
    return D == 3 ? 1 : model.thickness;
}

template <int D>
double depth_along(const Block& block, const std::vector<PlacedPartIn<D>>& parts, const PlacedPartIn<D>& part,
                   const VectorIn<D>& normal)
{
    if (ShapeIn<D>::of(block).size() == 1) return part.support(normal) + part.support(-normal);
    double high = -INFINITY, low = INFINITY;
    for (const PlacedPartIn<D>& other : parts) {
        if (other.block != part.block) continue;
        high = std::max(high, other.support(normal));
        low = std::min(low, -other.support(-normal));
    }
    return high - low;
}

/// The documented default: factor x series modulus of the two half blocks on either side of the joint,
/// k = 2 f / (L_a/E_a + L_b/E_b), which is f E / L for equal blocks; a held block adds no compliance.
template <int D>
double stiffness_from_modulus(const Model& model, const std::vector<PlacedPartIn<D>>& parts,
                              const PlacedPartIn<D>& first, const PlacedPartIn<D>& second,
                              const VectorIn<D>& normal)
{
    double compliance = 0;
    for (const PlacedPartIn<D>* part : {&first, &second}) {
        if (is_fully_held(model, part->block)) continue;
        const Block& block = model.blocks[part->block];
        compliance += depth_along(block, parts, *part, normal) / model.materials[block.material].young;
    }
    const double factor = is_deformable(model.kinematics) ? deformable_stiffness_factor : rigid_stiffness_factor;
    return 2 * factor / compliance;
}

double face_measure(const PlacedPart& part, int face)
{
    const std::vector<int>& loop = part.shape->faces[face];
    double twice = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        twice += part.normals[face].dot((part.vertices[loop[i]] - part.vertices[loop[0]])
                                            .cross(part.vertices[loop[i + 1]] - part.vertices[loop[0]]));
    return twice / 2;
}

double face_measure(const PlacedOutline& part, int edge)
{
    return (part.vertices[(edge + 1) % part.vertices.size()] - part.vertices[edge]).norm();
}

std::size_t corners_of(const PlacedPart& part, int face)
{
    return part.shape->faces[face].size();
}

std::size_t corners_of(const PlacedOutline&, int)
{
    return 2;
}

/// Shi's penalty per contact point, spread over the smaller of the two faces: value x corners / area.
/// @returns N/m per unit of measure (m2, planar m)
template <int D>
double stiffness_from_points(double value, const ContactPolygonIn<D>& polygon, const PlacedPartIn<D>& reference,
                             const PlacedPartIn<D>& incident)
{
    if (polygon.edge_edge) return value / polygon.points.front().area;
    const int f = static_cast<int>(polygon.reference_feature), g = static_cast<int>(polygon.incident_feature);
    const double of_reference = face_measure(reference, f), of_incident = face_measure(incident, g);
    const std::size_t corners = of_reference < of_incident ? corners_of(reference, f) : corners_of(incident, g);
    return value * static_cast<double>(corners) / std::min(of_reference, of_incident);
}

template <int D>
double stiffness_as_given(const Model& model, const std::vector<PlacedPartIn<D>>& parts,
                          const ContactPolygonIn<D>& polygon, const PlacedPartIn<D>& reference,
                          const PlacedPartIn<D>& incident)
{
    const ContactStiffness& given = model.joint_between(reference.block, incident.block).stiffness;
    switch (given.kind) {
        case ContactStiffness::Kind::per_area:
            return given.value;
        case ContactStiffness::Kind::per_point:
            return stiffness_from_points(given.value, polygon, reference, incident) / depth_of<D>(model);
        case ContactStiffness::Kind::from_modulus:
            break;
    }
    return stiffness_from_modulus<D>(model, parts, reference, incident, polygon.normal);
}

/// Of a new patch [Pa/m].
template <int D>
double normal_stiffness(const Model& model, const std::vector<PlacedPartIn<D>>& parts,
                        const ContactPolygonIn<D>& polygon, const PlacedPartIn<D>& reference,
                        const PlacedPartIn<D>& incident)
{
    return model.joint_between(reference.block, incident.block).stiffness.factor *
           stiffness_as_given(model, parts, polygon, reference, incident);
}

/// The old patch of a pair of parts and its points.
template <int D>
struct History {
    const ContactPatchIn<D>* patch = nullptr;
    std::span<const ContactPointIn<D>> points;
};

template <int D>
History<D> history_of(const ContactSetIn<D>& old, const std::map<PairKey, int>& old_patches, const PairKey& key)
{
    const auto found = old_patches.find(key);
    if (found == old_patches.end()) return {};
    const ContactPatchIn<D>& patch = old.patches[found->second];
    return {&patch, std::span(old.points).subspan(patch.first_point, patch.point_count)};
}

/// At a place where there was no corner: unlike the slip the rest gap is linear over the patch, so that near
/// corners count more, by the inverse square of their distance.
template <int D>
double rest_gap_between(std::span<const ContactPointIn<D>> old, const VectorIn<D>& place)
{
    double sum = 0, weights = 0;
    for (const ContactPointIn<D>& point : old) {
        const double square = (point.position - place).squaredNorm();
        if (square == 0) return point.rest_gap;
        sum += point.rest_gap / square;
        weights += 1 / square;
    }
    return weights > 0 ? sum / weights : 0;
}

/// Takes over slip and rest gap from the old patch; `sign` is -1 when reference and incident body have changed
/// places.
/// @param sheared share of the patch that the old one was: what has only now come into touch has no elastic slip,
/// and the mean is taken, so that the shear force does not jump
/// @param extent of the patch: the root of its area, or its length [m]
template <int D>
void inherit(const History<D>& history, bool same_features, double sign, double sheared, double extent,
             ContactPointIn<D>& point)
{
    const ContactPointIn<D>* source = nullptr;
    if (same_features)
        for (const ContactPointIn<D>& old : history.points)
            if (old.feature == point.feature) source = &old;
    if (!source) {
        double nearest = nearest_point_reach * extent;
        for (const ContactPointIn<D>& old : history.points) {
            const double distance = (old.position - point.position).norm();
            if (distance > nearest) continue;
            nearest = distance;
            source = &old;
        }
    }
    if (source) {
        point.elastic_slip = sign * sheared * source->elastic_slip;
        point.plastic_slip = sign * source->plastic_slip;
        point.rest_gap = source->rest_gap;
        point.status = source->status;
        return;
    }
    double area = 0;
    for (const ContactPointIn<D>& old : history.points) {
        area += old.area;
        point.elastic_slip += sign * old.area * old.elastic_slip;
        point.plastic_slip += sign * old.area * old.plastic_slip;
    }
    if (area > 0) {
        point.elastic_slip *= sheared / area;
        point.plastic_slip /= area;
        point.status = history.points.front().status;
    }
    point.rest_gap = rest_gap_between(history.points, point.position);
}

/// Of a patch with the normal stiffness `stiffness` in all [N/m], how much the old patch had: at most 1.
template <int D>
double sheared_share(const History<D>& history, double stiffness)
{
    if (!history.patch) return 1;
    double area = 0;
    for (const ContactPointIn<D>& old : history.points) area += old.area;
    const double before = history.patch->stiffness * area;
    return before < stiffness ? before / stiffness : 1;
}

/// In the normal springs that press [J].
template <int D>
double pressed_energy(double stiffness, std::span<const ContactPointIn<D>> points)
{
    double energy = 0;
    for (const ContactPointIn<D>& p : points)
        if (p.gap < 0) energy += 0.5 * stiffness * p.area * p.gap * p.gap;
    return energy;
}

/// A dry contact that was forgiven an overlap presses from there on; as its stones part, so does what is forgiven
/// shrink, and where they are apart nothing is left of it.
/// @param gap of the stones themselves [m]
template <int D>
void follow_out(double gap, NewOverlap overlap, ContactPointIn<D>& point)
{
    const bool forgiven = overlap == NewOverlap::forgiven;
    if (point.rest_gap < 0) point.rest_gap = forgiven ? std::max(point.rest_gap, std::min(gap, 0.0)) : 0;
}

/// Where a contact goes over to another face or to a pair of edges, or is found late, area and depth jump: a
/// needle of 10 mm2 that is 3 mm deep has nothing to do with the hundredth of a face that two edges get, and would
/// throw the blocks apart. The overlap that no work has been done for is forgiven: the springs store what they
/// stored.
template <int D>
void forgive_overlap(double stiffness, double stored, std::vector<ContactPointIn<D>>& points)
{
    const double found = pressed_energy<D>(stiffness, points);
    if (found <= stored) return;
    const double share = std::sqrt(stored / found);
    for (ContactPointIn<D>& p : points) {
        if (p.gap >= 0) continue;
        p.rest_gap += (1 - share) * p.gap;
        p.gap *= share;
    }
}

template <int D>
struct FoundPatch {
    ContactPatchIn<D> patch;
    std::vector<ContactPointIn<D>> points;
};

template <int D>
FoundPatch<D> attach_history(const Model& model, const State& state, const std::vector<PlacedPartIn<D>>& parts,
                             const PlacedPartIn<D>& first, const PlacedPartIn<D>& second,
                             const ContactPolygonIn<D>& polygon, const History<D>& history, NewOverlap overlap)
{
    const PlacedPartIn<D>& reference = polygon.second_is_reference ? second : first;
    const PlacedPartIn<D>& incident = polygon.second_is_reference ? first : second;
    FoundPatch<D> found;
    ContactPatchIn<D>& patch = found.patch;
    patch.block_a = incident.block;
    patch.part_a = incident.part;
    patch.block_b = reference.block;
    patch.part_b = reference.part;
    patch.feature_a = polygon.incident_feature;
    patch.feature_b = polygon.reference_feature;
    patch.edge_edge = polygon.edge_edge;
    patch.normal = polygon.normal;

    const bool same_sides = history.patch && history.patch->block_b == patch.block_b;
    const bool same_features = same_sides && history.patch->edge_edge == patch.edge_edge &&
                               history.patch->feature_a == patch.feature_a &&
                               history.patch->feature_b == patch.feature_b;
    double measure = 0, nearest = INFINITY;
    for (const PolygonPointIn<D>& corner : polygon.points) {
        measure += corner.area;
        nearest = std::min(nearest, corner.gap);
    }
    patch.stiffness =
        same_features ? history.patch->stiffness : normal_stiffness(model, parts, polygon, reference, incident);
    const JointMaterial& joint = model.joint_between(patch.block_a, patch.block_b);
    const bool has_strength = joint.cohesion > 0 || joint.tensile_strength > 0;
    const double size = std::min(first.size, second.size);
    patch.intact = history.patch ? history.patch->intact
                                 : has_strength && state.step == 0 && nearest < closed_at_start * size;

    const double stored = history.patch ? pressed_energy(history.patch->stiffness, history.points) : 0;
    const double extent = D == 3 ? std::sqrt(measure) : measure;
    const double sheared = sheared_share(history, patch.stiffness * measure * depth_of<D>(model));
    for (const PolygonPointIn<D>& corner : polygon.points) {
        ContactPointIn<D> point;
        point.feature = corner.feature;
        point.position = corner.position;
        point.area = corner.area * depth_of<D>(model);
        if (history.patch)
            inherit(history, same_features, same_sides ? 1 : -1, sheared, extent, point);
        else if (patch.intact)
            point.rest_gap = std::clamp(corner.gap, -closed_at_start * size, closed_at_start * size);
        if (!patch.intact) {
            if (!same_features) point.rest_gap = std::max(point.rest_gap, 0.0);
            follow_out(corner.gap, overlap, point);
        }
        point.gap = corner.gap - point.rest_gap;
        point.elastic_slip -= patch.normal.dot(point.elastic_slip) * patch.normal;
        found.points.push_back(point);
    }
    if (overlap == NewOverlap::forgiven && !patch.intact && !same_features)
        forgive_overlap(patch.stiffness, stored, found.points);
    return found;
}

/// The contact of two parts, with the history that goes with it, if they are close enough.
template <int D>
std::optional<FoundPatch<D>> find_patch(const Model& model, const State& state,
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
    return attach_history(model, state, parts, first, second, *polygon, history, overlap);
}

}  // namespace

template <int D>
void find_contacts(const Model& model, const State& state, const std::vector<double>& reach, int threads,
                   std::vector<PlacedPartIn<D>>& parts, ContactSetIn<D>& found, NewOverlap overlap)
{
    place_parts(model, state, parts);
    std::vector<bool> fully_held(model.blocks.size(), false);
    for (const Foundation& foundation : model.foundations) fully_held[foundation.block] = foundation.fully_held();
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
            slots[i] =
                find_patch(model, state, parts, reach, pairs[i], history_of(old, old_patches, pairs[i]), overlap);
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

}  // namespace voussoir
