// voussoir: what an earthquake does to stone structures, block by block. The command line and the exit codes.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <sstream>

#include "app/commands/commands.h"
#include "app/commands/say.h"
#include "app/version/version.h"
#include "importers/helper/geometry.h"
#include "importers/process/program_start.h"
#include "libdda/errors.h"

namespace
{

using namespace voussoir;

/// A repeatable option that takes one value each time, so that what follows it is not swallowed.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides)
{
    command.add_option("--set", overrides, "Change a value: --set stages[1].time_step=\"1 ms\"; null removes it")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

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

void add_run(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::RunArguments>();
    CLI::App* command = app.add_subcommand("run", "Run a case and write its results");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    command->add_option("-o,--output", arguments->folder, "Folder for the results (results/<case name>)")
        ->type_name("DIR");
    command->add_flag("--resume", arguments->resume,
                      "Continue the interrupted or killed run of this case in the folder");
    command
        ->add_flag("--other-engine", arguments->other_engine,
                   "With --resume: continue a run that another build of the program began; the results say so")
        ->needs("--resume");
    add_overrides(*command, arguments->overrides);
    command
        ->add_option("--threads", arguments->threads,
                     "Number of threads; the results do not depend on it. More than one is worthwhile on an "
                     "otherwise idle machine")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_flag("-q,--quiet", arguments->quiet, "Print faults only");
    add_verbose(*command, arguments->verbose);
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::run_command(*arguments); }; });
}

void add_check(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::CheckArguments>();
    CLI::App* command =
        app.add_subcommand("check", "Read and check a case and list the model, without running it");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    add_overrides(*command, arguments->overrides);
    add_certificate(*command, arguments->json, arguments->folder);
    add_verbose(*command, arguments->verbose);
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::check_command(*arguments); }; });
}

/// Repeatable options that take one value each time, so that what follows them is not swallowed.
void add_stone_choice(CLI::App& command, app::commands::ImportArguments& arguments)
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

void add_import(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::ImportArguments>();
    CLI::App* command = app.add_subcommand("import", "Check mesh files: stones, contacts, gaps, overlaps, advice");
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
        chosen = [arguments] { return app::commands::import_command(*arguments); };
    });
}

void add_generate(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::GenerateArguments>();
    CLI::App* command = app.add_subcommand(
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
        [arguments, &chosen] { chosen = [arguments] { return app::commands::generate_command(*arguments); }; });
}

void add_record(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::RecordArguments>();
    CLI::App* command = app.add_subcommand("record", "Inspect, process, measure, plot and convert accelerograms");
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
        [arguments, &chosen] { chosen = [arguments] { return app::commands::record_command(*arguments); }; });
}

/// A film instead of pictures.
void add_film(CLI::App& command, app::commands::RenderArguments& arguments)
{
    CLI::Option* film = command.add_option_function<std::string>(
        "--video", [&arguments](const std::string& file) { arguments.film = file; },
        "A film instead of pictures, by its ending .mp4, .gif or .webp (video.mp4 beside the results); needs "
        "ffmpeg");
    film->expected(0, 1)->default_str("")->type_name("FILE")->excludes("--times");
    command.add_option("--fps", arguments.frames_per_second, "Frames of the film per second")
        ->check(CLI::Range(1.0, 120.0))
        ->needs(film)
        ->capture_default_str();
    command.add_option("--slow-down", arguments.slow_down, "Seconds of film for a second of the run")
        ->check(CLI::Range(1e-3, 1e4))
        ->needs(film)
        ->capture_default_str();
}

