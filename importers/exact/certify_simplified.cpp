// Stones that are not taken as drawn: by their convex hulls, by a few parts, with fewer triangles.
#include <algorithm>
#include <cmath>

#include "importers/exact/decimate.h"
#include "importers/exact/draft.h"
#include "importers/exact/part_of_hull.h"
#include "libdda/errors.h"

namespace voussoir::importers::exact
{

namespace
{

constexpr const char* own_mass = "; its mass and inertia stay those of the surface as drawn";

std::string become_parts(Draft& draft, const SimplifyOptions& options)
{
    SimplifiedStone result =
        simplify({draft.surface.vertices, draft.examination.triangles}, options, draft.certificate.name);
    if (!result.reason.empty()) return result.reason + ": allow more parts or a larger volume_error (simplify)";
    Certificate& certificate = draft.certificate;
    certificate.parts = std::move(result.parts);
    certificate.volume_error = moments_of(certificate.parts).volume / certificate.moments.volume - 1;
    const int count = static_cast<int>(certificate.parts.size());
    std::string text = format("its %zu triangles became %d convex parts, together %.3g %% larger than its volume",
                              draft.examination.triangles.size(), count, 100 * certificate.volume_error);
    if (result.smoothed > 0)
        text += format(
            " (%.2g %% too much, %.2g %% left out: corners that stood out by less than %.3g m were dropped)",
            100 * (certificate.volume_error + result.lack), 100 * result.lack, result.smoothed);
    text += format(", its vertices at most %.3g m below their surface", result.depth) + own_mass;
    draft.repaired({"simplified to convex parts", text, count, "parts", 100 * std::abs(certificate.volume_error),
                    "% of the volume"});
    return "";
}

void decimate(Draft& draft, int triangles)
{
    const std::size_t before = draft.examination.triangles.size();
    TriangleSurface fewer =
        decimated({draft.surface.vertices, draft.examination.triangles}, triangles, draft.certificate.name);
    if (fewer.triangles.size() == before) return;
    const double change = volume_of(fewer) / draft.certificate.moments.volume - 1;
    draft.surface.vertices = std::move(fewer.vertices);
    draft.surface.faces.clear();
    draft.examination.face_of_triangle.clear();
    for (const Eigen::Vector3i& t : fewer.triangles) {
        draft.examination.face_of_triangle.push_back(static_cast<int>(draft.surface.faces.size()));
        draft.surface.faces.push_back({t[0], t[1], t[2]});
    }
    draft.examination.triangles = std::move(fewer.triangles);
    draft.repaired({"fewer triangles",
                    format("its %zu triangles became %zu, which changed its volume by %.2g %%", before,
                           draft.surface.faces.size(), 100 * change) +
                        own_mass,
                    static_cast<int>(draft.surface.faces.size()), "triangles", 100 * std::abs(change),
                    "% of the volume"});
}

}  // namespace

std::string become_hull(Draft& draft, const std::string& why)
{
    const TriangleSurface hull = convex_hull(draft.surface.vertices);
    const double diagonal = diagonal_of(draft.surface.vertices);
    if (!(diagonal > 0) || diagonal > 1e9) return "it has no size";
    const double volume = volume_of(hull), least = draft.options.smallest_volume * std::pow(diagonal, 3);
    if (!(volume > 0) || !(volume >= least)) return "its convex hull has no volume";
    Certificate& certificate = draft.certificate;
    certificate.parts = {part_of_hull(hull, {}, draft.options.planarity_tolerance, diagonal, certificate.name)};
    certificate.parts.front().glued.clear();
    const Moments hull_moments = moments_of(certificate.parts);
    const bool has_volume = certificate.moments.volume > 0;
    if (!has_volume) certificate.moments = hull_moments;
    certificate.volume_error = has_volume ? hull_moments.volume / certificate.moments.volume - 1 : 0;
    certificate.features.clear();
    const std::string because = why.empty() ? "" : "because " + why + ": ";
    const std::string mass =
        has_volume ? format(", %.2g %% larger than its volume", 100 * certificate.volume_error) + own_mass
                   : std::string("; mass and inertia are those of the hull, for it has no volume of its own");
    draft.repaired({"replaced by the convex hull", because + "its convex hull took its place" + mass, 1, "",
                    100 * std::abs(certificate.volume_error), "% of the volume"});
    return "";
}

std::string check_shape(Draft& draft)
{
    const CertifyOptions& options = draft.options;
    if (options.hull) return become_hull(draft, "");
    if (options.triangles > 0) decimate(draft, options.triangles);
    const double allowed = options.planarity_tolerance * draft.diagonal;
    if (!options.simplify || is_convex(draft, allowed)) return check_convex(draft);
    SimplifyOptions how = *options.simplify;
    how.planarity = options.planarity_tolerance;
    how.max_parts = std::min(how.max_parts, options.max_parts);
    return become_parts(draft, how);
}

}  // namespace voussoir::importers::exact
