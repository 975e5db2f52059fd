#include "libdda/contact/narrow_phase.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "libdda/contact/narrow_phase_rules.h"
#include "libdda/contact/widest_contact.h"

namespace voussoir::contact
{

using Eigen::Vector3d;

namespace
{

// Shares of the smaller part's size L.
constexpr double face_preference = 2e-3;  // of faces over edge pairs
constexpr double edge_area = 1e-2;        // of L^2, of an edge-edge contact
constexpr double shallow = 1e-3;          // a face contact this little deep needs no edge test
constexpr double convex_but_for = 1e-6;   // of the area, by rounding

struct FaceAxis {
    int face = -1;
    double separation = -std::numeric_limits<double>::infinity();  // m
};

/// The face of `reference` from which `other` is furthest away. Stops early when beyond `margin`. A glued face may
/// keep parts apart but is never touched: without this rule a stone that slides along a flat wall of a glued one
/// would catch on the joint between two of its parts. Face -1: all faces are glued.
FaceAxis best_face(const PlacedPart& reference, const PlacedPart& other, double margin, int favoured, double bonus)
{
    FaceAxis best;
    double best_score = best.separation;
    for (int f = 0; f < static_cast<int>(reference.normals.size()); ++f) {
        const Vector3d& n = reference.normals[f];
        const double plane = n.dot(reference.vertices[reference.shape->faces[f].front()]);
        const double separation = -other.support(-n) - plane;
        if (separation > margin) return {f, separation};
        const double score = separation + (f == favoured ? bonus : 0);
        if (score > best_score && !reference.shape->is_glued(f)) {
            best = {f, separation};
            best_score = score;
        }
    }
    return best;
}

/// The face of the incident part that looks at the reference face, with hysteresis for last step's; -1 when all
/// are glued.
int most_opposed_face(const PlacedPart& part, const Vector3d& normal, int last)
{
    int best = -1;
    double best_score = 0;
    for (int f = 0; f < static_cast<int>(part.normals.size()); ++f) {
        if (part.shape->is_glued(f)) continue;
        const double score = part.normals[f].dot(normal) - (f == last ? incident_hysteresis : 0);
        if (best >= 0 && score >= best_score) continue;
        best = f;
        best_score = score;
    }
    return best;
}

/// A polygon corner while it is being clipped; `leaving` labels the edge to the next corner.
struct ClipPoint {
    Vector3d position;
    std::uint32_t leaving;
};

/// Where an edge from `inside` to `outside` leaves the face. An edge that starts deep inside is cut at the side
/// plane. One that starts near it and runs nearly along it is cut where it leaves the tolerance, and that point is
/// put back on the plane: cut at the plane itself, its end would jump along most of its length as soon as it left
/// the tolerance, to and fro from step to step.
Vector3d cut_edge(const Vector3d& inside, const Vector3d& outside, double d_inside, double d_outside,
                  const Vector3d& normal, double tolerance)
{
    const double nearness = std::clamp((d_inside + 20 * tolerance) / (19 * tolerance), 0.0, 1.0);
    const double level = nearness * tolerance;
    return inside + (level - d_inside) / (d_outside - d_inside) * (outside - inside) - level * normal;
}

/// One pass of [SutherlandHodgman1974]: keeps what lies below the plane (normal, offset); new edges get `label`.
void clip(std::vector<ClipPoint>& polygon, const Vector3d& normal, double offset, double tolerance,
          std::uint32_t label, std::vector<ClipPoint>& scratch)
{
    scratch.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipPoint& here = polygon[i];
        const ClipPoint& next = polygon[(i + 1) % polygon.size()];
        const double d0 = normal.dot(here.position) - offset, d1 = normal.dot(next.position) - offset;
        const bool in0 = d0 <= tolerance, in1 = d1 <= tolerance;
        if (in0) scratch.push_back(here);
        if (in0 == in1) continue;
        const Vector3d point = in0 ? cut_edge(here.position, next.position, d0, d1, normal, tolerance)
                                   : cut_edge(next.position, here.position, d1, d0, normal, tolerance);
        scratch.push_back({point, in0 ? label : here.leaving});
    }
    polygon.swap(scratch);
}

/// The tip of a needle touches with all of its face, diagonal neighbours with next to nothing of theirs.
bool is_most_of_a_face(double area, const PlacedPart& reference, int face, const PlacedPart& incident, int opposed)
{
    return area > 0.5 * std::min(face_measure(reference, face), face_measure(incident, opposed));
}

std::optional<ContactPolygon> face_polygon(const PlacedPart& reference, const PlacedPart& incident, int face,
                                           int opposed, double size, double margin)
{
    const Vector3d& n = reference.normals[face];
    const std::vector<int>& loop = reference.shape->faces[face];
    const std::vector<int>& incident_loop = incident.shape->faces[opposed];
    const std::size_t incident_edges = incident_loop.size();

    thread_local std::vector<ClipPoint> polygon, scratch;  // kept: this is done for each pair in each step
    polygon.clear();
    polygon.reserve(incident_edges + loop.size());  // a cut adds at most one corner
    scratch.reserve(incident_edges + loop.size());
    for (std::size_t i = 0; i < incident_edges; ++i)
        polygon.push_back({incident.vertices[incident_loop[i]], static_cast<std::uint32_t>(i)});
    for (std::size_t i = 0; i < loop.size() && polygon.size() >= 3; ++i) {
        const Vector3d& from = reference.vertices[loop[i]];
        const Vector3d side = (reference.vertices[loop[(i + 1) % loop.size()]] - from).cross(n).normalized();
        clip(polygon, side, side.dot(from), clip_tolerance * size, static_cast<std::uint32_t>(incident_edges + i),
             scratch);
    }
    if (polygon.size() < 3) return std::nullopt;

    ContactPolygon contact;
    contact.reference_feature = static_cast<std::uint32_t>(face);
    contact.incident_feature = static_cast<std::uint32_t>(opposed);
    contact.normal = n;
    const double plane = n.dot(reference.vertices[loop.front()]);
    double nearest = margin;
    contact.points.reserve(polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::uint32_t arriving = polygon[(i + polygon.size() - 1) % polygon.size()].leaving;
        const double gap = n.dot(polygon[i].position) - plane;
        nearest = std::min(nearest, gap);
        contact.points.push_back({polygon[i].position, gap, 0, arriving << 16 | polygon[i].leaving});
    }
    if (nearest >= margin) return std::nullopt;
    assign_tributary_areas(contact.points, n);
    double area = 0;
    for (const PolygonPoint& point : contact.points) area += point.area;
    if (area < smallest_share * size * size && !is_most_of_a_face(area, reference, face, incident, opposed))
        return std::nullopt;
    return contact;
}

struct EdgeAxis {
    int first = -1, second = -1;         // edges
    Vector3d normal = Vector3d::Zero();  // from the second part to the first
    double separation = -std::numeric_limits<double>::infinity();
};

Vector3d edge_vector(const PlacedPart& part, int edge)
{
    const ConvexPolyhedron::Edge& e = part.shape->edges[edge];
    return part.vertices[e.to] - part.vertices[e.from];
}

/// One edge of the stone of each direction that occurs.
std::vector<int> distinct_edge_directions(const PlacedPart& part)
{
    std::vector<int> distinct;
    std::vector<Vector3d> directions;
    for (int e = 0; e < static_cast<int>(part.shape->edges.size()); ++e) {
        if (part.shape->is_glued(part.shape->edges[e])) continue;
        const Vector3d d = edge_vector(part, e).normalized();
        const bool known = std::any_of(directions.begin(), directions.end(), [&](const Vector3d& other) {
            return d.cross(other).squaredNorm() < 1e-18;
        });
        if (known) continue;
        directions.push_back(d);
        distinct.push_back(e);
    }
    return distinct;
}

/// Of the edges parallel to `like`, the one furthest along `direction`.
int extreme_edge(const PlacedPart& part, int like, const Vector3d& direction)
{
    const Vector3d d = edge_vector(part, like).normalized();
    int best = like;
    double most = -std::numeric_limits<double>::infinity();
    for (int e = 0; e < static_cast<int>(part.shape->edges.size()); ++e) {
        const ConvexPolyhedron::Edge& edge = part.shape->edges[e];
        if (part.shape->is_glued(edge)) continue;
        if (edge_vector(part, e).normalized().cross(d).squaredNorm() >= 1e-18) continue;
        const double reach = direction.dot(part.vertices[edge.from] + part.vertices[edge.to]);
        if (reach <= most) continue;
        most = reach;
        best = e;
    }
    return best;
}

EdgeAxis best_edge_pair(const PlacedPart& first, const PlacedPart& second)
{
    EdgeAxis best;
    const std::vector<int> of_second = distinct_edge_directions(second);
    for (const int e : distinct_edge_directions(first))
        for (const int f : of_second) {
            const Vector3d cross = edge_vector(first, e).cross(edge_vector(second, f));
            if (cross.norm() < 1e-6 * edge_vector(first, e).norm() * edge_vector(second, f).norm()) continue;
            for (const Vector3d& n : {Vector3d(cross.normalized()), Vector3d(-cross.normalized())}) {
                const double separation = -first.support(-n) - second.support(n);
                if (separation > best.separation) best = {e, f, n, separation};
            }
        }
    if (best.first < 0) return best;
    best.first = extreme_edge(first, best.first, -best.normal);
    best.second = extreme_edge(second, best.second, best.normal);
    return best;
}

/// The nearest points of two crossing edges, if they lie inside both segments.
std::optional<ContactPolygon> edge_point(const PlacedPart& first, const PlacedPart& second, const EdgeAxis& axis,
                                         double size)
{
    const Vector3d a = first.vertices[first.shape->edges[axis.first].from], u = edge_vector(first, axis.first);
    const Vector3d b = second.vertices[second.shape->edges[axis.second].from],
                   v = edge_vector(second, axis.second);
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), ua = u.dot(b - a), va = v.dot(b - a);
    const double determinant = uu * vv - uv * uv;
    const double s = (ua * vv - va * uv) / determinant, t = (ua * uv - va * uu) / determinant;
    if (s < 0 || s > 1 || t < 0 || t > 1) return std::nullopt;
    ContactPolygon contact;
    contact.edge_edge = true;
    contact.second_is_reference = true;
    contact.incident_feature = static_cast<std::uint32_t>(axis.first);
    contact.reference_feature = static_cast<std::uint32_t>(axis.second);
    contact.normal = axis.normal;
    const Vector3d on_first = a + s * u;
    contact.points.push_back({on_first, axis.normal.dot(on_first - (b + t * v)), edge_area * size * size, 0});
    return contact;
}

}  // namespace