/// What is seen of the structure, and from where.
void add_look(CLI::App& command, app::LookOptions& look)
{
    const auto add = [&](const char* name, std::vector<std::string>& values, const char* type, const char* help) {
        command.add_option(name, values, help)->type_name(type)->allow_extra_args(false);
    };
    add("--hide", look.hidden, "PATTERN",
        "Leave out stones or groups of this name; * and ? stand for others. Repeatable");
    add("--cut", look.cuts, "PLACE", "Leave out stones there, by their centroid in m: x>1.5. Repeatable");
    add("--label", look.labels, "PATTERN", "Write the names of these stones beside them. Repeatable");
    command
        .add_option("--view", look.view,
                    "front, right, back, left, top, or AZIMUTH,ELEVATION in degrees: 30,20 (from aside)")
        ->type_name("VIEW");
    command
        .add_option("--follow", look.follow,
                    "The camera goes with these stones, or with the \"structure\" without its foundations")
        ->type_name("PATTERN");
    command.add_flag("--orthographic", look.orthographic, "Without perspective, as drawings are");
    command.add_flag("--forces", look.forces, "Draw the contact forces and the line of thrust");
    command.add_flag("--ground", look.ground,
                     "Draw the acceleration of the ground as an arrow at the foundations");
    command.add_option("--orbit", look.orbit, "Degrees by which the viewer turns in the course of a film")
        ->check(CLI::Number)
        ->type_name("DEGREES");
}

void add_render(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::RenderArguments>();
    CLI::App* command = app.add_subcommand("render", "Draw pictures or a film from the results of a run");
    command->add_option("results", arguments->results, "The results.h5 of a run")
        ->required()
        ->type_name("RESULTS");
    command
        ->add_option("-o,--output", arguments->folder, "Folder for the pictures (snapshots/ beside the results)")
        ->type_name("DIR");
    command->add_option("--color", arguments->color, "What the colours show")
        ->check(CLI::IsMember({"displacement", "principal_stress", "velocity", "opening", "slip", "friction",
                               "principal_strain", "group"}))
        ->capture_default_str();
    command->add_option("--times", arguments->times, "Times to draw, in s")->check(CLI::NonNegativeNumber);
    command->add_option("--count", arguments->count, "Number of pictures, if no times are given")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command->add_option("--size", arguments->size, "Width and height in pixels (1600 900, of a film 1280 720)")
        ->expected(2)
        ->check(CLI::Range(200, 8000));
    command->add_option("--deformation-scale", arguments->deformation_scale, "Magnification of displacements")
        ->check(CLI::PositiveNumber);
    command->add_option("--jobs", arguments->jobs, "Pictures drawn at once; 0: as many as there are cores")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    add_look(*command, arguments->look);
    add_film(*command, *arguments);
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::render_command(*arguments); }; });
}

void add_report(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::ReportArguments>();
    CLI::App* command = app.add_subcommand("report", "The report of a run: a page with pictures, text and tables");
    command->add_option("results", arguments->results, "The folder of a run, or its results.h5")
        ->required()
        ->type_name("DIR|RESULTS");
    command->add_option("-o,--output", arguments->folder, "Folder for the report (that of the results)")
        ->type_name("DIR");
    command->add_flag("--no-film", arguments->no_film, "Make no film");
    command->add_flag("-q,--quiet", arguments->quiet, "Print the names of the files only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::report_command(*arguments); }; });
}

void add_compare(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::CompareArguments>();
    CLI::App* command =
        app.add_subcommand("compare", "Two runs side by side: a page with tables, diagrams and a film of both");
    command->add_option("a", arguments->a, "The folder of a run, or its results.h5")->required()->type_name("A");
    command->add_option("b", arguments->b, "The same of another")->required()->type_name("B");
    command->add_option("-o,--output", arguments->folder, "Folder for the comparison (comparison)")
        ->type_name("DIR");
    command->add_flag("--no-film", arguments->no_film, "Make no film");
    command->add_flag("-q,--quiet", arguments->quiet, "Print the names of the files only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::compare_command(*arguments); }; });
}

void add_verify(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::VerifyArguments>();
    CLI::App* command = app.add_subcommand("verify", "Run the benchmarks of the papers: error against run time");
    command->add_option("name", arguments->names, "Benchmarks (all)")->type_name("NAME");
    command->add_flag("--list", arguments->list, "List the benchmarks, run nothing");
    command->add_flag("--sweep", arguments->sweep,
                      "Also vary time steps, methods and stiffnesses; CPU times as medians of 3");
    command->add_option("--seed", arguments->seed, "Of the benchmarks that draw their points")
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->folder, "Folder for the page, and with --sweep for the diagrams")
        ->type_name("DIR");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::verify_command(*arguments); }; });
}

