#include "importers/helper/import_meshes.h"

#include <cmath>
#include <new>
#include <sstream>

#include "importers/exact/certify.h"
#include "importers/exact/overlap.h"
#include "importers/exact/stones_of.h"
#include "importers/exact/triangle_surface.h"
#include "importers/helper/certify_stones.h"
#include "importers/helper/choose_stones.h"
#include "importers/helper/close_joints.h"
#include "importers/helper/repair_summary.h"
#include "importers/mesh/read_mesh.h"
#include "libdda/errors.h"

namespace voussoir::importers::helper
{

namespace
{

constexpr double largest_plain_coordinate = 1e4;  // m; doubles keep 2e-12 m there

std::string sentence(const InputError& error)
{
    std::string text;
    for (const Fault& fault : error.faults) text += (text.empty() ? "" : "; ") + to_sentence(fault);
    return text;
}

void check(const MeshRequest& request)
{
    std::vector<Fault> faults;
    const std::string place = request.file.string();
    const auto require = [&](bool good, const std::string& found, const char* expected) {
        if (!good) faults.push_back({place, found, expected});
    };
    require(std::isfinite(request.metres_per_unit) && request.metres_per_unit >= 0,
            "the unit is " + std::to_string(request.metres_per_unit) + " m", "must be > 0 m");
    require(request.up == 0 || request.up == 'x' || request.up == 'y' || request.up == 'z',
            std::string("the up axis is '") + request.up + "'", "must be x, y or z");
    require(request.planarity > 0 && request.planarity <= 1e-2,
            "the planarity is " + std::to_string(request.planarity), "must be > 0 and at most 0.01");
    require(request.volume_error > 0 && request.volume_error <= 0.2,
            "the volume error is " + std::to_string(request.volume_error), "must be > 0 and at most 0.2");
    const StoneSimplification& simplify = request.simplify;
    require(simplify.parts >= 0 && simplify.parts <= exact::CertifyOptions{}.max_parts,
            "the parts are " + std::to_string(simplify.parts), "must be 1 to 64");
    require(simplify.volume_error >= 0 && simplify.volume_error <= 1,
            "the volume error of simplifying is " + std::to_string(simplify.volume_error),
            "must be > 0 and at most 1");
    require(simplify.triangles == 0 || simplify.triangles >= 4,
            "the triangles are " + std::to_string(simplify.triangles), "must be 4 at least");
    if (!faults.empty()) throw InputError(faults);
}

/// File coordinates to metres with z up: a rotation, so that nothing is mirrored.
Eigen::Vector3d to_metres_z_up(const Eigen::Vector3d& x, double metres_per_unit, char up)
{
    Eigen::Vector3d scaled = metres_per_unit * x;
    if (up == 'y') return {scaled.x(), 0.0 - scaled.z(), scaled.y()};
    if (up == 'x') return {scaled.y(), scaled.z(), scaled.x()};
    return scaled;
}

/// The unit and the axis: what the user says, else what the file says, else metres and z.
char settle_frame(const MeshRequest& request, const mesh::MeshFile& content, ImportedMesh& mesh)
{
    mesh.unit_from = request.metres_per_unit > 0 ? "option" : content.metres_per_unit ? "file" : "assumed";
    mesh.metres_per_unit =
        request.metres_per_unit > 0 ? request.metres_per_unit : content.metres_per_unit.value_or(1);
    if (content.metres_per_unit && std::abs(*content.metres_per_unit / mesh.metres_per_unit - 1) > 1e-9) {
        std::ostringstream words;
        words << "the file states a unit of " << *content.metres_per_unit << " m; the option says "
              << mesh.metres_per_unit << " m and is used";
        mesh.repairs.push_back({"", words.str()});
    }
    return request.up != 0 ? request.up : content.up.value_or('z');
}

mesh::StonesBy stones_by(StoneLevel level)
{
    switch (level) {
        case StoneLevel::object:
            return mesh::StonesBy::object;
        case StoneLevel::group:
            return mesh::StonesBy::group;
        case StoneLevel::node:
            return mesh::StonesBy::node;
        case StoneLevel::file:
        case StoneLevel::component:
            return mesh::StonesBy::file;
        case StoneLevel::detect:
            break;
    }
    return mesh::StonesBy::detect;
}

/// A file in metres.
struct ReadFile {
    std::vector<mesh::PolygonSurface> surfaces;
    double rounding = 0;  // m, on reading
};

/// Reads one file into metres. @returns surfaces; a refusal is written into `mesh`
ReadFile read(const MeshRequest& request, ImportedMesh& mesh)
{
    mesh.file = request.file.string();
    try {
        check(request);
        mesh::MeshFile content = mesh::read_mesh(request.file, {stones_by(request.stones), request.reader});
        for (std::string& repair : content.repairs) mesh.repairs.push_back({"", std::move(repair)});
        const char up = settle_frame(request, content, mesh);
        const double rounding = content.rounding * mesh.metres_per_unit;
        if (rounding > 0)
            mesh.repairs.push_back({"", "coordinates were read as 32-bit numbers: rounded by up to " +
                                            short_number(rounding) + " m"});
        for (mesh::PolygonSurface& surface : content.surfaces)
            for (Eigen::Vector3d& x : surface.vertices) x = to_metres_z_up(x, mesh.metres_per_unit, up);
        return {placed(std::move(content.surfaces), request.copies), rounding};
    } catch (const InputError& error) {
        mesh.reason = sentence(error);
    } catch (const std::bad_alloc&) {
        mesh.reason = mesh.file + ": reading it needs more memory than is allowed";
    }
    return {};
}

Eigen::Vector3d choose_origin(const std::vector<ReadFile>& files)
{
    Eigen::Vector3d lower = Eigen::Vector3d::Constant(1e300), upper = -lower;
    for (const ReadFile& file : files)
        for (const mesh::PolygonSurface& surface : file.surfaces)
            for (const Eigen::Vector3d& x : surface.vertices) {
                lower = lower.cwiseMin(x);
                upper = upper.cwiseMax(x);
            }
    const bool far = lower.x() <= upper.x() &&
                     std::max(lower.cwiseAbs().maxCoeff(), upper.cwiseAbs().maxCoeff()) > largest_plain_coordinate;
    if (!far) return Eigen::Vector3d::Zero();
    return (0.5 * lower + 0.5 * upper).array().round();
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

/// The stones of a file that are taken, their surfaces proven.
std::vector<StoneDraft> draft_stones(ReadFile file, const MeshRequest& request, const Eigen::Vector3d& origin,
                                     ImportedMesh& mesh)
{
    std::vector<StoneDraft> drafts;
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
            if (const std::string why = chooser.left_out(one.name, whole); !why.empty()) {
                mesh.skipped.push_back({one.name, why});
                continue;
            }
            exact::CertifyOptions options = options_of(request, chooser.wants_hull(one.name, whole),
                                                       chooser.wants_simplification(one.name, whole));
            options.origin = origin;
            drafts.push_back(draft_stone(std::move(one), options, file.rounding));
        }
    }
    mesh.unmatched = chooser.unmatched();
    return drafts;
}

void take_stones(std::vector<StoneDraft> drafts, const MeshRequest& request, ImportedMesh& mesh)
{
    for (StoneDraft& draft : drafts) {
        Stone stone = certified(std::move(draft));
        if (!stone.reason.empty() && request.choice.repair == RepairRule::skip)
            mesh.skipped.push_back({stone.name, stone.reason});
        else
            mesh.stones.push_back(std::move(stone));
    }
    judge_stones(mesh);
}

std::vector<Overlap> overlaps_of(const std::vector<ImportedMesh>& meshes)
{
    std::vector<std::vector<ConvexPolyhedron>> stones;
    std::vector<std::string> names;
    for (const ImportedMesh& mesh : meshes)
        for (const Stone& stone : mesh.stones) {
            stones.push_back(stone.parts);
            names.push_back(stone.name);
        }
    std::vector<Overlap> overlaps;
    for (const exact::OverlappingPair& pair : exact::find_overlaps(stones))
        overlaps.push_back({names[pair.a], names[pair.b], pair.volume, pair.fraction});
    return overlaps;
}

}  // namespace

Geometry import_meshes(const std::vector<MeshRequest>& requests)
{
    Geometry geometry;
    std::vector<ReadFile> files;
    for (const MeshRequest& request : requests) {
        geometry.meshes.emplace_back();
        files.push_back(read(request, geometry.meshes.back()));
    }
    geometry.origin = choose_origin(files);
    std::vector<std::vector<StoneDraft>> drafts(files.size());
    for (std::size_t i = 0; i < files.size(); ++i)
        if (geometry.meshes[i].reason.empty())
            drafts[i] = draft_stones(std::move(files[i]), requests[i], geometry.origin, geometry.meshes[i]);
    geometry.fit = fit_stones(requests, drafts);
    for (std::size_t i = 0; i < files.size(); ++i)
        if (geometry.meshes[i].reason.empty()) take_stones(std::move(drafts[i]), requests[i], geometry.meshes[i]);
    for (std::size_t i = 0; i < requests.size(); ++i) close_joints(requests[i].close_joints, geometry.meshes[i]);
    geometry.overlaps = overlaps_of(geometry.meshes);
    return geometry;
}

}  // namespace voussoir::importers::helper