void assign_tributary_areas(std::vector<PolygonPoint>& points, const Vector3d& normal)
{
    const std::size_t n = points.size();
    const Vector3d origin = points.front().position;
    double total = 0, least = 0, most = 0;
    Vector3d first_moment = Vector3d::Zero(), mean = Vector3d::Zero();
    for (std::size_t i = 0; i < n; ++i) mean += (points[i].position - origin) / static_cast<double>(n);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const Vector3d p = points[i].position - origin, q = points[i + 1].position - origin;
        const double area = 0.5 * normal.dot(p.cross(q));
        total += area;
        least = std::min(least, area);
        most = std::max(most, area);
        first_moment += area / 3 * (p + q);
    }
    // A sliver that clipping left crosses itself: its parts cancel one another, and its area centroid is anywhere.
    // One without area has none; its points keep area 0 and the caller skips it.
    const bool crosses_itself = std::min(-least, most) > convex_but_for * std::max(-least, most);
    const Vector3d centroid = origin + (total != 0 && !crosses_itself ? Vector3d(first_moment / total) : mean);
    for (PolygonPoint& point : points) point.area = 0;
    for (std::size_t i = 0; i < n; ++i) {
        PolygonPoint& here = points[i];
        PolygonPoint& next = points[(i + 1) % n];
        // The incident face is seen from below: its loop runs clockwise about the reference normal.
        const double half =
            0.25 * std::abs(normal.dot((here.position - centroid).cross(next.position - centroid)));
        here.area += half;
        next.area += half;
    }
}

