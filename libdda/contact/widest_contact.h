// A contact that presses on next to nothing of its faces, where other faces at the same corner press on more.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "libdda/contact/contact_polygon.h"
#include "libdda/contact/narrow_phase_rules.h"
#include "libdda/contact/placed_part.h"

namespace voussoir::contact
{

/// The face of the reference part from which the other part is furthest away; -1: it has none that may touch.
struct ReferenceFace {
    bool of_second = false;  // of the two parts; else of the first
    int face = -1;
    double separation = 0;  // m, < 0: the parts are within one another
};

/// Area [m2], or length [m].
template <int D>
double measure_of(const ContactPolygonIn<D>& contact)
{
    double sum = 0;
    for (const PolygonPointIn<D>& point : contact.points) sum += point.area;
    return sum;
}

/// How deep the deepest point is [m]; 0: none presses.
template <int D>
double deepest_of(const ContactPolygonIn<D>& contact)
{
    double depth = 0;
    for (const PolygonPointIn<D>& point : contact.points) depth = std::max(depth, -point.gap);
    return depth;
}

inline bool may_touch(const PlacedPart& part, int face)
{
    return !part.shape->is_glued(face);
}

inline bool may_touch(const PlacedOutline&, int)
{
    return true;
}

template <int D>
bool is_thin(const PlacedPartIn<D>& first, const PlacedPartIn<D>& second, const ContactPolygonIn<D>& contact)
{
    const PlacedPartIn<D>& reference = contact.second_is_reference ? second : first;
    const PlacedPartIn<D>& incident = contact.second_is_reference ? first : second;
    const auto [of_reference, of_incident] = std::pair(face_measure(reference, contact.reference_feature),
                                                       face_measure(incident, contact.incident_feature));
    return measure_of(contact) < thin * std::min(of_reference, of_incident);
}

/// Where a stone's corner has passed the edge of a face by a little, or turned from it, next to nothing of the
/// most opposed faces lies over one another, and springs on next to nothing give way by centimetres, or store what
/// nothing has put in as soon as it grows: there it is the other two faces at that corner that touch, if they do
/// so with many times the area. The contact that was found, or that of such a pair.
/// @param faces the two that the contact may be referred to; @param chosen the one of `found`
/// @param clip of the incident face over the reference face: (ReferenceFace, incident face) -> contact, if any
template <int D, class Clip>
ContactPolygonIn<D> widest_contact(const PlacedPartIn<D>& first, const PlacedPartIn<D>& second,
                                   const std::array<ReferenceFace, 2>& faces, const ReferenceFace& chosen,
                                   const std::optional<LastContact>& last, ContactPolygonIn<D> found,
                                   const Clip& clip)
{
    if (!(chosen.separation < 0) || !is_thin(first, second, found)) return found;
    const double depth = deepest_of(found), measure = measure_of(found);
    double widest = 0;
    ContactPolygonIn<D> best = std::move(found);
    for (const ReferenceFace& side : faces) {
        if (side.face < 0) continue;
        const PlacedPartIn<D>& reference = side.of_second ? second : first;
        const PlacedPartIn<D>& incident = side.of_second ? first : second;
        const VectorIn<D>& normal = reference.normals[side.face];
        for (int f = 0; f < static_cast<int>(incident.normals.size()); ++f) {
            if (incident.normals[f].dot(normal) > -looks_at || !may_touch(incident, f)) continue;
            std::optional<ContactPolygonIn<D>> other = clip(side, f);
            if (!other || deepest_of(*other) < 0.5 * depth || deepest_of(*other) > 2 * depth) continue;
            const bool was = last && !last->edge_edge && last->second_is_reference == side.of_second &&
                             last->reference_feature == other->reference_feature &&
                             last->incident_feature == other->incident_feature;
            const double times = measure_of(*other) / (times_as_large(was) * measure);
            if (times < 1 || times < widest) continue;
            widest = times;
            best = *std::move(other);
        }
    }
    return best;
}

}  // namespace voussoir::contact
