#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "app/commands/commands.h"
#include "app/commands/outputs.h"
#include "app/commands/say.h"
#include "app/commands/study_output.h"
#include "app/golden/hashes.h"
#include "app/results/atomic_file.h"
#include "app/studies/verify/page.h"
#include "app/studies/verify/plot.h"
#include "app/studies/verify/runner.h"
#include "app/studies/verify/table.h"
#include "app/studies/verify/verify_json.h"
#include "app/version/version.h"
#include "app/words/nearest_word.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

namespace fs = std::filesystem;

/// The named ones in the order of the papers; all of them without names.
/// @throws InputError with every name that is none
std::vector<studies::verify::Benchmark> chosen(const std::vector<std::string>& names,
                                               std::vector<studies::verify::Benchmark> all)
{
    std::vector<std::string> known;
    known.reserve(all.size());
    for (const studies::verify::Benchmark& benchmark : all) known.push_back(benchmark.name);
    std::vector<Fault> faults;
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            faults.push_back({"verify " + name, "there is no such benchmark", words::suggestion(name, known)});
    if (!faults.empty()) throw InputError(std::move(faults));
    if (names.empty()) return all;
    std::erase_if(all, [&](const studies::verify::Benchmark& benchmark) {
        return std::find(names.begin(), names.end(), benchmark.name) == names.end();
    });
    return all;
}

void list(const std::vector<studies::verify::Benchmark>& benchmarks)
{
    for (const studies::verify::Benchmark& benchmark : benchmarks)
        say(fmt::format("{:<30} {} ({})", benchmark.name, benchmark.title, benchmark.source));
}

std::string command_line(const VerifyArguments& arguments)
{
    std::string text = "voussoir verify";
    for (const std::string& name : arguments.names) text += " " + name;
    if (arguments.sweep) text += " --sweep";
    if (arguments.tables) text += " --tables";
    if (arguments.seed != default_verify_seed) text += fmt::format(" --seed {}", arguments.seed);
    return text + " -o " + arguments.folder->filename().string();
}

/// DIR/verification.md, and pictures in DIR/verification if the program that draws them was built: what each run
/// did, and the error of what was swept; of a page of tables one picture alone.
void write_page(const VerifyArguments& arguments, const std::vector<studies::verify::VerifyOutcome>& outcomes)
{
    const fs::path folder = *arguments.folder;
    make_output_folder(folder);
    std::vector<plots::Figure> figures;
    for (const studies::verify::VerifyOutcome& outcome : outcomes) {
        if (outcome.rows.size() > 1) figures.push_back(studies::verify::work_precision(outcome));
        figures.push_back(studies::verify::picture(outcome));
    }
    std::erase_if(figures, [](const plots::Figure& figure) { return figure.diagrams.empty(); });
    if (arguments.tables) figures = figure_alone(std::move(figures), "shaking-table-run");
    const std::vector<std::string> drawn = page_figures(figures, folder / "verification");
    results::write_atomically(
        folder / "verification.md",
        studies::verify::verification_page(outcomes, command_line(arguments), drawn, arguments.tables) +
            version::engine_paragraph(golden::behaviour(golden::hashes())));
}

}  // namespace

int verify_command(const VerifyArguments& arguments)
{
    const std::vector<studies::verify::Benchmark> benchmarks =
        chosen(arguments.names, studies::verify::all_benchmarks(arguments.seed));
    if (arguments.list) {
        list(benchmarks);
        return exit_done;
    }
    expect_writable(arguments.json, arguments.folder);
    const bool to_stdout = arguments.json && *arguments.json == "-";
    const bool on_terminal = isatty(STDERR_FILENO) == 1;
    std::vector<studies::verify::VerifyOutcome> outcomes;
    if (!to_stdout) say_lines(studies::verify::table_head());
    for (std::size_t i = 0; i < benchmarks.size(); ++i) {
        // A short line that the next one overwrites.
        if (on_terminal) say_over(fmt::format("{} of {}: {}", i + 1, benchmarks.size(), benchmarks[i].name), true);
        outcomes.push_back(studies::verify::run_benchmark(benchmarks[i], arguments.sweep));
        if (on_terminal) say_over("", true);
        if (to_stdout) continue;
        say_lines(fmt::format("{}{}", studies::verify::table_line(outcomes.back()),
                              studies::verify::sweep_lines(outcomes.back())));
        std::fflush(stdout);
    }
    const auto passed =
        std::count_if(outcomes.begin(), outcomes.end(), [](const auto& each) { return each.pass; });
    if (!to_stdout) say(fmt::format("{} of {} passed", passed, outcomes.size()));
    if (arguments.json) write_json_text(*arguments.json, studies::verify::verify_json(outcomes));
    if (arguments.folder) write_page(arguments, outcomes);
    return passed == static_cast<std::ptrdiff_t>(outcomes.size()) ? exit_done : exit_failure;
}

}  // namespace voussoir::app::commands
