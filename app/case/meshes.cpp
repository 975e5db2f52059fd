#include <fmt/core.h>

#include "app/case/block_reading.h"
#include "libdda/geometry/plane.h"

namespace voussoir
{
namespace
{

/// `unit: cm`: metres in one of the file's units.
double read_unit(YamlCursor& entry)
{
    const std::optional<YamlCursor> value = entry.find("unit");
    if (!value) {
        entry.took_default("unit", "m");
        return 1;
    }
    const std::string name = value->as_text();
    const ParsedQuantity one = parse_quantity("1 " + name);
    if (one.problem.empty() && one.has(dimension::length) && !one.bare) return one.value;
    value->fault("\"" + name + "\" is no unit of length", "expected m, cm, mm, ft, in or km");
    return 1;
}

void warn_of_repairs(const std::string& place, const std::vector<std::string>& repairs, Findings& findings)
{
    for (const std::string& repair : repairs) findings.warnings.push_back(fmt::format("{}: {}", place, repair));
}

/// The answer of the geometry helper about one file, as faults, warnings and blocks.
void take_mesh(MeshEntry& entry, const ImportedMesh& mesh, BlockReading& reading)
{
    const std::string place = entry.file.place() + ": " + entry.name;
    warn_of_repairs(place, mesh.repairs, reading.findings);
    bool stone_refused = false;
    for (const Stone& stone : mesh.stones) {
        const std::string stone_place = place + ": " + stone.name;
        warn_of_repairs(stone_place, stone.repairs, reading.findings);
        stone_refused = stone_refused || !stone.reason.empty();
        if (!stone.reason.empty()) {
            reading.findings.faults.push_back({stone_place, stone.reason, "mend the mesh"});
        } else if (mesh.accepted) {
            add_block(stone.name, stone_place, group_of(stone.name, entry.patterns), entry.material, stone.parts,
                      reading);
        }
    }
    if (!mesh.accepted && !stone_refused)
        reading.findings.faults.push_back({place, mesh.reason, "give another mesh"});
    if (!mesh.accepted) return;
    refuse_unused_patterns(entry.patterns, "stones are named as the objects of the mesh");
}

}  // namespace

void read_mesh(YamlCursor& entry, const YamlCursor& file, BlockReading& reading)
{
    MeshEntry mesh{file, file.as_text(), {}, 0, {}};
    mesh.request.file = reading.folder / mesh.name;
    mesh.material = read_material_name(entry, reading.model.materials);
    mesh.patterns = read_group_patterns(entry);
    mesh.request.metres_per_unit = read_unit(entry);
    mesh.request.up = entry.choice_or<char>("up", {{"x", 'x'}, {"y", 'y'}, {"z", 'z'}}, 'z');
    entry.reject_unknown_keys();
    if (mesh.name.empty()) return;
    if (!std::filesystem::is_regular_file(mesh.request.file))
        file.fault("no mesh file " + mesh.request.file.string(), "paths are relative to the case file");
    else
        reading.meshes.push_back(std::move(mesh));
}

void import_meshes(BlockReading& reading)
{
    if (reading.meshes.empty()) return;
    std::vector<MeshRequest> requests;
    for (const MeshEntry& mesh : reading.meshes) requests.push_back(mesh.request);
    const Geometry& geometry = reading.findings.geometry = import_geometry(requests, {});
    reading.mesh_origin = geometry.origin;
    Model& model = reading.model;
    model.origin = is_planar(model.kinematics) ? to_space(from_space<2>(geometry.origin)) : geometry.origin;
    for (Block& box : model.blocks) box.moments.centroid -= model.origin;
    for (std::size_t i = 0; i < reading.meshes.size(); ++i)
        take_mesh(reading.meshes[i], geometry.meshes.at(i), reading);
    for (const Overlap& overlap : geometry.overlaps)
        reading.findings.faults.push_back(
            {reading.meshes.front().file.place() + ": " + overlap.stone_a + " and " + overlap.stone_b,
             fmt::format("overlap by {:.3g} m3", overlap.volume), "stones may touch but not overlap"});
}

}  // namespace voussoir
