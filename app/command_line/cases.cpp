// run, check, import, generate and record on the command line.
#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>

#include "app/command_line/command_line.h"
#include "app/commands/commands.h"
#include "importers/helper/geometry.h"

namespace voussoir::app::command_line
{

void add_overrides(CLI::App& command, std::vector<std::string>& overrides)
{
    command.add_option("--set", overrides, "Change a value: --set stages[1].time_step=\"1 ms\"; null removes it")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

namespace
{

void add_verbose(CLI::App& command, bool& verbose)
{
    command.add_flag("-v,--verbose", verbose, "Print every repair of every stone, not one line for each kind");
}

/// Where a geometry certificate goes.
void add_certificate(CLI::App& command, std::optional<std::filesystem::path>& json,
                     std::optional<std::filesystem::path>& folder)
{
    command.add_option("--json", json, "Write the certificate as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command
        .add_option("-o,--output", folder,
                    "Folder for certificate.json, contact_graph.csv and pictures of the stones and their defects")
        ->type_name("DIR");
}

void add_run(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::RunArguments>();
    CLI::App* command = program.add_subcommand("run", "Run a case and write its results");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    command->add_option("-o,--output", arguments->folder, "Folder for the results (results/<case name>)")
        ->type_name("DIR");
    command->add_flag("--resume", arguments->resume,
                      "Continue the interrupted or killed run of this case in the folder");
    command
        ->add_flag("--other-engine", arguments->other_engine,
                   "With --resume: continue a run that another build of the program began; the results say so")
        ->needs("--resume");
    command->add_flag("--accept-collapse", arguments->accept_collapse,
                      "A structure that falls is what was expected: exit code 0, not 5");
    command
        ->add_option(
            "--save-every", arguments->save_every,
            "Seconds of computing after which results and restart file are brought up to date on the disk: what "
            "a killed run loses at most, beside one frame; 0 does so with every frame")
        ->type_name("SECONDS")
        ->check(CLI::Range(0.0, 86400.0))
        ->capture_default_str();
    add_overrides(*command, arguments->overrides);
    command
        ->add_option_function<std::string>(
            "--threads",
            [arguments](const std::string& number) {
                if (number != "auto") arguments->threads = std::stoi(number);
            },
            "Number of threads; the results do not depend on it. auto: one for each core in scenes of more than a "
            "thousand blocks, else one")
        ->type_name("N|auto")
        ->check(CLI::Validator(
            [range = CLI::Range(1, 1024)](const std::string& number) {
                std::string text = number;
                return text == "auto" ? std::string() : range(text);
            },
            ""))
        ->default_str("auto");
    command->add_flag("-q,--quiet", arguments->quiet, "Print faults only");
    add_verbose(*command, arguments->verbose);
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::run_command(*arguments); }; });
}

void add_check(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::CheckArguments>();
    CLI::App* command =
        program.add_subcommand("check", "Read and check a case and list the model, without running it");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    add_overrides(*command, arguments->overrides);
    add_certificate(*command, arguments->json, arguments->folder);
    add_verbose(*command, arguments->verbose);
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::check_command(*arguments); }; });
}

/// Repeatable options that take one value each time, so that what follows them is not swallowed.
void add_stone_choice(CLI::App& command, commands::ImportArguments& arguments)
{
    const auto add = [&](const char* name, std::vector<std::string>& patterns, const char* help) {
        command.add_option(name, patterns, help)->type_name("PATTERN")->allow_extra_args(false);
    };
    add("--skip", arguments.skip, "Leave out stones of this name; * and ? stand for others. Repeatable");
    add("--only", arguments.only, "Leave out all stones but those of this name. Repeatable");
    add("--hull", arguments.hull, "Replace stones of this name by their convex hulls. Repeatable");
    add("--skip-type", arguments.skip_types, "Leave out items of this type of a building model: IfcWindow");
    command.add_option("--repair", arguments.repair, "What becomes of a stone that cannot be certified")
        ->check(CLI::IsMember(importers::helper::repair_rule_names))
        ->capture_default_str();
    command
        .add_option("--simplify", arguments.simplify,
                    "Simplify scanned stones, as in a case: hull or '{parts: 12, volume_error: 2 %}'")
        ->type_name("HOW");
}

