#include "importers/helper/certify_stones.h"

#include <algorithm>
#include <new>
#include <sstream>

#include "importers/exact/certify.h"
#include "importers/exact/stones_of.h"
#include "importers/exact/triangle_surface.h"
#include "importers/exact/weld.h"
#include "importers/helper/choose_stones.h"

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

exact::CertifyOptions options_of(const MeshRequest& request, bool hull, bool simplified)
{
    exact::CertifyOptions options;
    options.planarity_tolerance = request.planarity;
    options.volume_error = request.volume_error;
    options.hull = hull || (simplified && request.simplify.hull);
    options.hull_if_refused = options.hull || request.choice.repair == RepairRule::hull;
    if (!simplified) return options;
    options.triangles = request.simplify.triangles;
    if (request.simplify.parts == 0 && request.simplify.volume_error == 0) return options;
    options.simplify = exact::SimplifyOptions{};
    if (request.simplify.parts > 0) options.simplify->max_parts = request.simplify.parts;
    options.simplify->volume_error = request.simplify.volume_error;
    return options;
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

/// @param rounding on reading [m]
Stone certified(mesh::PolygonSurface surface, exact::CertifyOptions options, double rounding,
                const Eigen::Vector3d& origin)
{
    const std::string name = surface.name;
    for (Eigen::Vector3d& x : surface.vertices) x -= origin;
    options.origin = origin;
    std::vector<mesh::Repair> repairs;
    try {
        allow_for_rounding(surface, rounding, options, repairs);
        Stone stone = stone_of(exact::certify(std::move(surface), options));
        stone.repairs.insert(stone.repairs.begin(), repairs.begin(), repairs.end());
        return stone;
    } catch (const std::bad_alloc&) {
        Stone stone;
        stone.name = name;
        stone.reason = "certifying it needs more memory than is allowed";
        stone.cure = "skip";
        return stone;
    }
}

bool may_be_separated(StoneLevel level)
{
    return level == StoneLevel::detect || level == StoneLevel::file || level == StoneLevel::component;
}

exact::SeparatedStones separated(mesh::PolygonSurface surface, StoneLevel level)
{
    if (may_be_separated(level))
        return exact::separate_stones(std::move(surface), exact::CertifyOptions{}.weld_tolerance);
    exact::SeparatedStones one;
    one.stones.push_back(std::move(surface));
    return one;
}

void judge_stones(ImportedMesh& mesh)
{
    int refused = 0;
    std::string first;
    for (const Stone& stone : mesh.stones)
        if (!stone.reason.empty() && refused++ == 0) first = stone.name + ": " + stone.reason;
    mesh.accepted = refused == 0 && !mesh.stones.empty();
    if (refused > 0)
        mesh.reason = mesh.file + ": " + std::to_string(refused) + " of " + std::to_string(mesh.stones.size()) +
                      " stones refused; " + first;
    else if (mesh.stones.empty())
        mesh.reason = mesh.file + ": every stone was left out";
}

}  // namespace

void certify_all(ReadFile file, const MeshRequest& request, const Eigen::Vector3d& origin, ImportedMesh& mesh)
{
    StoneChooser chooser(request);
    for (mesh::PolygonSurface& surface : file.surfaces) {
        const std::string whole = surface.name;
        if (const std::string why = chooser.left_out(whole); !why.empty()) {
            mesh.skipped.push_back({whole, why});
            continue;
        }
        exact::SeparatedStones stones = separated(std::move(surface), request.stones);
        mesh.repairs.insert(mesh.repairs.end(), stones.repairs.begin(), stones.repairs.end());
        for (mesh::PolygonSurface& one : stones.stones) {
            const std::string name = one.name;
            if (const std::string why = chooser.left_out(name, whole); !why.empty()) {
                mesh.skipped.push_back({name, why});
                continue;
            }
            const bool hull = chooser.wants_hull(name, whole),
                       simplified = chooser.wants_simplification(name, whole);
            Stone stone = certified(std::move(one), options_of(request, hull, simplified), file.rounding, origin);
            if (!stone.reason.empty() && request.choice.repair == RepairRule::skip)
                mesh.skipped.push_back({name, stone.reason});
            else
                mesh.stones.push_back(std::move(stone));
        }
    }
    mesh.unmatched = chooser.unmatched();
    judge_stones(mesh);
}

std::string short_number(double value)
{
    std::ostringstream words;
    words.precision(3);
    words << value;
    return words.str();
}

}  // namespace voussoir::importers::helper
