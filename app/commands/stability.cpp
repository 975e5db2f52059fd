#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/commands/commands.h"
#include "app/commands/outputs.h"
#include "app/commands/say.h"
#include "app/commands/study_output.h"
#include "app/golden/hashes.h"
#include "app/reader/case_file.h"
#include "app/results/atomic_file.h"
#include "app/results/own_folder.h"
#include "app/studies/stability/cell_wire.h"
#include "app/studies/stability/maps.h"
#include "app/studies/stability/page.h"
#include "app/studies/stability/runner.h"
#include "app/studies/stability/sound_range.h"
#include "app/version/version.h"
#include "app/words/figures_in_words.h"
#include "app/words/nearest_word.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

namespace fs = std::filesystem;

/// The named cells and those of the named scenes, in the order of the map; all of them without names.
/// @throws InputError with every name that is none
std::vector<studies::stability::StabilityCell> chosen(
    const std::vector<std::string>& names, const std::vector<studies::stability::StabilityScene>& scenes)
{
    std::vector<std::string> known;
    std::vector<studies::stability::StabilityCell> cells;
    const auto named = [&](const std::string& name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const studies::stability::StabilityScene& scene : scenes) {
        known.push_back(scene.name);
        for (const studies::stability::StabilityCell& cell : scene.cells) {
            known.push_back(cell.name);
            if (named(scene.name) || named(cell.name)) cells.push_back(cell);
        }
    }
    std::vector<Fault> faults;
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            faults.push_back(
                {"stability " + name, "there is no such scene or cell", words::suggestion(name, known)});
    if (!faults.empty()) throw InputError(std::move(faults));
    return cells;
}

void list(const std::vector<studies::stability::StabilityCell>& cells)
{
    for (const studies::stability::StabilityCell& cell : cells)
        say(fmt::format("{:<44} within {} of: {}; budget {:g} s", cell.name, words::error_in_words(cell.tolerance),
                        cell.reference, cell.budget));
}

std::string command_line(const StabilityArguments& arguments)
{
    std::string text = "voussoir stability";
    for (const std::string& name : arguments.names) text += " " + name;
    if (arguments.tolerance_factor != 1)
        text += fmt::format(" --tolerance-factor {:g}", arguments.tolerance_factor);
    if (arguments.tables) text += " --tables";
    return text + " -o " + arguments.folder->filename().string();
}

void print_line(const studies::stability::CellResult& result)
{
    say(fmt::format("{:<44} {:<8} {:<10} {:>8} steps {:>5} cuts {:>8.2f} s{}{}", result.cell.name,
                    studies::stability::name_of(result.outcome), studies::stability::result_in_words(result),
                    result.run.steps, result.run.step_cuts, result.run.cpu_time,
                    result.diagnosis.empty() ? "" : "  ", result.diagnosis));
    std::fflush(stdout);
}

/// DIR/stability.md, DIR/stability/stability.json, and pictures in DIR/stability if the program that draws them
/// was built; of a page of tables one picture alone.
void write_page(const StabilityArguments& arguments, const std::vector<studies::stability::StabilityScene>& scenes,
                const std::vector<studies::stability::CellResult>& results, const std::string& behaviour)
{
    const fs::path folder = *arguments.folder, pictures = folder / "stability";
    make_output_folder(folder);
    results::make_own_folder(pictures);
    std::vector<plots::Figure> figures = studies::stability::stability_figures(scenes, results);
    if (arguments.tables) figures = figure_alone(std::move(figures), "sliding");
    const std::vector<std::string> drawn = page_figures(figures, pictures);
    results::write_atomically(pictures / "stability.json",
                              studies::stability::stability_json(results, version::engine_json(behaviour)) + "\n");
    results::write_atomically(
        folder / "stability.md",
        studies::stability::stability_page(scenes, results, command_line(arguments), drawn, arguments.tables) +
            version::engine_paragraph(behaviour));
}

}  // namespace

int stability_command(const StabilityArguments& arguments)
{
    const std::vector<studies::stability::StabilityScene> scenes =
        studies::stability::stability_scenes(reader::case_reader);
    std::vector<studies::stability::StabilityCell> cells = chosen(arguments.names, scenes);
    for (studies::stability::StabilityCell& cell : cells) cell.tolerance *= arguments.tolerance_factor;
    if (arguments.list) {
        list(cells);
        return exit_done;
    }
    expect_writable(arguments.json, arguments.folder);
    const bool to_stdout = arguments.json && *arguments.json == "-";
    std::size_t finished = 0;
    const bool on_terminal = isatty(STDERR_FILENO) == 1;
    const auto done = [&](const studies::stability::CellResult& result) {
        if (on_terminal) say_over("", true);
        if (!to_stdout) print_line(result);
        if (on_terminal) say_over(fmt::format("{} of {} cells", ++finished, cells.size()), true);
    };
    const std::vector<studies::stability::CellResult> results =
        studies::stability::run_cells(cells, arguments.jobs, done);
    if (on_terminal) say_over("", true);
    const auto failed =
        std::count_if(results.begin(), results.end(), [](const studies::stability::CellResult& result) {
            return studies::stability::is_failure(result.outcome);
        });
    bool too_little = false;
    for (const studies::stability::StabilityScene& scene : scenes) {
        const std::string range = studies::stability::sound_range_in_words(scene, results);
        if (studies::stability::holds_too_little(scene, results)) {
            too_little = true;
            complain(fmt::format("{}: {:g} and {:g} are required", range,
                                 studies::stability::least_decades_of_stiffness,
                                 studies::stability::least_decades_of_step));
        } else if (!range.empty() && !to_stdout) {
            say(range);
        }
    }
    if (!to_stdout) say(fmt::format("{} of {} cells failed", failed, results.size()));
    if (arguments.json || arguments.folder) {
        const std::string behaviour = golden::behaviour(golden::hashes());
        if (arguments.json)
            write_json_text(*arguments.json,
                            studies::stability::stability_json(results, version::engine_json(behaviour)));
        if (arguments.folder) write_page(arguments, scenes, results, behaviour);
    }
    return failed == 0 && !too_little ? exit_done : exit_failure;
}

}  // namespace voussoir::app::commands
