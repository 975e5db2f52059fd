#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "app/case/quantity.h"
#include "app/commands/commands.h"
#include "app/commands/outputs.h"
#include "app/geometry/geometry.h"
#include "libdda/errors.h"

namespace voussoir
{
namespace
{

using nlohmann::json;

double metres_per_unit(const std::optional<std::string>& unit)
{
    if (!unit) return 1;
    const ParsedQuantity one = parse_quantity("1 " + *unit);
    if (one.problem.empty() && !one.bare && one.has(dimension::length)) return one.value;
    throw InputError("--unit " + *unit, "no unit of length", "expected m, cm, mm, ft, in or km");
}

/// Where the unit came from. The helper is asked with a unit and says which one it used, so one that differs from
/// what was asked is the file's own.
std::string unit_source(const ImportArguments& arguments, const ImportedMesh& mesh)
{
    if (mesh.metres_per_unit != metres_per_unit(arguments.unit)) return "file";
    return arguments.unit ? "option" : "assumed";
}

json to_json(const Stone& stone, const ImportedMesh& mesh, const Eigen::Vector3d& origin)
{
    const Eigen::Vector3d centroid = stone.moments.centroid + origin;
    const double cube = mesh.metres_per_unit * mesh.metres_per_unit * mesh.metres_per_unit;
    const bool measured = !stone.parts.empty();
    return {{"name", stone.name},
            {"closed", stone.closed},
            {"convex", stone.convex},
            {"parts", stone.parts.size()},
            {"volume_file_units", measured ? json(stone.moments.volume / cube) : json()},
            {"volume_m3", measured ? json(stone.moments.volume) : json()},
            {"centroid_m", measured ? json({centroid.x(), centroid.y(), centroid.z()}) : json()},
            {"repairs", stone.repairs},
            {"reason", stone.reason}};
}

json to_json(const ImportArguments& arguments, const Geometry& geometry, const ImportedMesh& mesh)
{
    json stones = json::array(), overlaps = json::array();
    for (const Stone& stone : mesh.stones) stones.push_back(to_json(stone, mesh, geometry.origin));
    for (const Overlap& overlap : geometry.overlaps)
        overlaps.push_back({{"stones", {overlap.stone_a, overlap.stone_b}}, {"volume_m3", overlap.volume}});
    return {{"file", mesh.file},
            {"accepted", mesh.accepted},
            {"reason", mesh.reason},
            {"repairs", mesh.repairs},
            {"unit", {{"metres", mesh.metres_per_unit}, {"from", unit_source(arguments, mesh)}}},
            {"overlaps", overlaps},
            {"stones", stones}};
}

void print_mesh(const ImportArguments& arguments, const Geometry& geometry, const ImportedMesh& mesh)
{
    fmt::print("{}: {}, {} stones, unit {:g} m ({})\n", mesh.file, mesh.accepted ? "accepted" : "refused",
               mesh.stones.size(), mesh.metres_per_unit, unit_source(arguments, mesh));
    for (const std::string& repair : mesh.repairs) fmt::print("  repaired: {}\n", repair);
    for (const Stone& stone : mesh.stones) {
        if (stone.reason.empty())
            fmt::print("  {}: {} convex part{}, {:.6g} m3\n", stone.name, stone.parts.size(),
                       stone.parts.size() == 1 ? "" : "s", stone.moments.volume);
        for (const std::string& repair : stone.repairs) fmt::print("  {}: repaired: {}\n", stone.name, repair);
    }
    for (const Overlap& overlap : geometry.overlaps)
        fmt::print("  {} and {} overlap by {:.3g} m3\n", overlap.stone_a, overlap.stone_b, overlap.volume);
}

void print_refusals(const ImportedMesh& mesh)
{
    if (mesh.accepted) return;
    bool said = false;
    for (const Stone& stone : mesh.stones)
        if (!stone.reason.empty()) {
            fmt::print(stderr, "{}: {}: {}\n", mesh.file, stone.name, stone.reason);
            said = true;
        }
    if (!said) fmt::print(stderr, "{}: {}\n", mesh.file, mesh.reason);
}

/// One file by itself: a file that kills the reader or lies far away does not touch the others.
Geometry import_alone(const std::filesystem::path& file, double metres, char up)
{
    if (std::filesystem::is_regular_file(file)) return import_geometry({{file, metres, up}}, {});
    Geometry none;
    ImportedMesh& mesh = none.meshes.emplace_back();
    mesh.file = file.string();
    mesh.reason = "no such file";
    mesh.metres_per_unit = metres;
    return none;
}

}  // namespace

int import_command(const ImportArguments& arguments)
{
    const double metres = metres_per_unit(arguments.unit);
    json certificates = json::array();
    bool any_refused = false;
    const bool to_stdout = arguments.json && *arguments.json == "-";
    for (const std::filesystem::path& file : arguments.files) {
        const Geometry geometry = import_alone(file, metres, arguments.up);
        const ImportedMesh& mesh = geometry.meshes.front();
        any_refused = any_refused || !mesh.accepted;
        certificates.push_back(to_json(arguments, geometry, mesh));
        if (!to_stdout) print_mesh(arguments, geometry, mesh);
        print_refusals(mesh);
    }
    if (arguments.json) write_json_text(*arguments.json, certificates.dump(2));
    return any_refused ? exit_bad_input : exit_done;
}

}  // namespace voussoir
