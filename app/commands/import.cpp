#include <fmt/core.h>

#include <algorithm>

#include "app/case/quantity.h"
#include "app/commands/certificate.h"
#include "app/commands/commands.h"
#include "app/commands/outputs.h"
#include "app/geometry/geometry.h"
#include "libdda/errors.h"

namespace voussoir
{
namespace
{

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

void print_mesh(const CertifiedFile& file)
{
    const ImportedMesh& mesh = file.mesh;
    fmt::print("{}: {}, {} stones, unit {:g} m ({})\n", mesh.file, mesh.accepted ? "accepted" : "refused",
               mesh.stones.size(), mesh.metres_per_unit, file.unit_from);
    for (const std::string& repair : mesh.repairs) fmt::print("  repaired: {}\n", repair);
    for (std::size_t i = 0; i < std::min(mesh.stones.size(), most_rows); ++i) {
        const Stone& stone = mesh.stones[i];
        if (stone.reason.empty())
            fmt::print("  {}: {} convex part{}, {:.6g} m3\n", stone.name, stone.parts.size(),
                       stone.parts.size() == 1 ? "" : "s", stone.moments.volume);
        for (const std::string& repair : stone.repairs) fmt::print("  {}: repaired: {}\n", stone.name, repair);
    }
    if (mesh.stones.size() > most_rows)
        fmt::print("  and {} more stones: --json has them all\n", mesh.stones.size() - most_rows);
    print_contact_graph(file.assembly);
    print_findings(file.assembly);
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

CertifiedFile certify(const ImportArguments& arguments, const std::filesystem::path& path, double metres)
{
    Geometry geometry = import_alone(path, metres, arguments.up);
    CertifiedFile file;
    file.mesh = std::move(geometry.meshes.front());
    file.origin = geometry.origin;
    file.unit_from = unit_source(arguments, file.mesh);
    file.overlaps = std::move(geometry.overlaps);
    AssemblyOrigin origin;
    origin.metres_per_unit = file.mesh.metres_per_unit;
    file.assembly = assembly_of({file.mesh}, file.overlaps, origin);
    return file;
}

/// Where the contact graph and the pictures of a file go: the folder itself, or one below it for each of many.
std::filesystem::path folder_of(const ImportArguments& arguments, std::size_t number)
{
    if (arguments.files.size() == 1) return *arguments.folder;
    const std::string stem = arguments.files[number].stem().string();
    return *arguments.folder / fmt::format("{:02}_{}", number + 1, stem.empty() ? "file" : stem);
}

void write_folder(const ImportArguments& arguments, const std::vector<CertifiedFile>& files)
{
    make_output_folder(*arguments.folder);
    write_json_text(*arguments.folder / "certificate.json", certificates_json(files));
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::filesystem::path folder = folder_of(arguments, i);
        make_output_folder(folder);
        write_contact_graph(files[i].assembly, folder / "contact_graph.csv");
        draw_certificate(arguments.files[i].filename().string(), files[i].assembly, {files[i].mesh}, folder);
    }
}

}  // namespace

int import_command(const ImportArguments& arguments)
{
    const double metres = metres_per_unit(arguments.unit);
    expect_writable(arguments.json, arguments.folder);
    std::vector<CertifiedFile> files;
    bool any_refused = false;
    const bool to_stdout = arguments.json && *arguments.json == "-";
    for (const std::filesystem::path& path : arguments.files) {
        files.push_back(certify(arguments, path, metres));
        any_refused = any_refused || !files.back().mesh.accepted;
        if (!to_stdout) print_mesh(files.back());
        print_refusals(files.back().mesh);
    }
    if (arguments.json) write_json_text(*arguments.json, certificates_json(files));
    if (arguments.folder) {
        write_folder(arguments, files);
        if (!to_stdout) fmt::print("written to {}\n", arguments.folder->string());
    }
    return any_refused ? exit_bad_input : exit_done;
}

}  // namespace voussoir
