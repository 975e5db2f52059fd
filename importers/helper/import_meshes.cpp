#include "importers/helper/import_meshes.h"

#include <cmath>
#include <new>
#include <sstream>

#include "importers/exact/certify.h"
#include "importers/exact/overlap.h"
#include "importers/exact/stones_of.h"
#include "importers/exact/triangle_surface.h"
#include "importers/fit/fit_joints.h"
#include "importers/helper/close_joints.h"
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

/// States the rounding of a file that was read in 32-bit numbers. @throws InputError when it exceeds the weld
/// tolerance of a stone, for then vertices that were apart may have become one
void judge_rounding(const mesh::MeshFile& content, ImportedMesh& mesh)
{
    if (content.rounding == 0) return;
    std::ostringstream rounding;
    rounding << content.rounding * mesh.metres_per_unit << " m";
    for (const mesh::PolygonSurface& surface : content.surfaces)
        if (content.rounding > exact::CertifyOptions{}.weld_tolerance * exact::diagonal_of(surface.vertices))
            throw InputError(
                mesh.file + ": " + surface.name,
                "reading rounds its coordinates by up to " + rounding.str() + ", too much for its size",
                "move the stones nearer to the origin of the file, or convert it to OBJ");
    mesh.repairs.push_back({"", "coordinates were read as 32-bit numbers: rounded by up to " + rounding.str()});
}

/// Reads one file into metres. @returns surfaces; a refusal is written into `mesh`
std::vector<mesh::PolygonSurface> read(const MeshRequest& request, ImportedMesh& mesh)
{
    mesh.file = request.file.string();
    try {
        check(request);
        mesh::MeshFile content = mesh::read_mesh(request.file, {stones_by(request.stones), request.reader});
        for (std::string& repair : content.repairs) mesh.repairs.push_back({"", std::move(repair)});
        const char up = settle_frame(request, content, mesh);
        judge_rounding(content, mesh);
        for (mesh::PolygonSurface& surface : content.surfaces)
            for (Eigen::Vector3d& x : surface.vertices) x = to_metres_z_up(x, mesh.metres_per_unit, up);
        return placed(std::move(content.surfaces), request.copies);
    } catch (const InputError& error) {
        mesh.reason = sentence(error);
    } catch (const std::bad_alloc&) {
        mesh.reason = mesh.file + ": reading it needs more memory than is allowed";
    }
    return {};
}

Eigen::Vector3d choose_origin(const std::vector<std::vector<mesh::PolygonSurface>>& files)
{
    Eigen::Vector3d lower = Eigen::Vector3d::Constant(1e300), upper = -lower;
    for (const auto& surfaces : files)
        for (const mesh::PolygonSurface& surface : surfaces)
            for (const Eigen::Vector3d& x : surface.vertices) {
                lower = lower.cwiseMin(x);
                upper = upper.cwiseMax(x);
            }
    const bool far = lower.x() <= upper.x() &&
                     std::max(lower.cwiseAbs().maxCoeff(), upper.cwiseAbs().maxCoeff()) > largest_plain_coordinate;
    if (!far) return Eigen::Vector3d::Zero();
    return (0.5 * lower + 0.5 * upper).array().round();
}

exact::CertifyOptions certify_options(const MeshRequest& request, const Eigen::Vector3d& origin)
{
    exact::CertifyOptions options;
    options.origin = origin;
    options.planarity_tolerance = request.planarity;
    options.volume_error = request.volume_error;
    return options;
}

exact::Certificate sound_surface(mesh::PolygonSurface surface, const exact::CertifyOptions& options)
{
    for (Eigen::Vector3d& x : surface.vertices) x -= options.origin;
    const std::string name = surface.name;
    try {
        return exact::certify_surface(std::move(surface), options);
    } catch (const std::bad_alloc&) {
        exact::Certificate refused;
        refused.name = name;
        refused.reason = "certifying it needs more memory than is allowed";
        return refused;
    }
}

/// A stone that was changed since its surface was proven sound is proven once more.
exact::Certificate shaped(exact::Certificate sound, const fit::FittedStone& fitted,
                          const exact::CertifyOptions& options)
{
    if (!fitted.fitted) {
        if (!fitted.left.empty())
            sound.repairs.push_back({"joints left as drawn", "its joints were left as drawn: " + fitted.left});
        return exact::certify_shape(std::move(sound), options);
    }
    exact::CertifyOptions at_joints = options;
    for (const fit::Frame& plane : fitted.joints) at_joints.joints.push_back({plane.centre, plane.normal});
    exact::Certificate certificate = exact::certify(std::move(sound.surface), at_joints);
    std::ostringstream words;
    words.precision(3);
    words << "its joints were fitted to its neighbours': corners moved by up to " << fitted.largest_move
          << " m, its volume changed by " << 100 * fitted.volume_change << " %";
    certificate.repairs = std::move(sound.repairs);
    certificate.repairs.push_back({"joints fitted", words.str(), 1, "", fitted.largest_move, "m"});
    return certificate;
}

Stone stone_of(exact::Certificate certificate, const fit::FittedStone& fitted)
{
    Stone stone;
    stone.name = certificate.name;
    stone.closed = certificate.closed;
    stone.convex = certificate.convex;
    stone.reason = certificate.reason;
    stone.repairs = certificate.repairs;
    stone.parts = std::move(certificate.parts);
    stone.moments = certificate.moments;
    stone.volume_error = certificate.volume_error;
    stone.fit_move = fitted.largest_move;
    stone.features = std::move(certificate.features);
    if (!stone.features.empty()) {
        stone.vertices = std::move(certificate.surface.vertices);
        stone.faces = std::move(certificate.surface.faces);
    }
    return stone;
}

