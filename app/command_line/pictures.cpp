// render, report and compare on the command line.
#include <CLI/CLI.hpp>

#include <memory>

#include "app/command_line/command_line.h"
#include "app/commands/commands.h"

namespace voussoir::app::command_line
{

namespace
{

/// A film instead of pictures.
void add_film(CLI::App& command, commands::RenderArguments& arguments)
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
void add_look(CLI::App& command, LookOptions& look)
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

void add_render(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::RenderArguments>();
    CLI::App* command = program.add_subcommand("render", "Draw pictures or a film from the results of a run");
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
        [arguments, &chosen] { chosen = [arguments] { return commands::render_command(*arguments); }; });
}

void add_report(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::ReportArguments>();
    CLI::App* command =
        program.add_subcommand("report", "The report of a run: a page with pictures, text and tables");
    command->add_option("results", arguments->results, "The folder of a run, or its results.h5")
        ->required()
        ->type_name("DIR|RESULTS");
    command->add_option("-o,--output", arguments->folder, "Folder for the report (that of the results)")
        ->type_name("DIR");
    command->add_flag("--no-film", arguments->no_film, "Make no film");
    command->add_flag("-q,--quiet", arguments->quiet, "Print the names of the files only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::report_command(*arguments); }; });
}

void add_compare(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::CompareArguments>();
    CLI::App* command = program.add_subcommand(
        "compare", "Two runs side by side: a page with tables, diagrams and a film of both");
    command->add_option("a", arguments->a, "The folder of a run, or its results.h5")->required()->type_name("A");
    command->add_option("b", arguments->b, "The same of another")->required()->type_name("B");
    command->add_option("-o,--output", arguments->folder, "Folder for the comparison (comparison)")
        ->type_name("DIR");
    command->add_flag("--no-film", arguments->no_film, "Make no film");
    command->add_flag("-q,--quiet", arguments->quiet, "Print the names of the files only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::compare_command(*arguments); }; });
}

}  // namespace

void add_picture_commands(CLI::App& program, std::function<int()>& chosen)
{
    add_render(program, chosen);
    add_report(program, chosen);
    add_compare(program, chosen);
}

}  // namespace voussoir::app::command_line
