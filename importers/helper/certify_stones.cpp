#include "importers/helper/certify_stones.h"

#include <algorithm>
#include <new>

#include "importers/exact/triangle_surface.h"
#include "importers/exact/weld.h"
#include "importers/helper/repair_summary.h"

namespace voussoir::importers::helper
{

namespace
{

constexpr double largest_weld = 1e-3;  // share of a stone's diagonal; wider would change its shape

/// Vertices that rounding has parted must be joined, and others must not: the welding of a stone that is small for
/// the rounding becomes as wide as that needs, unless the stone has corners that are nearly as near.
void allow_for_rounding(const mesh::PolygonSurface& surface, double rounding, exact::CertifyOptions& options,
                        std::vector<mesh::Repair>& repairs)
{
    const double diagonal = exact::diagonal_of(surface.vertices);
    if (rounding <= options.weld_tolerance * diagonal || !(diagonal > 0)) return;
    const double width = 4 * rounding;  // two roundings along each axis
    mesh::PolygonSurface joined = surface;
    exact::weld(joined, width);
    if (width > largest_weld * diagonal || exact::weld(joined, 4 * width).moved > 0) {
        options.refuse_because =
            "reading rounds its coordinates by up to " + short_number(rounding) +
            " m, too much for its size: move the stones nearer to the origin of the file, or convert "
            "the file to OBJ";
        return;
    }
    options.weld_tolerance = width / diagonal;
    options.planarity_tolerance = std::max(options.planarity_tolerance, width / diagonal);
    repairs.push_back({"joined within the rounding of reading",
                       "vertices within " + short_number(width) +
                           " m were taken for one, because reading rounds coordinates by up to " +
                           short_number(rounding) + " m",
                       1, "", width, "m"});
}

Stone stone_of(exact::Certificate certificate)
{
    Stone stone;
    stone.name = certificate.name;
    stone.closed = certificate.closed;
    stone.convex = certificate.convex;
    stone.reason = certificate.reason;
    stone.cure = certificate.reason.empty() ? "" : certificate.cure;
    stone.repairs = std::move(certificate.repairs);
    stone.parts = std::move(certificate.parts);
    stone.moments = certificate.moments;
    stone.volume_error = certificate.volume_error;
    stone.features = std::move(certificate.features);
    if (!stone.features.empty()) {
        stone.vertices = std::move(certificate.surface.vertices);
        stone.faces = std::move(certificate.surface.faces);
    }
    return stone;
}

exact::Certificate out_of_memory(const std::string& name)
{
    exact::Certificate refused;
    refused.name = name;
    refused.reason = "certifying it needs more memory than is allowed";
    refused.cure = "skip";
    return refused;
}

/// A stone that was changed since its surface was proven sound is proven once more.
/// @param volume_change by that, a share
exact::Certificate shaped(StoneDraft draft, double& volume_change)
{
    const fit::FittedStone& fitted = draft.fitted;
    if (!fitted.fitted) {
        if (!fitted.left.empty())
            draft.surface.repairs.push_back(
                {"joints left as drawn", "its joints were left as drawn: " + fitted.left});
        return exact::certify_shape(std::move(draft.surface), draft.options);
    }
    for (const fit::Frame& plane : fitted.joints) draft.options.joints.push_back({plane.centre, plane.normal});
    const std::vector<mesh::Repair> before = std::move(draft.surface.repairs);
    const Moments drawn = draft.surface.moments;
    exact::Certificate certificate = exact::certify(std::move(draft.surface.surface), draft.options);
    if (certificate.reason.empty()) {
        volume_change = certificate.moments.volume / drawn.volume - 1;
        certificate.moments = drawn;  // mass and inertia stay
    }
    certificate.repairs.insert(certificate.repairs.begin(), before.begin(), before.end());
    certificate.repairs.push_back({"joints fitted",
                                   "its joints were fitted to its neighbours': corners moved by up to " +
                                       short_number(fitted.largest_move) + " m, its volume changed by " +
                                       short_number(100 * volume_change) + " %",
                                   1, "", fitted.largest_move, "m"});
    return certificate;
}

bool fit_alike(const MeshRequest& a, const MeshRequest& b)
{
    return a.fit_joints == b.fit_joints && a.planarity == b.planarity && a.volume_error == b.volume_error;
}

bool takes_part(const StoneDraft& draft)
{
    const exact::CertifyOptions& options = draft.options;
    return draft.surface.reason.empty() && !options.hull && !options.simplify && options.triangles == 0;
}

}  // namespace

StoneDraft draft_stone(mesh::PolygonSurface surface, exact::CertifyOptions options, double rounding)
{
    StoneDraft draft;
    const std::string name = surface.name;
    for (Eigen::Vector3d& x : surface.vertices) x -= options.origin;
    try {
        allow_for_rounding(surface, rounding, options, draft.repairs);
        draft.surface = exact::certify_surface(std::move(surface), options);
    } catch (const std::bad_alloc&) {
        draft.surface = out_of_memory(name);
    }
    draft.options = std::move(options);
    return draft;
}

JointFit fit_stones(const std::vector<MeshRequest>& requests, std::vector<std::vector<StoneDraft>>& files)
{
    JointFit all;
    std::vector<bool> done(files.size(), false);
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (done[i] || requests[i].fit_joints == FitJoints::as_drawn) continue;
        std::vector<StoneDraft*> drafts;
        for (std::size_t k = i; k < files.size(); ++k) {
            if (!fit_alike(requests[k], requests[i])) continue;
            done[k] = true;
            for (StoneDraft& draft : files[k]) drafts.push_back(&draft);
        }
        std::vector<mesh::PolygonSurface*> surfaces;
        surfaces.reserve(drafts.size());
        for (StoneDraft* draft : drafts)
            surfaces.push_back(takes_part(*draft) ? &draft->surface.surface : nullptr);
        fit::Fit fit = fit::fit_joints(surfaces, {static_cast<fit::FitJoints>(requests[i].fit_joints),
                                                  requests[i].planarity, requests[i].volume_error});
        for (std::size_t s = 0; s < drafts.size(); ++s) drafts[s]->fitted = std::move(fit.stones[s]);
        all.joints += fit.joints;
        all.left += fit.left;
        all.misfit_before = std::max(all.misfit_before, fit.misfit_before);
        all.misfit_after = std::max(all.misfit_after, fit.misfit_after);
    }
    return all;
}

Stone certified(StoneDraft draft)
{
    const std::string name = draft.surface.name;
    const std::vector<mesh::Repair> repairs = std::move(draft.repairs);
    const double move = draft.fitted.largest_move;
    double volume_change = 0;
    try {
        Stone stone = stone_of(shaped(std::move(draft), volume_change));
        stone.fit_move = move;
        stone.fit_volume_change = volume_change;
        stone.repairs.insert(stone.repairs.begin(), repairs.begin(), repairs.end());
        return stone;
    } catch (const std::bad_alloc&) {
        return stone_of(out_of_memory(name));
    }
}

}  // namespace voussoir::importers::helper
