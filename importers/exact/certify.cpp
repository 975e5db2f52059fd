#include "importers/exact/certify.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>

#include "importers/exact/draft.h"
#include "importers/exact/repairs.h"
#include "importers/exact/shell.h"
#include "importers/exact/stones_of.h"
#include "importers/exact/triangle_surface.h"
#include "importers/exact/weld.h"
#include "libdda/errors.h"

namespace voussoir::importers::exact
{

namespace
{

using DirectedEdge = std::pair<int, int>;

std::string check_size(Draft& draft)
{
    if (draft.surface.vertices.empty() || draft.surface.faces.empty()) return "it has no faces";
    draft.diagonal = diagonal_of(draft.surface.vertices);
    if (!std::isfinite(draft.diagonal) || draft.diagonal > 1e9) return "it is larger than 1e9 m; check the unit";
    if (draft.diagonal == 0) return "all its vertices lie in one point";
    return "";
}

std::string weld_vertices(Draft& draft)
{
    const WeldReport report = weld(draft.surface, draft.options.weld_tolerance * draft.diagonal);
    if (report.moved > 0)
        draft.repaired({"vertices welded",
                        format("%d vertices up to %.3g m away from another one were welded to it", report.moved,
                               report.largest_move),
                        report.moved, "vertices", report.largest_move, "m"});
    if (report.shortened_faces > 0)
        draft.repaired({"repeated corners dropped",
                        format("repeated corners of %d faces were dropped", report.shortened_faces),
                        report.shortened_faces, "faces"});
    if (report.removed_faces > 0)
        draft.repaired(
            {"faces without three corners dropped",
             format("%d faces with fewer than three different corners were dropped", report.removed_faces),
             report.removed_faces, "faces"});
    if (const int dropped = drop_repeated_faces(draft.surface); dropped > 0)
        draft.repaired({"repeated faces dropped",
                        format("%d faces that repeated another one were dropped", dropped), dropped, "faces"});
    return draft.surface.faces.empty() ? "no face has three different corners" : "";
}

/// Lets faces that meet in a line share its corners.
void mend_joints_of_faces(Draft& draft)
{
    if (edge_use(draft.surface).open.empty()) return;
    mesh::PolygonSurface mended = draft.surface;
    const int inserted = insert_corners_on_open_edges(mended, draft.options.weld_tolerance * draft.diagonal);
    if (inserted == 0 || !edge_use(mended).open.empty()) return;
    draft.surface = std::move(mended);
    draft.repaired(
        {"corners inserted",
         format("faces met without sharing their corners: %d corners were inserted into edges", inserted),
         inserted, "corners"});
}

/// How long all open edges are together.
std::string describe_holes(const Draft& draft, const std::vector<DirectedEdge>& open)
{
    double length = 0;
    for (const auto& [a, b] : open) length += (draft.surface.vertices[a] - draft.surface.vertices[b]).norm();
    return format(", %.3g m of open edge in all", length);
}

std::string check_closed(Draft& draft)
{
    mend_joints_of_faces(draft);
    const EdgeUse use = edge_use(draft.surface);
    if (!use.branching.empty()) {
        draft.mark_edges("more than two faces meet", use.branching);
        return format("more than two faces meet in %zu edges, the first ", use.branching.size()) +
               draft.along(use.branching.front());
    }
    if (!use.open.empty()) {
        draft.mark_edges("open edge", use.open);
        return format("it is not closed: %zu edges have a face on one side only, the first ", use.open.size()) +
               draft.along(use.open.front()) + describe_holes(draft, use.open);
    }
    draft.certificate.closed = true;
    return "";
}

/// The shell with the largest extent is the outside; the others must be cavities in it.
std::string check_shells(Draft& draft)
{
    draft.shell = shell_of_faces(draft.surface);
    const int count = *std::max_element(draft.shell.begin(), draft.shell.end()) + 1;
    if (count == 1) return "";
    const std::vector<mesh::PolygonSurface> shells = shells_of(draft.surface);
    int outside = 0;
    for (int s = 1; s < count; ++s)
        if (diagonal_of(shells[s].vertices) > diagonal_of(shells[outside].vertices)) outside = s;
    for (int s = 0; s < count; ++s)
        if (s != outside && !lies_inside(shells[s], shells[outside]))
            return format("it consists of %d separate shells; give each stone an object of its own", count);
    for (int& shell : draft.shell) shell = shell == outside ? 0 : shell == 0 ? outside : shell;
    draft.repaired({"cavities", format("%d closed surfaces inside it were taken as cavities", count - 1),
                    count - 1, "cavities"});
    return "";
}

bool same_direction(const std::vector<int>& before, const std::vector<int>& after)
{
    const auto from = std::find(after.begin(), after.end(), before[0]);
    const int next = from + 1 == after.end() ? after.front() : *(from + 1);
    return next == before[1];
}

std::string orient(Draft& draft)
{
    draft.turned.assign(draft.surface.faces.size(), false);
    const EdgeUse use = edge_use(draft.surface);
    if (use.clashing.empty()) return "";
    const std::vector<std::vector<int>> before = draft.surface.faces;
    if (!orient_consistently(draft.surface)) {
        draft.mark_edges("directions clash", use.clashing);
        return "its faces cannot be oriented consistently, the first conflict is " +
               draft.along(use.clashing.front());
    }
    for (std::size_t f = 0; f < before.size(); ++f)
        draft.turned[f] = !same_direction(before[f], draft.surface.faces[f]);
    return "";
}

/// Triangles whose corners lie on a line are dropped, a few times over, for dropping one may make another.
void examine_and_mend(Draft& draft)
{
    draft.examination = examine(draft.surface);
    int count = 0;
    for (int round = 0; round < 10 && !draft.examination.faces_without_area.empty(); ++round) {
        const std::vector<int> dropped =
            drop_collinear_triangles(draft.surface, draft.examination.faces_without_area);
        if (dropped.empty()) break;
        for (const int f : dropped) {
            draft.shell.erase(draft.shell.begin() + f);
            draft.turned.erase(draft.turned.begin() + f);
        }
        count += static_cast<int>(dropped.size());
        draft.examination = examine(draft.surface);
    }
    if (count > 0)
        draft.repaired({"triangles without area dropped",
                        format("%d triangles with all corners on a line were dropped", count), count,
                        "triangles"});
}

std::string check_crossings(Draft& draft)
{
    examine_and_mend(draft);
    const SurfaceExamination& found = draft.examination;
    const auto corner = [&](int face) { return draft.at(draft.surface.faces[face].front()); };
    if (!found.faces_without_area.empty()) {
        draft.mark_faces("face without area", found.faces_without_area);
        return format("%zu faces have no area, the first at ", found.faces_without_area.size()) +
               corner(found.faces_without_area.front());
    }
    if (found.crossing_faces.empty()) return "";
    std::vector<int> crossing;
    for (const auto& [a, b] : found.crossing_faces) crossing.insert(crossing.end(), {a, b});
    draft.mark_faces("faces cross", crossing);
    const auto [a, b] = found.crossing_faces.front();
    return format("it intersects itself: %zu pairs of faces cut or overlap each other, the first at ",
                  found.crossing_faces.size()) +
           corner(a) + " and " + corner(b);
}

/// Turns the outside outward and cavities inward.
void turn_shells(Draft& draft)
{
    std::vector<std::vector<Eigen::Vector3i>> triangles(*std::max_element(draft.shell.begin(), draft.shell.end()) +
                                                        1);
    for (std::size_t t = 0; t < draft.examination.triangles.size(); ++t)
        triangles[draft.shell[draft.examination.face_of_triangle[t]]].push_back(draft.examination.triangles[t]);
    std::vector<bool> turn;
    for (std::size_t s = 0; s < triangles.size(); ++s)
        turn.push_back((moments_of_surface(draft.surface.vertices, triangles[s]).volume < 0) == (s == 0));
    for (std::size_t f = 0; f < draft.surface.faces.size(); ++f)
        if (turn[draft.shell[f]]) {
            std::reverse(draft.surface.faces[f].begin(), draft.surface.faces[f].end());
            draft.turned[f] = !draft.turned[f];
        }
    for (std::size_t t = 0; t < draft.examination.triangles.size(); ++t)
        if (turn[draft.shell[draft.examination.face_of_triangle[t]]])
            std::swap(draft.examination.triangles[t][1], draft.examination.triangles[t][2]);
}

/// Says how many faces ended up running the other way than in the file.
void report_turned_faces(Draft& draft)
{
    const int turned = static_cast<int>(std::count(draft.turned.begin(), draft.turned.end(), true));
    const int all = static_cast<int>(draft.turned.size());
    if (turned == all)
        draft.repaired({"turned inside out",
                        format("the surface was inside out: all %d faces were turned outward", all), all,
                        "faces"});
    else if (turned > 0)
        draft.repaired(
            {"faces turned",
             format("%d of %d faces were turned to agree with the others and point outward", turned, all), turned,
             "faces"});
}

std::string check_volume(Draft& draft)
{
    turn_shells(draft);
    const double least = draft.options.smallest_volume * std::pow(draft.diagonal, 3);
    const Moments moments = moments_of_surface(draft.surface.vertices, draft.examination.triangles);
    if (moments.volume < least)
        return format("it has no volume (%.3g m3, less than %.3g m3)", moments.volume, least);
    draft.certificate.moments = moments;
    report_turned_faces(draft);
    return "";
}

/// Steps in their order. @returns the reason for refusal, or nothing
std::string prove(Draft& draft, std::initializer_list<CertifyStep> steps)
{
    try {
        for (const CertifyStep step : steps)
            if (std::string reason = step(draft); !reason.empty()) return reason;
    } catch (const InputError& error) {
        const Fault& fault = error.faults.front();
        draft.certificate.convex = false;
        draft.certificate.parts.clear();
        return fault.found + "; " + fault.expected;
    }
    return "";
}

/// A refused stone becomes its hull where that is the rule; otherwise what would help is noted.
void mend_refused(Draft& draft)
{
    Certificate& certificate = draft.certificate;
    if (!certificate.cure.empty() && !draft.options.hull_if_refused) return;
    Draft hull = draft;
    std::string failure;
    try {
        failure = become_hull(hull, certificate.reason);
    } catch (const InputError& error) {
        failure = error.faults.front().found;
    }
    if (certificate.cure.empty()) certificate.cure = failure.empty() ? "hull" : "skip";
    if (!failure.empty() || !draft.options.hull_if_refused) return;
    draft = std::move(hull);
    draft.certificate.reason.clear();
}

}  // namespace

void Draft::mark_edges(const std::string& label, const std::vector<std::pair<int, int>>& edges)
{
    mesh::MarkedFeature feature{label, {}, {}, {}};
    for (const auto& [a, b] : edges) feature.lines.push_back({surface.vertices[a], surface.vertices[b]});
    certificate.features.push_back(std::move(feature));
}

void Draft::mark_faces(const std::string& label, const std::vector<int>& faces)
{
    mesh::MarkedFeature feature{label, {}, {}, {}};
    for (const int f : std::set<int>(faces.begin(), faces.end())) {
        std::vector<Eigen::Vector3d>& polygon = feature.polygons.emplace_back();
        for (const int v : surface.faces[f]) polygon.push_back(surface.vertices[v]);
    }
    certificate.features.push_back(std::move(feature));
}

namespace
{

Certificate finish(Draft draft)
{
    draft.certificate.surface = std::move(draft.surface);
    draft.certificate.examination = std::move(draft.examination);
    draft.certificate.diagonal = draft.diagonal;
    return std::move(draft.certificate);
}

}  // namespace

Certificate certify_surface(mesh::PolygonSurface surface, const CertifyOptions& options)
{
    Draft draft;
    draft.surface = std::move(surface);
    draft.options = options;
    draft.certificate.name = draft.surface.name;
    draft.certificate.reason = options.refuse_because.empty()
                                   ? prove(draft, {check_size, weld_vertices, check_closed, orient, check_shells,
                                                   check_crossings, check_volume})
                                   : options.refuse_because;
    return finish(std::move(draft));
}

Certificate certify_shape(Certificate sound, const CertifyOptions& options)
{
    Draft draft;
    draft.surface = std::move(sound.surface);
    draft.examination = std::move(sound.examination);
    draft.options = options;
    draft.diagonal = sound.diagonal;
    draft.certificate = std::move(sound);
    if (draft.certificate.reason.empty()) draft.certificate.reason = prove(draft, {check_shape});
    if (!draft.certificate.reason.empty()) mend_refused(draft);
    return finish(std::move(draft));
}

Certificate certify(mesh::PolygonSurface surface, const CertifyOptions& options)
{
    return certify_shape(certify_surface(std::move(surface), options), options);
}

}  // namespace voussoir::importers::exact