std::optional<ContactPolygon> contact_polygon(const PlacedPart& first, const PlacedPart& second, double margin,
                                              const std::optional<LastContact>& last, double fit_tolerance)
{
    const double size = std::min(first.size, second.size);
    const double bonus = face_hysteresis * size;
    const bool last_face = last && !last->edge_edge;
    const int favoured = last_face ? static_cast<int>(last->reference_feature) : -1;
    const FaceAxis of_first =
        best_face(first, second, margin, last_face && !last->second_is_reference ? favoured : -1, bonus);
    if (of_first.separation > margin) return std::nullopt;
    const FaceAxis of_second =
        best_face(second, first, margin, last_face && last->second_is_reference ? favoured : -1, bonus);
    if (of_second.separation > margin) return std::nullopt;
    if (of_first.face < 0 && of_second.face < 0) return std::nullopt;

    double lead = of_second.separation - of_first.separation - body_preference * size;
    if (last_face) lead += last->second_is_reference ? bonus : -bonus;
    const std::array<ReferenceFace, 2> faces{ReferenceFace{false, of_first.face, of_first.separation},
                                             ReferenceFace{true, of_second.face, of_second.separation}};
    const ReferenceFace& chosen = faces[lead > 0];
    const auto polygon_on = [&](const ReferenceFace& side, int opposed) {
        std::optional<ContactPolygon> polygon = face_polygon(
            side.of_second ? second : first, side.of_second ? first : second, side.face, opposed, size, margin);
        if (polygon) polygon->second_is_reference = side.of_second;
        return polygon;
    };
    const bool same_reference = last_face && last->second_is_reference == chosen.of_second;
    const int last_incident = same_reference ? static_cast<int>(last->incident_feature) : -1;
    const int opposed = most_opposed_face(chosen.of_second ? first : second,
                                          (chosen.of_second ? second : first).normals[chosen.face], last_incident);
    std::optional<ContactPolygon> face;
    if (opposed >= 0) face = polygon_on(chosen, opposed);
    if (face) face = widest_contact<3>(first, second, faces, chosen, last, *std::move(face), polygon_on);
    if (face && chosen.separation > -shallow * size) return face;
    if (face && fit_tolerance > 0 && deepest_of(*face) <= fit_tolerance) return face;

    // An edge pair must separate clearly better than any face. Where it only ties with a face (a box that slides
    // over the joint of a flush floor meets the next block's side) the parts pass each other and do not touch.
    const EdgeAxis edges = best_edge_pair(first, second);
    if (edges.first < 0 || edges.separation < chosen.separation + face_preference * size) return face;
    if (edges.separation > margin) return std::nullopt;
    const std::optional<ContactPolygon> crossing = edge_point(first, second, edges, size);
    return crossing ? crossing : face;
}

}  // namespace voussoir::contact
