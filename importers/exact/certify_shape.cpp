#include <algorithm>
#include <cmath>

#include "importers/exact/convexity.h"
#include "importers/exact/cut_choice.h"
#include "importers/exact/draft.h"
#include "importers/exact/weld.h"

namespace voussoir::importers::exact
{

namespace
{

/// How many units of the last place of twelve digits a corner of a face may lie off the plane of the others
/// because all of them are rounded: half a unit along each axis (0.87 of a unit), of four corners.
constexpr double rounded_units = 4;

/// What the rounding of a text with twelve digits, the usual "%.12g", may do to a flat face of the stone [m]: the
/// unit of the last place of its largest coordinate, which is between 1e-12 and 1e-11 of it.
double bulge_of_rounding(const Draft& draft)
{
    double largest = 0;
    for (const Eigen::Vector3d& vertex : draft.surface.vertices)
        largest = std::max(largest, (vertex + draft.options.origin).lpNorm<Eigen::Infinity>());
    return largest > 0 ? rounded_units * std::pow(10.0, std::floor(std::log10(largest)) - 11) : 0;
}

/// A convex stone: one part, with coplanar faces merged.
void make_one_part(Draft& draft)
{
    const double tolerance = draft.options.planarity_tolerance, volume = draft.certificate.moments.volume;
    mesh::PolygonSurface merged = draft.surface;
    merged.faces = merge_coplanar_faces(merged.vertices, merged.faces, tolerance / 4);
    drop_unused_vertices(merged);
    draft.certificate.parts.push_back(
        make_convex_polyhedron(merged.vertices, merged.faces, merged.name, tolerance));
    const double change = moments_of(draft.certificate.parts.back()).volume - volume;
    draft.certificate.volume_error = std::abs(change) > 1e-12 * volume ? change / volume : 0;
    if (std::abs(change) <= 1e-12 * volume) return;
    const double bulge = bulge_of(merged, draft.surface.vertices);
    if (bulge <= bulge_of_rounding(draft)) return;  // flat as far as the file's digits can tell
    draft.repaired(
        {"faces flattened",
         format("faces that bulge by up to %.3g m were flattened: the volume changed by %.3g m3", bulge, change),
         1, "", 100 * std::abs(change) / volume, "% of the volume"});
}

std::string make_glued_parts(Draft& draft)
{
    const CertifyOptions& options = draft.options;
    DecomposeOptions how;
    how.planarity = options.planarity_tolerance;
    how.max_parts = options.max_parts;
    how.volume_error = options.volume_error;
    how.joints = options.joints;
    Decomposition result =
        decompose({draft.surface.vertices, draft.examination.triangles}, how, draft.certificate.name);
    if (!result.reason.empty()) draft.certificate.cure = "simplify";
    if (!result.reason.empty())
        return format("it is concave in %d edges and ", result.reentrant_edges) + result.reason +
               format(
                   ": so far they exceed it by %.2g %% of its volume, %.2g %% is allowed; simplify the mesh or "
                   "allow more (volume_error)",
                   100 * result.volume_error, 100 * options.volume_error);
    draft.certificate.parts = std::move(result.parts);
    // What the parts are in the end: hulls, less what the merging of nearly flat faces took.
    result.volume_error = moments_of(draft.certificate.parts).volume / draft.certificate.moments.volume - 1;
    if (std::abs(result.volume_error) < 1e-12) result.volume_error = 0;
    draft.certificate.volume_error = result.volume_error;
    const std::size_t count = draft.certificate.parts.size();
    const std::string parts =
        count == 1 ? std::string("its convex hull, ") : format("%zu convex parts glued together, ", count);
    // Merging nearly flat faces may take more than the hulls add: that is rounding, and no excess.
    const bool differs = result.volume_error > 1e-9;
    draft.repaired({"divided into convex parts",
                    format("it is concave in %d edges and became ", result.reentrant_edges) + parts +
                        (differs ? format("which exceed it by %.2g %% of its volume", 100 * result.volume_error)
                                 : std::string("without change of volume")),
                    static_cast<int>(count), "parts", differs ? 100 * result.volume_error : 0, "% of the volume"});
    return "";
}

double largest_distance(const std::vector<Outlier>& outliers)
{
    double largest = 0;
    for (const Outlier& outlier : outliers) largest = std::max(largest, outlier.distance);
    return largest;
}

}  // namespace

/// Every vertex against every face; of a large surface every face against its neighbours, and the whole against
/// its hull.
bool is_convex(const Draft& draft, double allowed)
{
    const mesh::PolygonSurface& surface = draft.surface;
    if (surface.faces.size() * surface.vertices.size() < 100'000'000)
        return worst_outlier(surface).distance <= allowed;
    const TriangleSurface triangles{surface.vertices, draft.examination.triangles};
    if (!reentrant_edges(triangles, allowed).empty()) return false;
    const TriangleSurface hull = convex_hull(surface.vertices);
    return volume_of(hull) - draft.certificate.moments.volume <= allowed * area_of(hull);
}

std::string check_convex(Draft& draft)
{
    const double allowed = draft.options.planarity_tolerance * draft.diagonal;
    const std::vector<Outlier> bent = cut_bent_faces(draft.surface, draft.examination, allowed);
    if (!bent.empty())
        draft.repaired({"faces that are not flat cut into triangles",
                        format("%zu faces are not flat and were cut into triangles, the first by %.3g m at ",
                               bent.size(), bent.front().distance) +
                            draft.at(bent.front().vertex),
                        static_cast<int>(bent.size()), "faces", largest_distance(bent), "m"});
    draft.certificate.convex = is_convex(draft, allowed);
    if (!draft.certificate.convex) return make_glued_parts(draft);
    make_one_part(draft);
    return "";
}

}  // namespace voussoir::importers::exact
