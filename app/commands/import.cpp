#include <fmt/format.h>

#include <algorithm>

#include "app/commands/certificate.h"
#include "app/commands/commands.h"
#include "app/commands/outputs.h"
#include "app/commands/say.h"
#include "app/reader/stone_choice.h"
#include "app/results/own_folder.h"
#include "app/words/nearest_word.h"
#include "app/words/quantity.h"
#include "importers/helper/geometry.h"
#include "importers/helper/repair_summary.h"
#include "importers/helper/wire.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

/// @param otherwise if the option is not given
double length_of(const std::optional<std::string>& text, const char* option, const std::string& factor,
                 double otherwise)
{
    if (!text) return otherwise;
    const words::ParsedQuantity length = words::parse_quantity(factor + *text);
    if (length.problem.empty() && !length.bare && length.has(words::dimension::length) && length.value > 0)
        return length.value;
    throw InputError(
        option + (" " + *text), factor.empty() ? "no length" : "no unit of length",
        factor.empty() ? "expected a length > 0 with its unit, such as 25mm" : "expected m, cm, mm, ft, in or km");
}

importers::helper::MeshRequest request_of(const ImportArguments& arguments)
{
    importers::helper::MeshRequest request;
    request.metres_per_unit = length_of(arguments.unit, "--unit", "1 ", 0);
    request.close_joints = length_of(arguments.close_joints, "--close-joints", "", 0);
    request.up = arguments.up.value_or(0);
    const auto level = std::find(importers::helper::stone_level_names.begin(),
                                 importers::helper::stone_level_names.end(), arguments.stones);
    request.stones =
        static_cast<importers::helper::StoneLevel>(level - importers::helper::stone_level_names.begin());
    const auto reader = std::find(importers::helper::mesh_reader_names.begin(),
                                  importers::helper::mesh_reader_names.end(), arguments.reader);
    request.reader =
        static_cast<importers::mesh::MeshReader>(reader - importers::helper::mesh_reader_names.begin());
    const auto fit = std::find(importers::helper::fit_joints_names.begin(),
                               importers::helper::fit_joints_names.end(), arguments.fit_joints);
    request.fit_joints =
        static_cast<importers::helper::FitJoints>(fit - importers::helper::fit_joints_names.begin());
    request.planarity = arguments.planarity;
    request.volume_error = arguments.volume_error;
    request.choice.skip = arguments.skip;
    request.choice.only = arguments.only;
    request.choice.hull = arguments.hull;
    request.choice.skip_types = arguments.skip_types;
    const auto& rules = importers::helper::repair_rule_names;
    request.choice.repair = static_cast<importers::helper::RepairRule>(
        std::find(rules.begin(), rules.end(), arguments.repair) - rules.begin());
    if (arguments.simplify) request.simplify = reader::parse_simplification(*arguments.simplify, "--simplify");
    return request;
}

/// One line for each kind of repair, or every repair.
void print_repairs(const importers::helper::ImportedMesh& mesh, bool verbose)
{
    if (verbose)
        for (const std::string& repair : importers::helper::all_repairs(mesh))
            say(fmt::format("  repaired: {}", repair));
    else
        for (const importers::helper::RepairSummary& kind : importers::helper::summarised_repairs(mesh))
            say(fmt::format("  repaired: {}", importers::helper::in_words(kind)));
    if (!verbose)
        for (const std::string& line : importers::helper::skipped_in_words(mesh)) say(fmt::format("  {}", line));
}

void print_mesh(const CertifiedFile& file, bool verbose)
{
    const importers::helper::ImportedMesh& mesh = file.mesh;
    say(fmt::format("{}: {}, {} stones, unit {:g} m ({})", mesh.file, mesh.accepted ? "accepted" : "refused",
                    mesh.stones.size(), mesh.metres_per_unit, mesh.unit_from));
    print_repairs(mesh, verbose);
    for (const std::string& line : importers::helper::in_words(file.fit)) say(fmt::format("  {}", line));
    for (std::size_t i = 0; i < std::min(mesh.stones.size(), max_rows); ++i) {
        const importers::helper::Stone& stone = mesh.stones[i];
        if (stone.reason.empty())
            say(fmt::format("  {}: {} convex part{}, {:.6g} m3", stone.name, stone.parts.size(),
                            stone.parts.size() == 1 ? "" : "s", stone.moments.volume));
    }
    if (mesh.stones.size() > max_rows)
        say(fmt::format("  and {} more stones: --json has them all", mesh.stones.size() - max_rows));
    print_contact_graph(file.assembly);
    print_findings(file.assembly);
}