void add_stability(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::StabilityArguments>();
    CLI::App* command =
        app.add_subcommand("stability", "Stiff and extreme scenes, each in its own process: a failure map");
    command->add_option("name", arguments->names, "Scenes or cells (all)")->type_name("NAME");
    command->add_flag("--list", arguments->list, "List the cells, run nothing");
    command->add_option("--jobs", arguments->jobs, "Number of cells run in parallel")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command
        ->add_option("--tolerance-factor", arguments->tolerance_factor,
                     "Factor on the tolerance of every cell, to find the margin")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command
        ->add_option("-o,--output", arguments->folder,
                     "Folder for stability.md, the maps as pictures and stability.json")
        ->type_name("DIR");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::stability_command(*arguments); }; });
}

/// A repeatable option whose values are separated by commas.
template <typename Value>
CLI::Option* add_list(CLI::App& command, const std::string& name, std::vector<Value>& values,
                      const std::string& help)
{
    return command.add_option(name, values, help)->delimiter(',')->allow_extra_args(false);
}

/// What converge varies.
void add_series(CLI::App& command, app::commands::ConvergeArguments& arguments)
{
    add_list(command, "--time-steps", arguments.time_steps,
             "Dynamic time steps (the case's x 4, 2, 1, 1/2, 1/4; of a threshold x 2, 1, 1/2)")
        ->type_name("TIME,...");
    add_list(
        command, "--stiffness-factors", arguments.stiffness_factors,
        "Factors on the case's contact stiffness (0.25, 0.5, 1, 2, 4; of a threshold 1, 2); 1 alone omits the "
        "series")
        ->type_name("FACTOR,...");
    add_list(command, "--integrators", arguments.integrators,
             "Beside the case's own: newmark, energy_decaying (the latter, but not of a threshold)")
        ->type_name("NAME,...");
}

/// What converge compares, and what counts as a collapse.
void add_quantities(CLI::App& command, app::commands::ConvergeArguments& arguments)
{
    CLI::Option* quantity = add_list(command, "--quantity", arguments.quantities,
                                     "Quantities to compare: POINT.u, .ux, .d (relative to the ground), .v ... or "
                                     "largest, with :history, :peak or :end");
    quantity->type_name("NAME,...");
    CLI::Option* threshold =
        command.add_option("--threshold", arguments.threshold,
                           "Compare the value at which the structure collapses, found between "
                           "one at which it stands and one at which it collapses; any key that --set takes, or "
                           "several between commas");
    threshold->type_name("KEY=STANDS..COLLAPSES")->excludes(quantity);
    command.add_option("--bracket", arguments.bracket, "Width of the bracket of a threshold")
        ->type_name("FRACTION")
        ->needs(threshold)
        ->capture_default_str();
    command
        .add_option("--tolerance", arguments.tolerance, "Wanted error, by which the conclusion chooses a setting")
        ->type_name("FRACTION")
        ->capture_default_str();
    command
        .add_option("--collapse-displacement", arguments.collapse_displacement,
                    "Displacement of a block, as a multiple of its size or a length, that is taken as collapse; "
                    "none: no collapse criterion")
        ->type_name("SIZES|LENGTH|none")
        ->capture_default_str();
}

void add_converge(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::ConvergeArguments>();
    CLI::App* command =
        app.add_subcommand("converge", "Error against run time of your own case: time step and contact stiffness");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    add_quantities(*command, *arguments);
    add_series(*command, *arguments);
    add_overrides(*command, arguments->overrides);
    command
        ->add_option("--threads", arguments->threads,
                     "Number of threads; CPU times are then totals over all threads")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->folder, "Folder for the page and the diagrams")
        ->type_name("DIR");
    command->add_flag("-q,--quiet", arguments->quiet, "Print faults only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::converge_command(*arguments); }; });
}

