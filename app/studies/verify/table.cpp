#include "app/studies/verify/table.h"

#include <fmt/format.h>

#include "app/studies/verify/settings.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::verify
{

std::string table_head()
{
    return fmt::format("{:<30} {:<34} {:>10} {:>10} {:>9} {:>9}  {}\n", "benchmark", "paper's error", "ours",
                       "tolerance", "step", "CPU s/s", "pass");
}

namespace
{

std::string companion_line(const Companion& companion)
{
    const VerifyResult& result = companion.row.result;
    std::string text = fmt::format(
        "    {:<61} {:>10} {:>10} {:>9} {:>9.3g}", name_of(companion.row.setting.kinematics),
        result.failure.empty() ? words::error_in_words(result.error) : "failed", "", "", cpu_share(result));
    if (companion.distance) text += fmt::format("  agrees to {:.0e}", *companion.distance);
    return text + (result.failure.empty() ? "\n" : ": " + result.failure + "\n");
}

}  // namespace

std::string table_line(const VerifyOutcome& outcome)
{
    const Benchmark& benchmark = outcome.benchmark;
    const VerifyResult& result = outcome.row.result;
    const bool failed = !result.failure.empty();
    std::string text = fmt::format(
        "{:<30} {:<34} {:>10} {:>10} {:>9} {:>9.3g}  {}\n", benchmark.name,
        benchmark.paper_error.empty() ? "none given" : benchmark.paper_error,
        failed ? "failed" : words::error_in_words(result.error), words::error_in_words(benchmark.tolerance),
        words::step_in_words(outcome.row.setting.time_step), cpu_share(result), outcome.pass ? "yes" : "NO");
    if (failed) text += "    failed: " + result.failure + "\n";
    if (result.paper_measure)
        text += fmt::format("    by the paper's measure: {}\n", words::error_in_words(*result.paper_measure));
    if (!result.note.empty()) text += "    " + result.note + "\n";
    for (const Companion& companion : outcome.companions) text += companion_line(companion);
    return text;
}

std::string sweep_lines(const VerifyOutcome& outcome)
{
    if (outcome.rows.size() < 2) return {};
    std::string text;
    for (const VerifyRow& row : outcome.rows) {
        const VerifyResult& result = row.result;
        const std::string stiffness =
            row.setting.stiffness_factor ? fmt::format(", stiffness x {:g}", *row.setting.stiffness_factor) : "";
        text += fmt::format("    {:<60} {:>9} {:>10} {:>8.3g} s CPU {:>8} steps {:>8} iterations\n",
                            method_name(row.setting) + stiffness, words::step_in_words(row.setting.time_step),
                            result.failure.empty() ? words::error_in_words(result.error) : "failed",
                            result.cpu_time, result.steps, result.iterations);
    }
    for (const ObservedOrder& order : outcome.orders)
        text += fmt::format("    observed order of convergence, {}: {:.2f}\n", order.method, order.order);
    return text;
}

}  // namespace voussoir::app::studies::verify
