#include "app/geometry/import_meshes.h"

#include <cmath>
#include <new>
#include <sstream>

#include "importers/exact/certify.h"
#include "importers/exact/overlap.h"
#include "importers/mesh/read_mesh.h"
#include "libdda/errors.h"

namespace voussoir
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
    if (!std::isfinite(request.metres_per_unit) || request.metres_per_unit <= 0)
        faults.push_back(
            {place, "the unit is " + std::to_string(request.metres_per_unit) + " m", "must be > 0 m"});
    if (request.up != 'x' && request.up != 'y' && request.up != 'z')
        faults.push_back({place, std::string("the up axis is '") + request.up + "'", "must be x, y or z"});
    if (!faults.empty()) throw InputError(faults);
}

/// File coordinates to metres with z up: a rotation, so that nothing is mirrored.
Eigen::Vector3d to_metres_z_up(const Eigen::Vector3d& x, const MeshRequest& request)
{
    Eigen::Vector3d scaled = request.metres_per_unit * x;
    if (request.up == 'y') return {scaled.x(), 0.0 - scaled.z(), scaled.y()};
    if (request.up == 'x') return {scaled.y(), scaled.z(), scaled.x()};
    return scaled;
}

double diagonal_of(const PolygonSurface& surface)
{
    Eigen::Vector3d lower = Eigen::Vector3d::Constant(1e300), upper = -lower;
    for (const Eigen::Vector3d& x : surface.vertices) {
        lower = lower.cwiseMin(x);
        upper = upper.cwiseMax(x);
    }
    return (upper - lower).norm();
}

/// States the rounding of a file that was read in 32-bit numbers. @throws InputError when it exceeds the weld
/// tolerance of a stone, for then vertices that were apart may have become one
void judge_rounding(const MeshFile& content, ImportedMesh& mesh)
{
    if (content.rounding == 0) return;
    std::ostringstream rounding;
    rounding << content.rounding * mesh.metres_per_unit << " m";
    for (const PolygonSurface& surface : content.surfaces)
        if (content.rounding > CertifyOptions{}.weld_tolerance * diagonal_of(surface))
            throw InputError(
                mesh.file + ": " + surface.name,
                "reading rounds its coordinates by up to " + rounding.str() + ", too much for its size",
                "move the stones nearer to the origin of the file, or convert it to OBJ");
    mesh.repairs.push_back("coordinates were read as 32-bit numbers: rounded by up to " + rounding.str());
}

/// Reads one file into metres. @returns surfaces; a refusal is written into `mesh`
std::vector<PolygonSurface> read(const MeshRequest& request, ImportedMesh& mesh)
{
    mesh.file = request.file.string();
    mesh.metres_per_unit = request.metres_per_unit;
    try {
        check(request);
        MeshFile content = read_mesh(request.file);
        mesh.repairs = content.repairs;
        judge_rounding(content, mesh);
        for (PolygonSurface& surface : content.surfaces)
            for (Eigen::Vector3d& x : surface.vertices) x = to_metres_z_up(x, request);
        return content.surfaces;
    } catch (const InputError& error) {
        mesh.reason = sentence(error);
    } catch (const std::bad_alloc&) {
        mesh.reason = mesh.file + ": reading it needs more memory than is allowed";
    }
    return {};
}

Eigen::Vector3d choose_origin(const std::vector<std::vector<PolygonSurface>>& files)
{
    Eigen::Vector3d lower = Eigen::Vector3d::Constant(1e300), upper = -lower;
    for (const auto& surfaces : files)
        for (const PolygonSurface& surface : surfaces)
            for (const Eigen::Vector3d& x : surface.vertices) {
                lower = lower.cwiseMin(x);
                upper = upper.cwiseMax(x);
            }
    const bool far = lower.x() <= upper.x() &&
                     std::max(lower.cwiseAbs().maxCoeff(), upper.cwiseAbs().maxCoeff()) > largest_plain_coordinate;
    if (!far) return Eigen::Vector3d::Zero();
    return (0.5 * lower + 0.5 * upper).array().round();
}

Stone certified(PolygonSurface surface, const Eigen::Vector3d& origin)
{
    for (Eigen::Vector3d& x : surface.vertices) x -= origin;
    CertifyOptions options;
    options.origin = origin;
    Certificate certificate = certify(std::move(surface), options);
    Stone stone;
    stone.name = certificate.name;
    stone.closed = certificate.closed;
    stone.convex = certificate.convex;
    stone.reason = certificate.reason;
    stone.repairs = certificate.repairs;
    stone.parts = certificate.parts;
    if (!stone.parts.empty()) stone.moments = moments_of(stone.parts);
    return stone;
}

void certify_all(std::vector<PolygonSurface> surfaces, const Eigen::Vector3d& origin, ImportedMesh& mesh)
{
    int refused = 0;
    std::string first;
    for (PolygonSurface& surface : surfaces) {
        mesh.stones.push_back(certified(std::move(surface), origin));
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
    for (const OverlappingPair& pair : find_overlaps(stones))
        overlaps.push_back({names[pair.a], names[pair.b], pair.volume});
    return overlaps;
}

}  // namespace

Geometry import_meshes(const std::vector<MeshRequest>& requests)
{
    Geometry geometry;
    std::vector<std::vector<PolygonSurface>> files;
    for (const MeshRequest& request : requests) {
        geometry.meshes.emplace_back();
        files.push_back(read(request, geometry.meshes.back()));
    }
    geometry.origin = choose_origin(files);
    for (std::size_t i = 0; i < files.size(); ++i)
        if (geometry.meshes[i].reason.empty())
            certify_all(std::move(files[i]), geometry.origin, geometry.meshes[i]);
    geometry.overlaps = overlaps_of(geometry.meshes);
    return geometry;
}

}  // namespace voussoir