void add_ensemble(CLI::App& app, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<app::commands::EnsembleArguments>();
    CLI::App* command = app.add_subcommand(
        "ensemble", "Nearly identical runs of your own case: medians and spread at time steps h and h/2");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    command
        ->add_option("--vary", arguments->vary,
                     "The varied key and its values, one for each member: blocks[0].house.imperfection.seed=1,2,3")
        ->required()
        ->type_name("KEY=VALUE,VALUE,...");
    command->add_option("--open", arguments->open, "Joints open by more than this are counted")
        ->type_name("LENGTH")
        ->capture_default_str();
    command
        ->add_option("--stiffness-factor", arguments->stiffness_factor,
                     "Also with the case's contact stiffness times this factor; 1 omits it")
        ->check(CLI::Range(1e-3, 1e3))
        ->capture_default_str();
    add_overrides(*command, arguments->overrides);
    command->add_option("--jobs", arguments->jobs, "Number of runs in parallel, each on one thread")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->folder, "Folder for the page and the diagram")->type_name("DIR");
    command->add_flag("-q,--quiet", arguments->quiet, "Print faults only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return app::commands::ensemble_command(*arguments); }; });
}

/// Runs the chosen command; what it throws becomes a message and an exit code.
int guarded(const std::function<int()>& command)
{
    try {
        return command();
    } catch (const InputError& error) {
        app::commands::complain(error);
        return app::commands::exit_bad_input;
    } catch (const std::filesystem::filesystem_error& error) {
        app::commands::complain(error.path1().string() + ": " + error.code().message() + "; name another one");
        return app::commands::exit_bad_input;
    } catch (const std::bad_alloc&) {
        app::commands::complain("voussoir: out of memory");
    } catch (const std::exception& error) {
        app::commands::complain(std::string("voussoir: ") + error.what());
    }
    return app::commands::exit_failure;
}

/// What the command line asks for by itself, --help, or is wrong with it. @returns the exit code
int answer(const CLI::App& app, const CLI::ParseError& error)
{
    std::ostringstream text, faults;
    const bool done = app.exit(error, text, faults) == 0;
    app::commands::say_lines(text.str());
    // Of two lines: the fault, with what was typed, and where help is.
    std::string fault = faults.str();
    if (!fault.empty() && fault.back() == '\n') fault.pop_back();
    const std::size_t help = std::min(fault.rfind('\n'), fault.size());
    for (const std::string& line : {fault.substr(0, help), fault.substr(std::min(help + 1, fault.size()))})
        if (!line.empty()) app::commands::complain(line);
    return done ? app::commands::exit_done : app::commands::exit_bad_input;
}

/// Nobody asks for words that nobody can read: a run of the program that lost some of them has failed.
int heard(int code)
{
    const std::string reason = app::commands::unsaid();
    if (reason.empty()) return code;
    app::commands::complain("standard output: cannot be written: " + reason +
                            "; what it should have said is lost");
    return code == app::commands::exit_done ? app::commands::exit_failure : code;
}

int run_program(int argument_count, char** arguments)
{
    CLI::App app{"Seismic analysis of stone structures, block by block (3D discontinuous deformation analysis)",
                 "voussoir"};
    app.set_version_flag("--version", "voussoir " + app::version::in_words(app::version::engine_version()));
    app.require_subcommand(1);
    app.footer("Exit codes: 0 done, 1 failure, 2 bad input, 3 the analysis failed to converge, 4 interrupted.");
    std::function<int()> chosen;
    add_run(app, chosen);
    add_check(app, chosen);
    add_import(app, chosen);
    add_generate(app, chosen);
    add_record(app, chosen);
    add_render(app, chosen);
    add_report(app, chosen);
    add_compare(app, chosen);
    add_verify(app, chosen);
    add_converge(app, chosen);
    add_ensemble(app, chosen);
    add_stability(app, chosen);
    try {
        app.parse(argument_count, arguments);
    } catch (const CLI::ParseError& error) {
        return heard(answer(app, error));
    }
    return heard(guarded(chosen));
}

}  // namespace

int main(int argument_count, char** arguments)
{
    importers::process::begin_program();
    try {
        return run_program(argument_count, arguments);
    } catch (...) {  // even the message could not be made
        std::fputs("voussoir: out of memory\n", stderr);
        return app::commands::exit_failure;
    }
}