void print_refusals(const importers::helper::ImportedMesh& mesh)
{
    if (mesh.accepted) return;
    bool said = false;
    for (const importers::helper::Stone& stone : mesh.stones)
        if (!stone.reason.empty()) {
            complain(fmt::format("{}: {}: {}; {}", mesh.file, stone.name, stone.reason, reader::cure_of(stone)));
            said = true;
        }
    if (!said) complain(fmt::format("{}: {}", mesh.file, mesh.reason));
}

/// A pattern that matches no stone of any file is a mistake; files may have different names.
void refuse_unmatched_patterns(const std::vector<CertifiedFile>& files)
{
    std::vector<Fault> faults;
    for (const importers::helper::UnmatchedPattern& pattern : files.front().mesh.unmatched) {
        std::vector<std::string> names;
        bool everywhere = true;
        for (const CertifiedFile& file : files) {
            everywhere =
                everywhere && std::any_of(file.mesh.unmatched.begin(), file.mesh.unmatched.end(),
                                          [&](const importers::helper::UnmatchedPattern& other) {
                                              return other.key == pattern.key && other.pattern == pattern.pattern;
                                          });
            for (std::string& name : reader::names_of_stones(file.mesh)) names.push_back(std::move(name));
        }
        if (everywhere)
            faults.push_back({pattern.key, "\"" + pattern.pattern + "\" matches no stone",
                              words::suggestion(pattern.pattern, names)});
    }
    if (!faults.empty()) throw InputError(std::move(faults));
}

/// One file by itself: a file that kills the reader or lies far away does not touch the others.
importers::helper::Geometry import_alone(const importers::helper::MeshRequest& request)
{
    std::error_code error;
    if (std::filesystem::is_regular_file(request.file, error))
        return importers::helper::import_geometry({request}, {});
    importers::helper::Geometry none;
    importers::helper::ImportedMesh& mesh = none.meshes.emplace_back();
    mesh.file = request.file.string();
    mesh.reason = "no such file";
    return none;
}

CertifiedFile certify(const importers::helper::MeshRequest& request)
{
    importers::helper::Geometry geometry = import_alone(request);
    CertifiedFile file;
    file.mesh = std::move(geometry.meshes.front());
    file.origin = geometry.origin;
    file.overlaps = std::move(geometry.overlaps);
    file.fit = geometry.fit;
    importers::assembly::AssemblyOrigin origin;
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

/// @returns whether everything is there
bool write_folder(const ImportArguments& arguments, const std::vector<CertifiedFile>& files)
{
    bool complete = true;
    make_output_folder(*arguments.folder);
    write_own_file(*arguments.folder / "certificate.json", certificates_json(files) + "\n");
    for (std::size_t i = 0; i < files.size(); ++i) {
        const std::filesystem::path folder = folder_of(arguments, i);
        if (files.size() > 1) results::make_own_folder(folder);
        write_contact_graph(files[i].assembly, folder / "contact_graph.csv");
        complete =
            draw_certificate(arguments.files[i].filename().string(), files[i].assembly, {files[i].mesh}, folder) &&
            complete;
    }
    return complete;
}

int list_formats(const ImportArguments& arguments)
{
    const std::vector<importers::mesh::MeshFormat> formats = importers::helper::list_mesh_formats();
    if (arguments.json) write_json_text(*arguments.json, importers::helper::to_json(formats));
    if (arguments.json && *arguments.json == "-") return exit_done;
    say(fmt::format("{:<34} {:<21} {:<9} {}", "format", "extensions", "read by", "lost"));
    for (const importers::mesh::MeshFormat& format : formats) {
        const std::string extensions = fmt::format("{}", fmt::join(format.extensions, " "));
        say(fmt::format("{:<34} {:<21} {:<9} {}", format.name, extensions, format.own ? "voussoir" : "assimp",
                        format.lost.empty() ? "nothing" : format.lost));
    }
    return exit_done;
}

}  // namespace

int import_command(const ImportArguments& arguments)
{
    if (arguments.formats) return list_formats(arguments);
    importers::helper::MeshRequest request = request_of(arguments);
    expect_writable(arguments.json, arguments.folder);
    std::vector<CertifiedFile> files;
    bool any_refused = false;
    const bool to_stdout = arguments.json && *arguments.json == "-";
    for (const std::filesystem::path& path : arguments.files) {
        request.file = path;
        files.push_back(certify(request));
        any_refused = any_refused || !files.back().mesh.accepted;
        if (!to_stdout) print_mesh(files.back(), arguments.verbose);
        print_refusals(files.back().mesh);
    }
    if (!files.empty()) refuse_unmatched_patterns(files);
    if (arguments.json) write_json_text(*arguments.json, certificates_json(files));
    bool complete = true;
    if (arguments.folder) {
        complete = write_folder(arguments, files);
        if (!to_stdout) say(fmt::format("written to {}", arguments.folder->string()));
    }
    if (any_refused) return exit_bad_input;
    return complete ? exit_done : exit_failure;
}

}  // namespace voussoir::app::commands
