#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/case/nearest_word.h"
#include "app/commands/commands.h"
#include "app/commands/outputs.h"
#include "app/plots/plots.h"
#include "app/plots/words.h"
#include "app/results/atomic_file.h"
#include "app/stability/cell_wire.h"
#include "app/stability/maps.h"
#include "app/stability/page.h"
#include "app/stability/runner.h"
#include "app/stability/sound_range.h"
#include "libdda/errors.h"

namespace voussoir
{
namespace
{

namespace fs = std::filesystem;

/// The named cells and those of the named scenes, in the order of the map; all of them without names.
/// @throws InputError with every name that is none
std::vector<StabilityCell> chosen(const std::vector<std::string>& names, const std::vector<StabilityScene>& scenes)
{
    std::vector<std::string> known;
    std::vector<StabilityCell> cells;
    const auto named = [&](const std::string& name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const StabilityScene& scene : scenes) {
        known.push_back(scene.name);
        for (const StabilityCell& cell : scene.cells) {
            known.push_back(cell.name);
            if (named(scene.name) || named(cell.name)) cells.push_back(cell);
        }
    }
    std::vector<Fault> faults;
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            faults.push_back({"stability " + name, "there is no such scene or cell", suggestion(name, known)});
    if (!faults.empty()) throw InputError(std::move(faults));
    return cells;
}

void list(const std::vector<StabilityCell>& cells)
{
    for (const StabilityCell& cell : cells)
        fmt::print("{:<44} within {} of: {}; budget {:g} s\n", cell.name, error_in_words(cell.tolerance),
                   cell.reference, cell.budget);
}

std::string command_line(const StabilityArguments& arguments)
{
    std::string text = "voussoir stability";
    for (const std::string& name : arguments.names) text += " " + name;
    if (arguments.tolerance_factor != 1)
        text += fmt::format(" --tolerance-factor {:g}", arguments.tolerance_factor);
    return text + " -o " + arguments.folder->filename().string();
}

void print_line(const CellResult& result)
{
    fmt::print("{:<44} {:<8} {:<10} {:>8} steps {:>5} cuts {:>8.2f} s{}{}\n", result.cell.name,
               name_of(result.outcome), result_in_words(result), result.run.steps, result.run.step_cuts,
               result.run.cpu_time, result.diagnosis.empty() ? "" : "  ", result.diagnosis);
    std::fflush(stdout);
}

/// DIR/stability.md, DIR/stability/stability.json, and pictures in DIR/stability if the program that draws them
/// was built.
void write_page(const StabilityArguments& arguments, const std::vector<StabilityScene>& scenes,
                const std::vector<CellResult>& results)
{
    const fs::path folder = *arguments.folder, pictures = folder / "stability";
    make_output_folder(folder);
    make_output_folder(pictures);
    std::vector<std::string> drawn;
    if (can_draw_figures()) drawn = draw_figures(stability_figures(scenes, results), pictures);
    write_atomically(pictures / "stability.json", stability_json(results) + "\n");
    write_atomically(folder / "stability.md", stability_page(scenes, results, command_line(arguments), drawn));
}

}  // namespace

int stability_command(const StabilityArguments& arguments)
{
    const std::vector<StabilityScene> scenes = stability_scenes();
    std::vector<StabilityCell> cells = chosen(arguments.names, scenes);
    for (StabilityCell& cell : cells) cell.tolerance *= arguments.tolerance_factor;
    if (arguments.list) {
        list(cells);
        return exit_done;
    }
    expect_writable(arguments.json, arguments.folder);
    const bool to_stdout = arguments.json && *arguments.json == "-";
    std::size_t finished = 0;
    const bool on_terminal = isatty(STDERR_FILENO) == 1;
    const auto done = [&](const CellResult& result) {
        if (on_terminal) fmt::print(stderr, "\r\033[K");
        if (!to_stdout) print_line(result);
        if (on_terminal) fmt::print(stderr, "{} of {} cells", ++finished, cells.size());
    };
    const std::vector<CellResult> results = run_cells(cells, arguments.jobs, done);
    if (on_terminal) fmt::print(stderr, "\r\033[K");
    const auto failed = std::count_if(results.begin(), results.end(),
                                      [](const CellResult& result) { return is_failure(result.outcome); });
    bool too_little = false;
    for (const StabilityScene& scene : scenes) {
        const std::string range = sound_range_in_words(scene, results);
        if (holds_too_little(scene, results)) {
            too_little = true;
            fmt::print(stderr, "{}: {:g} and {:g} are required\n", range, least_decades_of_stiffness,
                       least_decades_of_step);
        } else if (!range.empty() && !to_stdout) {
            fmt::print("{}\n", range);
        }
    }
    if (!to_stdout) fmt::print("{} of {} cells failed\n", failed, results.size());
    if (arguments.json) write_json_text(*arguments.json, stability_json(results));
    if (arguments.folder) write_page(arguments, scenes, results);
    return failed == 0 && !too_little ? exit_done : exit_failure;
}

}  // namespace voussoir
