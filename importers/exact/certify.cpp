#include "importers/exact/certify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "importers/exact/convexity.h"
#include "importers/exact/shell.h"
#include "importers/exact/surface_checks.h"
#include "importers/exact/weld.h"
#include "libdda/errors.h"
#include "libdda/geometry/moments.h"

namespace voussoir
{

namespace
{

using DirectedEdge = std::pair<int, int>;

template <class... Values>
std::string format(const char* pattern, Values... values)
{
    std::array<char, 256> buffer{};
    std::snprintf(buffer.data(), buffer.size(), pattern, values...);  // NOLINT: patterns are literals below
    return buffer.data();
}

/// A stone on its way to a certificate. A step returns the reason for refusal, or nothing.
struct Draft {
    PolygonSurface surface;
    CertifyOptions options;
    double diagonal = 0;                            // m
    std::vector<DirectedEdge> original_directions;  // per face, of its first edge
    SurfaceExamination examination;
    Certificate certificate;

    std::string at(int vertex) const
    {
        const Eigen::Vector3d x = surface.vertices[vertex] + options.origin;
        return format("(%.9g, %.9g, %.9g)", x.x(), x.y(), x.z());
    }
    std::string along(const DirectedEdge& edge) const
    {
        return "from " + at(edge.first) + " to " + at(edge.second);
    }
    void repaired(std::string what) { certificate.repairs.push_back(std::move(what)); }
};

std::string check_size(Draft& draft)
{
    if (draft.surface.vertices.empty() || draft.surface.faces.empty()) return "it has no faces";
    Eigen::Vector3d lower = draft.surface.vertices.front(), upper = lower;
    for (const Eigen::Vector3d& x : draft.surface.vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    draft.diagonal = (upper - lower).norm();
    if (!std::isfinite(draft.diagonal) || draft.diagonal > 1e9) return "it is larger than 1e9 m; check the unit";
    if (draft.diagonal == 0) return "all its vertices lie in one point";
    return "";
}

std::string weld_vertices(Draft& draft)
{
    const WeldReport report = weld(draft.surface, draft.options.weld_tolerance * draft.diagonal);
    if (report.moved > 0)
        draft.repaired(format("%d vertices up to %.3g m away from another one were welded to it", report.moved,
                              report.largest_move));
    if (report.shortened_faces > 0)
        draft.repaired(format("repeated corners of %d faces were dropped", report.shortened_faces));
    if (report.removed_faces > 0)
        draft.repaired(
            format("%d faces with fewer than three different corners were dropped", report.removed_faces));
    return draft.surface.faces.empty() ? "no face has three different corners" : "";
}

std::string check_closed(Draft& draft)
{
    const EdgeUse use = edge_use(draft.surface);
    if (!use.branching.empty())
        return format("more than two faces meet in %zu edges, the first ", use.branching.size()) +
               draft.along(use.branching.front());
    if (!use.open.empty())
        return format("it is not closed: %zu edges have a face on one side only, the first ", use.open.size()) +
               draft.along(use.open.front());
    draft.certificate.closed = true;
    return "";
}

std::string check_one_shell(Draft& draft)
{
    const int count = shells(draft.surface);
    return count == 1 ? ""
                      : format("it consists of %d separate shells; give each stone an object of its own", count);
}

std::string orient(Draft& draft)
{
    for (const std::vector<int>& face : draft.surface.faces)
        draft.original_directions.emplace_back(face[0], face[1]);
    const EdgeUse use = edge_use(draft.surface);
    if (use.clashing.empty()) return "";
    if (orient_consistently(draft.surface)) return "";
    return "no choice of directions makes its faces agree, the first clash is " +
           draft.along(use.clashing.front());
}

std::string check_crossings(Draft& draft)
{
    draft.examination = examine(draft.surface);
    const SurfaceExamination& found = draft.examination;
    const auto corner = [&](int face) { return draft.at(draft.surface.faces[face].front()); };
    if (!found.faces_without_area.empty())
        return format("%zu faces have no area, the first at ", found.faces_without_area.size()) +
               corner(found.faces_without_area.front());
    if (found.crossing_faces.empty()) return "";
    const auto [a, b] = found.crossing_faces.front();
    return format("it crosses itself: %zu pairs of faces cut or overlap each other, the first at ",
                  found.crossing_faces.size()) +
           corner(a) + " and " + corner(b);
}

std::string check_volume(Draft& draft)
{
    const double volume = std::abs(moments_of_surface(draft.surface.vertices, draft.examination.triangles).volume);
    const double least = draft.options.smallest_volume * std::pow(draft.diagonal, 3);
    return volume >= least ? "" : format("it has no volume (%.3g m3, less than %.3g m3)", volume, least);
}

/// Says how many faces ended up running the other way than in the file.
void report_turned_faces(Draft& draft)
{
    int turned = 0;
    for (std::size_t f = 0; f < draft.surface.faces.size(); ++f) {
        const std::vector<int>& face = draft.surface.faces[f];
        const auto from = std::find(face.begin(), face.end(), draft.original_directions[f].first);
        const int next = from + 1 == face.end() ? face.front() : *(from + 1);
        turned += next != draft.original_directions[f].second;
    }
    const int all = static_cast<int>(draft.surface.faces.size());
    if (turned == all)
        draft.repaired(format("the surface was inside out: all %d faces were turned outward", all));
    else if (turned > 0)
        draft.repaired(
            format("%d of %d faces were turned to agree with the others and point outward", turned, all));
}

std::string turn_outward(Draft& draft)
{
    if (!draft.examination.points_outward) {
        for (std::vector<int>& face : draft.surface.faces) face = {face.rbegin(), face.rend()};
        for (Eigen::Vector3i& triangle : draft.examination.triangles) std::swap(triangle[1], triangle[2]);
        draft.examination.points_outward = true;
    }
    report_turned_faces(draft);
    return "";
}

std::string check_convex(Draft& draft)
{
    const double allowed = draft.options.planarity_tolerance * draft.diagonal;
    const std::vector<Outlier> bent = cut_bent_faces(draft.surface, draft.examination, allowed);
    if (!bent.empty())
        draft.repaired(format("%zu faces are not flat and were cut into triangles, the first by %.3g m at ",
                              bent.size(), bent.front().distance) +
                       draft.at(bent.front().vertex));
    const Outlier worst = worst_outlier(draft.surface);
    if (worst.distance > allowed)
        return "it is not convex: vertex " + draft.at(worst.vertex) +
               format(" lies %.3g m outside face %d at ", worst.distance, worst.face) +
               draft.at(draft.surface.faces[worst.face].front()) +
               "; splitting into convex parts is not there yet";
    draft.certificate.convex = true;
    return "";
}

std::string make_part(Draft& draft)
{
    const double before = moments_of_surface(draft.surface.vertices, draft.examination.triangles).volume;
    const double tolerance = draft.options.planarity_tolerance;
    PolygonSurface merged = draft.surface;
    merged.faces = merge_coplanar_faces(merged.vertices, merged.faces, tolerance);
    drop_unused_vertices(merged);
    draft.certificate.parts.push_back(
        make_convex_polyhedron(merged.vertices, merged.faces, merged.name, tolerance));
    const double change = moments_of(draft.certificate.parts.back()).volume - before;
    if (std::abs(change) > 1e-12 * before)
        draft.repaired(format("faces that bulge by less than %.3g m were flattened: the volume changed by %.3g m3",
                              tolerance * draft.diagonal, change));
    return "";
}

}  // namespace

Certificate certify(PolygonSurface surface, const CertifyOptions& options)
{
    Draft draft;
    draft.surface = std::move(surface);
    draft.options = options;
    draft.certificate.name = draft.surface.name;
    std::string& reason = draft.certificate.reason;
    try {
        for (const auto step : {check_size, weld_vertices, check_closed, check_one_shell, orient, check_crossings,
                                check_volume, turn_outward, check_convex, make_part})
            if (reason = step(draft); !reason.empty()) break;
    } catch (const InputError& error) {
        const Fault& fault = error.faults.front();
        reason = fault.found + "; " + fault.expected;
        draft.certificate.convex = false;
        draft.certificate.parts.clear();
    }
    return std::move(draft.certificate);
}

}  // namespace voussoir
