#include <fmt/core.h>

#include <algorithm>

#include "app/reader/block_reading.h"
#include "importers/helper/repair_summary.h"
#include "libdda/geometry/plane.h"

namespace voussoir::app::reader
{
namespace
{

/// `unit: cm`: metres in one of the file's units; 0: what the file says, else metres.
double read_unit(YamlCursor& entry)
{
    const std::optional<YamlCursor> value = entry.find("unit");
    if (!value) {
        entry.took_default("unit", "as stated in the file, otherwise m");
        return 0;
    }
    const std::string name = value->as_text();
    const words::ParsedQuantity one = words::parse_quantity("1 " + name);
    if (one.problem.empty() && one.has(words::dimension::length) && !one.bare) return one.value;
    value->fault("\"" + name + "\" is not a unit of length", "expected m, cm, mm, ft, in or km");
    return 1;
}

/// One line for each kind of repair; the certificate has them all.
void warn_of_repairs(const std::string& place, const importers::helper::ImportedMesh& mesh, Findings& findings)
{
    for (const importers::helper::RepairSummary& kind : importers::helper::summarised_repairs(mesh))
        findings.warnings.push_back(fmt::format("{}: {}", place, importers::helper::in_words(kind)));
    for (const std::string& line : importers::helper::skipped_in_words(mesh))
        findings.warnings.push_back(fmt::format("{}: {}", place, line));
}

/// The answer of the geometry helper about one file, as faults, warnings and blocks.
void take_mesh(MeshEntry& entry, const importers::helper::ImportedMesh& mesh, BlockReading& reading)
{
    const std::string place = entry.file.place() + ": " + entry.name;
    warn_of_repairs(place, mesh, reading.findings);
    const std::size_t first = reading.model.blocks.size();
    bool stone_refused = false;
    for (const importers::helper::Stone& stone : mesh.stones) {
        const std::string stone_place = place + ": " + stone.name;
        stone_refused = stone_refused || !stone.reason.empty();
        if (!stone.reason.empty()) {
            reading.findings.faults.push_back({stone_place, stone.reason, cure_of(stone)});
        } else if (mesh.accepted) {
            add_block(stone.name, stone_place, stone.parts, reading, &stone.moments);
        }
    }
    refuse_unmatched_patterns(entry.chosen, mesh);
    if (!mesh.accepted && !stone_refused)
        reading.findings.faults.push_back(
            {place, mesh.reason,
             entry.request.copies.empty() ? "give another mesh" : "give another mesh, or fewer copies"});
    if (mesh.accepted)
        reading.entries.push_back({std::move(entry.belonging), first, reading.model.blocks.size(),
                                   "stones are named as the objects of the mesh"});
}

/// The places of a mesh's stones, with `suffix: _left`; none for stones that stand once, as they are drawn.
std::vector<PlacedCopy> read_mesh_copies(YamlCursor& entry, std::vector<PlacedCopy> copies)
{
    const std::string suffix = entry.find_text("suffix").value_or("");
    for (PlacedCopy& copy : copies) copy.suffix.insert(0, suffix);
    if (copies.size() == 1 && copies.front().is_as_drawn() && suffix.empty()) copies.clear();
    return copies;
}

}  // namespace

void read_mesh(YamlCursor& entry, const YamlCursor& file, BlockReading& reading)
{
    const std::size_t faults_before = reading.findings.faults.size();
    MeshEntry mesh{file, file.as_text(), {}, read_belonging(entry, reading.model, false), {}};
    mesh.request.file = reading.folder / mesh.name;
    mesh.request.copies = read_mesh_copies(entry, mesh.belonging.copies);
    mesh.request.metres_per_unit = read_unit(entry);
    const std::optional<char> up = entry.find_choice<char>("up", {{"x", 'x'}, {"y", 'y'}, {"z", 'z'}});
    if (!up) entry.took_default("up", "as stated in the file, otherwise z");
    mesh.request.up = up.value_or(0);
    mesh.request.stones =
        entry.choice_or<importers::helper::StoneLevel>("stones",
                                                       {{"detect", importers::helper::StoneLevel::detect},
                                                        {"file", importers::helper::StoneLevel::file},
                                                        {"object", importers::helper::StoneLevel::object},
                                                        {"group", importers::helper::StoneLevel::group},
                                                        {"node", importers::helper::StoneLevel::node},
                                                        {"component", importers::helper::StoneLevel::component}},
                                                       importers::helper::StoneLevel::detect);
    mesh.request.planarity =
        entry.quantity_or("planarity", words::dimension::number, words::Range{0, 0.01, false, true}, 1e-5);
    mesh.request.volume_error =
        entry.quantity_or("volume_error", words::dimension::number, words::Range{0, 0.2, false, true}, 0.01);
    mesh.request.fit_joints =
        entry.choice_or<importers::helper::FitJoints>("fit_joints",
                                                      {{"as_drawn", importers::helper::FitJoints::as_drawn},
                                                       {"shared", importers::helper::FitJoints::shared},
                                                       {"planar", importers::helper::FitJoints::planar}},
                                                      importers::helper::FitJoints::shared);
    mesh.request.close_joints =
        entry.quantity_or("close_joints", words::dimension::length, words::Range::non_negative(), 0);
    mesh.chosen = read_stone_choice(entry, mesh.request);
    entry.reject_unknown_keys();
    if (mesh.name.empty()) return;
    std::error_code none;
    if (!std::filesystem::is_regular_file(mesh.request.file, none))
        file.fault("no mesh file " + mesh.request.file.string(), "paths are relative to the case file");
    else if (reading.findings.faults.size() == faults_before)
        reading.meshes.push_back(std::move(mesh));
}

void import_meshes(BlockReading& reading)
{
    if (reading.meshes.empty()) return;
    std::vector<importers::helper::MeshRequest> requests;
    for (const MeshEntry& mesh : reading.meshes) requests.push_back(mesh.request);
    const importers::helper::Geometry& geometry = reading.findings.geometry =
        importers::helper::import_geometry(requests, {});
    reading.findings.mesh_place = reading.meshes.front().file.place();
    reading.mesh_origin = geometry.origin;
    Model& model = reading.model;
    model.origin = is_planar(model.kinematics) ? to_space(from_space<2>(geometry.origin)) : geometry.origin;
    for (Block& box : model.blocks) box.moments.centroid -= model.origin;
    for (std::size_t i = 0; i < reading.meshes.size(); ++i)
        take_mesh(reading.meshes[i], geometry.meshes.at(i), reading);
    for (const std::string& line : importers::helper::in_words(geometry.fit))
        reading.findings.warnings.push_back(fmt::format("{}: {}", reading.findings.mesh_place, line));
}

}  // namespace voussoir::app::reader