bool may_be_separated(StoneLevel level)
{
    return level == StoneLevel::detect || level == StoneLevel::file || level == StoneLevel::component;
}

/// The stones of a file with sound surfaces, or the reasons why they have none.
std::vector<exact::Certificate> certify_surfaces(std::vector<mesh::PolygonSurface> surfaces,
                                                 const MeshRequest& request, const Eigen::Vector3d& origin,
                                                 ImportedMesh& mesh)
{
    std::vector<exact::Certificate> certificates;
    for (mesh::PolygonSurface& surface : surfaces) {
        exact::SeparatedStones separated;
        if (may_be_separated(request.stones))
            separated = exact::separate_stones(std::move(surface), exact::CertifyOptions{}.weld_tolerance);
        else
            separated.stones.push_back(std::move(surface));
        mesh.repairs.insert(mesh.repairs.end(), separated.repairs.begin(), separated.repairs.end());
        for (mesh::PolygonSurface& one : separated.stones)
            certificates.push_back(sound_surface(std::move(one), certify_options(request, origin)));
    }
    return certificates;
}

/// Fits the joints of all files that ask for it in the same way to each other.
std::vector<std::vector<fit::FittedStone>> fit_all(const std::vector<MeshRequest>& requests,
                                                   std::vector<std::vector<exact::Certificate>>& files,
                                                   JointFit& result)
{
    std::vector<std::vector<fit::FittedStone>> fitted;
    for (const auto& file : files) fitted.emplace_back(file.size());
    std::vector<bool> done(files.size(), false);
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (done[i] || requests[i].fit_joints == FitJoints::as_drawn) continue;
        const fit::FitOptions options{static_cast<fit::FitJoints>(requests[i].fit_joints), requests[i].planarity,
                                      requests[i].volume_error};
        std::vector<mesh::PolygonSurface*> surfaces;
        std::vector<fit::FittedStone*> reports;
        for (std::size_t k = i; k < files.size(); ++k) {
            if (requests[k].fit_joints != requests[i].fit_joints ||
                requests[k].planarity != requests[i].planarity ||
                requests[k].volume_error != requests[i].volume_error)
                continue;
            done[k] = true;
            for (std::size_t s = 0; s < files[k].size(); ++s) {
                surfaces.push_back(files[k][s].reason.empty() ? &files[k][s].surface : nullptr);
                reports.push_back(&fitted[k][s]);
            }
        }
        fit::Fit one = fit::fit_joints(surfaces, options);
        for (std::size_t s = 0; s < reports.size(); ++s) *reports[s] = std::move(one.stones[s]);
        result.joints += one.joints;
        result.left += one.left;
        result.misfit_before = std::max(result.misfit_before, one.misfit_before);
        result.misfit_after = std::max(result.misfit_after, one.misfit_after);
    }
    return fitted;
}

void certify_shapes(std::vector<exact::Certificate> certificates, const std::vector<fit::FittedStone>& fitted,
                    const MeshRequest& request, const Eigen::Vector3d& origin, ImportedMesh& mesh)
{
    int refused = 0;
    std::string first;
    for (std::size_t s = 0; s < certificates.size(); ++s) {
        const std::string name = certificates[s].name;
        try {
            mesh.stones.push_back(stone_of(
                shaped(std::move(certificates[s]), fitted[s], certify_options(request, origin)), fitted[s]));
        } catch (const std::bad_alloc&) {
            mesh.stones.emplace_back().name = name;
            mesh.stones.back().reason = "certifying it needs more memory than is allowed";
        }
        const Stone& stone = mesh.stones.back();
        if (!stone.reason.empty() && refused++ == 0) first = stone.name + ": " + stone.reason;
    }
    mesh.accepted = refused == 0 && !mesh.stones.empty();
    if (refused > 0)
        mesh.reason = mesh.file + ": " + std::to_string(refused) + " of " + std::to_string(mesh.stones.size()) +
                      " stones refused; " + first;
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
    std::vector<std::vector<mesh::PolygonSurface>> files;
    for (const MeshRequest& request : requests) {
        geometry.meshes.emplace_back();
        files.push_back(read(request, geometry.meshes.back()));
    }
    geometry.origin = choose_origin(files);
    std::vector<std::vector<exact::Certificate>> certificates(files.size());
    for (std::size_t i = 0; i < files.size(); ++i)
        if (geometry.meshes[i].reason.empty())
            certificates[i] =
                certify_surfaces(std::move(files[i]), requests[i], geometry.origin, geometry.meshes[i]);
    const auto fitted = fit_all(requests, certificates, geometry.fit);
    for (std::size_t i = 0; i < files.size(); ++i)
        if (geometry.meshes[i].reason.empty())
            certify_shapes(std::move(certificates[i]), fitted[i], requests[i], geometry.origin,
                           geometry.meshes[i]);
    for (std::size_t i = 0; i < requests.size(); ++i) close_joints(requests[i].close_joints, geometry.meshes[i]);
    geometry.overlaps = overlaps_of(geometry.meshes);
    return geometry;
}

}  // namespace voussoir::importers::helper