void add_import(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::ImportArguments>();
    CLI::App* command =
        program.add_subcommand("import", "Check mesh files: stones, contacts, gaps, overlaps, advice");
    command->add_option("mesh", arguments->files, "Mesh files")->type_name("MESH");
    command->add_flag("--formats", arguments->formats, "List the supported formats and the reader of each");
    command->add_option("--reader", arguments->reader, "Reader of the files: automatic, own or assimp")
        ->check(CLI::IsMember(importers::helper::mesh_reader_names))
        ->capture_default_str();
    command
        ->add_option("--unit", arguments->unit,
                     "Unit of the files: m, cm, mm, ft, in (as stated in the files, otherwise m)")
        ->type_name("UNIT");
    command->add_option("--up", arguments->up, "Vertical axis of the files (as stated in the files, otherwise z)")
        ->transform(CLI::IsMember({"x", "y", "z"}));
    command->add_option("--stones", arguments->stones, "What is taken as one stone")
        ->check(CLI::IsMember(importers::helper::stone_level_names))
        ->capture_default_str();
    command
        ->add_option(
            "--planarity", arguments->planarity,
            "Deviation from a plane up to which a face is taken as flat, as a fraction of the stone's diagonal")
        ->check(CLI::Range(1e-9, 0.01))
        ->capture_default_str();
    command
        ->add_option("--volume-error", arguments->volume_error,
                     "Fraction of its volume by which the parts of a concave stone may exceed it")
        ->check(CLI::Range(1e-6, 0.2))
        ->capture_default_str();
    command
        ->add_option("--fit-joints", arguments->fit_joints,
                     "Joints whose two sides were drawn differently: one surface for both, a plane, or as drawn")
        ->check(CLI::IsMember(importers::helper::fit_joints_names))
        ->capture_default_str();
    command
        ->add_option("--close-joints", arguments->close_joints,
                     "Close gaps between facing faces up to this width: 25mm")
        ->type_name("LENGTH");
    add_stone_choice(*command, *arguments);
    add_certificate(*command, arguments->json, arguments->folder);
    add_verbose(*command, arguments->verbose);
    command->callback([arguments, &chosen] {
        if (arguments->files.empty() && !arguments->formats) throw CLI::RequiredError("mesh");
        chosen = [arguments] { return commands::import_command(*arguments); };
    });
}

void add_generate(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::GenerateArguments>();
    CLI::App* command = program.add_subcommand(
        "generate", "Write the stones of a case or of a pattern as OBJ, or as a case that lists every block");
    command
        ->add_option(
            "what", arguments->what,
            "A case file (.yaml), or a pattern: wall, house, arch, bridge, tower, column, temple_front, "
            "dome, barrel_vault, cross_vault, gate, buttress, flying_buttress, steps, obelisk, pinnacle, rock")
        ->required()
        ->type_name("CASE|PATTERN");
    command->add_option("keys", arguments->keys, "Keys of the pattern as in a case: span=\"10 m\" voussoirs=25")
        ->type_name("KEY=VALUE");
    command->add_option("-o,--output", arguments->output, "File to write: .obj or .yaml")
        ->required()
        ->type_name("FILE");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::generate_command(*arguments); }; });
}

void add_record(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::RecordArguments>();
    CLI::App* command =
        program.add_subcommand("record", "Inspect, process, measure, plot and convert accelerograms");
    command->add_option("file", arguments->files, "Accelerograms")->type_name("FILE");
    command
        ->add_option("--unit", arguments->unit, "Unit, if not stated in the file: g, m/s2, cm/s2, cm/s, mm, ...")
        ->type_name("UNIT");
    command->add_option("--time-step", arguments->time_step, "Time step in s, if not stated in the file")
        ->check(CLI::PositiveNumber)
        ->type_name("SECONDS");
    command->add_option("--column", arguments->column, "Column of a text table, from 1")
        ->check(CLI::Range(1, 10000));
    command->add_option("--response", arguments->response, "StationXML with the sensitivity of counts")
        ->type_name("FILE");
    command->add_flag("--together", arguments->together, "The files are components of one motion");
    command
        ->add_option("--process", arguments->process,
                     "Processing steps, as in a case: '[{window: {arias: [0.1 %, 99 %]}}, {taper: 1 s}]'")
        ->type_name("STEPS");
    command
        ->add_option("--motion", arguments->motion,
                     "A wave instead of files, as in a case: '{ricker: {acceleration: 0.3 g, frequency: 2 Hz}}'")
        ->type_name("WAVE");
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->folder, "Write CSV, AT2, spectra and pictures into a folder")
        ->type_name("DIR");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::record_command(*arguments); }; });
}

}  // namespace

void add_case_commands(CLI::App& program, std::function<int()>& chosen)
{
    add_run(program, chosen);
    add_check(program, chosen);
    add_import(program, chosen);
    add_generate(program, chosen);
    add_record(program, chosen);
}

}  // namespace voussoir::app::command_line
