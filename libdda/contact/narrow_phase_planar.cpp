#include "libdda/contact/narrow_phase_planar.h"

#include <limits>

#include "libdda/contact/narrow_phase_rules.h"
#include "libdda/contact/widest_contact.h"

namespace voussoir::contact
{

using Eigen::Vector2d;

namespace
{

struct EdgeAxis {
    int edge = -1;
    double separation = -std::numeric_limits<double>::infinity();  // m
};

/// The edge of `reference` from which `other` is furthest away. Stops early when beyond `margin`.
EdgeAxis best_edge(const PlacedOutline& reference, const PlacedOutline& other, double margin, int favoured,
                   double bonus)
{
    EdgeAxis best;
    double best_score = best.separation;
    for (int e = 0; e < static_cast<int>(reference.normals.size()); ++e) {
        const Vector2d& n = reference.normals[e];
        const double separation = -other.support(-n) - n.dot(reference.vertices[e]);
        if (separation > margin) return {e, separation};
        const double score = separation + (e == favoured ? bonus : 0);
        if (score <= best_score) continue;
        best = {e, separation};
        best_score = score;
    }
    return best;
}

/// The edge of the incident outline that looks at the reference edge, with hysteresis for last step's.
int most_opposed_edge(const PlacedOutline& part, const Vector2d& normal, int last)
{
    int best = 0;
    double best_score = 2;
    for (int e = 0; e < static_cast<int>(part.normals.size()); ++e) {
        const double score = part.normals[e].dot(normal) - (e == last ? incident_hysteresis : 0);
        if (score >= best_score) continue;
        best = e;
        best_score = score;
    }
    return best;
}

/// An end of the incident edge while it is being clipped; features: its own ends 0 and 1, the reference's 2 and 3.
struct SegmentEnd {
    Vector2d position;
    std::uint32_t feature;
};

/// Keeps what lies below the line (normal, offset). @returns whether anything does
bool clip(SegmentEnd& a, SegmentEnd& b, const Vector2d& normal, double offset, double tolerance,
          std::uint32_t label)
{
    const double da = normal.dot(a.position) - offset, db = normal.dot(b.position) - offset;
    if (da > tolerance && db > tolerance) return false;
    if ((da > tolerance) == (db > tolerance)) return true;
    SegmentEnd& outside = da > tolerance ? a : b;
    const SegmentEnd& inside = da > tolerance ? b : a;
    // Within the tolerance the true crossing may lie outside the segment: take the end that is inside.
    outside.position =
        da * db <= 0 ? Vector2d(a.position + da / (da - db) * (b.position - a.position)) : inside.position;
    outside.feature = label;
    return true;
}

std::optional<ContactSegment> edge_segment(const PlacedOutline& reference, const PlacedOutline& incident, int edge,
                                           int opposed, double size, double margin)
{
    const Vector2d& n = reference.normals[edge];
    const Vector2d& from = reference.vertices[edge];
    const Vector2d& to = reference.vertices[(edge + 1) % reference.vertices.size()];
    const Vector2d along = (to - from).normalized();
    SegmentEnd a{incident.vertices[opposed], 0};
    SegmentEnd b{incident.vertices[(opposed + 1) % incident.vertices.size()], 1};
    const double tolerance = clip_tolerance * size;
    if (!clip(a, b, -along, -along.dot(from), tolerance, 2) || !clip(a, b, along, along.dot(to), tolerance, 3))
        return std::nullopt;
    const double length = (b.position - a.position).norm();
    if (length < smallest_share * size) return std::nullopt;

    ContactSegment contact;
    contact.reference_feature = static_cast<std::uint32_t>(edge);
    contact.incident_feature = static_cast<std::uint32_t>(opposed);
    contact.normal = n;
    double nearest = margin;
    for (const SegmentEnd& end : {a, b}) {
        const double gap = n.dot(end.position - from);
        nearest = std::min(nearest, gap);
        contact.points.push_back({end.position, gap, length / 2, end.feature});
    }
    if (nearest >= margin) return std::nullopt;
    return contact;
}

}  // namespace

std::optional<ContactSegment> contact_polygon(const PlacedOutline& first, const PlacedOutline& second,
                                              double margin, const std::optional<LastContact>& last)
{
    const double size = std::min(first.size, second.size), bonus = face_hysteresis * size;
    const int favoured = last ? static_cast<int>(last->reference_feature) : -1;
    const bool last_second = last && last->second_is_reference, last_first = last && !last->second_is_reference;
    const EdgeAxis of_first = best_edge(first, second, margin, last_first ? favoured : -1, bonus);
    if (of_first.separation > margin) return std::nullopt;
    const EdgeAxis of_second = best_edge(second, first, margin, last_second ? favoured : -1, bonus);
    if (of_second.separation > margin) return std::nullopt;

    double lead = of_second.separation - of_first.separation - body_preference * size;
    if (last) lead += last_second ? bonus : -bonus;
    const std::array<ReferenceFace, 2> edges{ReferenceFace{false, of_first.edge, of_first.separation},
                                             ReferenceFace{true, of_second.edge, of_second.separation}};
    const ReferenceFace& chosen = edges[lead > 0];
    const auto segment_on = [&](const ReferenceFace& side, int opposed) {
        std::optional<ContactSegment> segment = edge_segment(
            side.of_second ? second : first, side.of_second ? first : second, side.face, opposed, size, margin);
        if (segment) segment->second_is_reference = side.of_second;
        return segment;
    };
    const int last_incident =
        last && last_second == chosen.of_second ? static_cast<int>(last->incident_feature) : -1;
    const PlacedOutline& incident = chosen.of_second ? first : second;
    const Vector2d& normal = (chosen.of_second ? second : first).normals[chosen.face];
    std::optional<ContactSegment> segment = segment_on(chosen, most_opposed_edge(incident, normal, last_incident));
    if (segment) segment = widest_contact<2>(first, second, edges, chosen, last, *std::move(segment), segment_on);
    return segment;
}

}  // namespace voussoir::contact
