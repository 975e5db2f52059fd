#include "app/studies/verify/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/studies/verify/settings.h"
#include "app/studies/verify/table.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::verify
{
namespace
{

std::string ours(const VerifyResult& result)
{
    return result.failure.empty() ? words::error_in_words(result.error) : "failed";
}

std::string main_table(const std::vector<VerifyOutcome>& outcomes)
{
    std::string text =
        "| benchmark | paper's error | ours | tolerance | time step | CPU s per simulated s | pass |\n"
        "|---|---|---|---|---|---|---|\n";
    for (const VerifyOutcome& outcome : outcomes) {
        const Benchmark& benchmark = outcome.benchmark;
        text += fmt::format("| [{0}](#{0}) | {1} | {2} | {3} | {4} | {5:.3g} | {6} |\n", benchmark.name,
                            benchmark.paper_error.empty() ? "none given" : benchmark.paper_error,
                            ours(outcome.row.result), words::error_in_words(benchmark.tolerance),
                            words::step_in_words(outcome.row.setting.time_step), cpu_share(outcome.row.result),
                            outcome.pass ? "yes" : "**no**");
    }
    return text;
}

/// The scenes that were run in several unknowns: what each costs, and how near they are to one another.
std::string companion_table(const std::vector<VerifyOutcome>& outcomes)
{
    std::string text =
        "\n## The same scenes with other unknowns\n\n"
        "Every row must meet the tolerance of its benchmark. Rigid scenes are compared with rigid ones and "
        "deformable with deformable ones: the largest difference of the results as a fraction of the largest "
        "result.\n\n"
        "| benchmark | unknowns | per block | error | difference | CPU s per simulated s |\n"
        "|---|---|---|---|---|---|\n";
    const auto line = [](const std::string& name, const VerifyRow& row, const std::optional<double>& distance) {
        const Kinematics kinematics = row.setting.kinematics;
        return fmt::format("| {} | {} | {} | {} | {} | {:.3g} |\n", name, name_of(kinematics),
                           unknowns_per_block(kinematics), ours(row.result),
                           distance ? fmt::format("{:.1e}", *distance) : "", cpu_share(row.result));
    };
    for (const VerifyOutcome& outcome : outcomes) {
        if (outcome.companions.empty()) continue;
        text += line(outcome.benchmark.name, outcome.row, {});
        for (const Companion& companion : outcome.companions) text += line("", companion.row, companion.distance);
    }
    return text;
}

std::string sweep_table(const VerifyOutcome& outcome)
{
    std::string text =
        "\n| method | time step | contact stiffness | error | CPU s | steps | iterations | cuts |\n"
        "|---|---|---|---|---|---|---|---|\n";
    for (const VerifyRow& row : outcome.rows) {
        const VerifyResult& result = row.result;
        const std::string stiffness = row.setting.stiffness_factor
                                          ? fmt::format("default x {:g}", *row.setting.stiffness_factor)
                                          : "default";
        const std::string failure = result.failure.empty() ? "" : ": " + result.failure;
        text += fmt::format("| {} | {} | {} | {}{} | {:.3g} | {} | {} | {} |\n", method_name(row.setting),
                            words::step_in_words(row.setting.time_step), stiffness, ours(result), failure,
                            result.cpu_time, result.steps, result.iterations, result.step_cuts);
    }
    if (!outcome.orders.empty()) text += "\nObserved order of convergence: ";
    for (std::size_t i = 0; i < outcome.orders.size(); ++i)
        text +=
            fmt::format("{}{:.2f} ({})", i == 0 ? "" : ", ", outcome.orders[i].order, outcome.orders[i].method);
    if (outcome.orders.empty())
        text +=
            "\nNo order of convergence: no method has three successful runs with errors above 1e-5, the "
            "unbalanced force that a step may leave";
    return text + ".\n";
}

std::string section(const VerifyOutcome& outcome, const std::vector<std::string>& plots)
{
    const Benchmark& benchmark = outcome.benchmark;
    const VerifyResult& result = outcome.row.result;
    std::string text = fmt::format("\n## {}\n\n{}. Source: {}. Error: {}.\n", benchmark.name, benchmark.title,
                                   benchmark.source, benchmark.quantity);
    if (!benchmark.choices.empty()) text += "\n" + benchmark.choices + "\n";
    text += fmt::format("\nAt {} ({}): {}", words::step_in_words(outcome.row.setting.time_step),
                        method_name(outcome.row.setting), ours(result));
    if (result.paper_measure)
        text += fmt::format(", by the paper's own measure {}", words::error_in_words(*result.paper_measure));
    text += fmt::format("; {} steps, {} cut, {} iterations.\n", result.steps, result.step_cuts, result.iterations);
    if (!result.failure.empty()) text += "\nFailed: " + result.failure + "\n";
    if (!result.note.empty()) text += "\n" + result.note + "\n";
    for (const std::string& plot : {benchmark.name + "-run", benchmark.name})
        if (std::find(plots.begin(), plots.end(), plot) != plots.end())
            text += fmt::format("\n![{}](verification/{}.png)\n", benchmark.title, plot);
    if (outcome.rows.size() > 1) text += sweep_table(outcome);
    return text;
}

}  // namespace

std::string verification_page(const std::vector<VerifyOutcome>& outcomes, const std::string& command,
                              const std::vector<std::string>& plots, bool of_tables)
{
    const bool swept = std::any_of(outcomes.begin(), outcomes.end(),
                                   [](const VerifyOutcome& outcome) { return outcome.rows.size() > 1; });
    std::string text = fmt::format(
        "# Verification\n\n"
        "Generated by `{}`, not edited by hand.{} The error of a row is the largest difference from the reference "
        "over all times, with no part of the record omitted, as a fraction of the largest displacement of the "
        "reference, unless stated otherwise for the benchmark. The errors of the papers are as printed, by the "
        "measures of the papers. Integrator, contact stiffness and impacts are the program's "
        "defaults (docs/method.md). Where a row is held against values that a paper computed, they are the "
        "paper's, and "
        "its method says so: the integrator of Newmark and, as \"joints as in the papers\", impacts on springs of "
        "the "
        "paper's stiffness, which are E/L (rigid blocks) or 10 E/L (deformable ones) where it prints none. CPU "
        "times are process times of one thread{}.\n\n"
        "Every scene first comes to rest under its weight. A block that cannot rest on its plane is held there by "
        "the force that friction can carry and then released, so that its friction is mobilised at the start as "
        "assumed in the closed-form solutions: if released with unloaded shear springs it would first move "
        "through their elastic range and gain a speed of g sin a sqrt(m / k), about 1e-3 m/s here.\n\n",
        command,
        of_tables ? " The same without `--tables` draws the diagrams of all benchmarks into the page." : "",
        swept ? ", those of a sweep the median of three runs" : "");
    text += main_table(outcomes) + companion_table(outcomes);
    for (const VerifyOutcome& outcome : outcomes) text += section(outcome, plots);
    return text;
}

}  // namespace voussoir::app::studies::verify
