#include "app/problems/tables.h"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace voussoir::app::problems
{

namespace
{

using Json = nlohmann::ordered_json;

std::string joined(const std::vector<std::string>& tags)
{
    std::string text;
    for (const std::string& tag : tags) text += (text.empty() ? "" : ", ") + tag;
    return text;
}

/// Whether there is a difference to tell.
bool is_compared(const Judgement& judgement)
{
    return judgement.verdict == Verdict::same || judgement.verdict == Verdict::not_unique ||
           judgement.verdict == Verdict::wrong;
}

std::size_t count(const std::vector<Judgement>& judgements, Verdict verdict)
{
    return static_cast<std::size_t>(std::count_if(judgements.begin(), judgements.end(),
                                                  [&](const Judgement& each) { return each.verdict == verdict; }));
}

Json json_of_step(const StepReport& report, double seconds)
{
    Json json;
    json["made"] = report.outcome == StepOutcome::converged && report.cuts == 0;
    json["time_step_s"] = report.time_step;
    json["iterations"] = report.open_close_iterations;
    json["factorisations"] = report.factorisations;
    json["linear_iterations"] = report.linear_iterations;
    json["unbalanced"] = report.unbalanced;
    json["cpu_s"] = seconds;
    return json;
}

std::string run_line(const char* who, const WholeRun& run)
{
    const std::string parting =
        run.parting < 0 ? "no impact" : fmt::format("first impact or cut at {:.4f} s", run.parting);
    return fmt::format("{:<6} {}, {} steps, {} cuts, {} iterations, {:.2f} s of CPU, {}\n", who,
                       name_of(run.report.outcome), run.report.steps, run.report.step_cuts,
                       run.report.open_close_iterations, run.seconds, parting);
}

}  // namespace

std::string head_line(int width)
{
    return fmt::format("{:<{}} {:>6} {:>10} {:>11} {:>17}  {:<12} {}", "problem", width, "blocks", "difference",
                       "iterations", "CPU, ms", "verdict", "tags");
}

std::string line_of(const Judgement& judgement, int width)
{
    const std::string difference =
        is_compared(judgement) ? fmt::format("{:.2g}", judgement.difference.worst) : "-";
    const std::string iterations =
        fmt::format("{} {}", judgement.fast.open_close_iterations, judgement.plain.open_close_iterations);
    const std::string cpu =
        fmt::format("{:.2f} {:.2f}", 1e3 * judgement.fast_seconds, 1e3 * judgement.plain_seconds);
    const std::string closer =
        judgement.closer ? fmt::format(" ({:.2g} when solved a hundred times as closely)", *judgement.closer) : "";
    return fmt::format("{:<{}} {:>6} {:>10} {:>11} {:>17}  {:<12} {}{}{}", judgement.name, width, judgement.blocks,
                       difference, iterations, cpu, name_of(judgement.verdict), joined(judgement.tags),
                       judgement.why.empty() ? "" : " (" + judgement.why + ")", closer);
}

std::string summary_of(const std::vector<Judgement>& judgements)
{
    const auto of = [&](Verdict verdict) { return count(judgements, verdict); };
    const std::string lawful =
        of(Verdict::lawful) > 0 ? fmt::format(", {} by the laws alone", of(Verdict::lawful)) : "";
    return fmt::format(
        "{} problems: {} the same, {} not unique, {} plain failed, {} fast failed, {} wrong{}; {} iterations",
        judgements.size(), of(Verdict::same), of(Verdict::not_unique), of(Verdict::plain_failed),
        of(Verdict::fast_failed), of(Verdict::wrong), lawful, fast_iterations(judgements));
}

std::string json_of(const std::vector<Judgement>& judgements, const JudgeOptions& options)
{
    Json list = Json::array();
    for (const Judgement& each : judgements) {
        Json json;
        json["name"] = each.name;
        json["blocks"] = each.blocks;
        json["tags"] = each.tags;
        json["verdict"] = name_of(each.verdict);
        if (is_compared(each)) json["difference"] = each.difference.worst;
        if (is_compared(each)) json["worst_block"] = each.difference.block;
        if (!each.why.empty()) json["why"] = each.why;
        if (each.closer) json["difference_solved_closer"] = *each.closer;
        json["fast"] = json_of_step(each.fast, each.fast_seconds);
        if (each.verdict != Verdict::lawful) json["plain"] = json_of_step(each.plain, each.plain_seconds);
        list.push_back(std::move(json));
    }
    Json whole;
    whole["summary"] = summary_of(judgements);
    whole["passes"] = passes(judgements, options);
    whole["problems"] = std::move(list);
    return whole.dump(1) + "\n";
}

std::string lines_of(const WholeComparison& both)
{
    return run_line("fast", both.fast) + run_line("plain", both.plain) +
           fmt::format(
               "centroids in {} steps before that: {:.3g} units of tolerance x g h^2 / 2 x steps^1.5 (at most "
               "{:g}), {:.3g} of tolerance x g h^2 / 2 x steps\n",
               both.frames, both.difference, most_difference, both.by_steps) +
           fmt::format("energies: {:.2g} % (input), {:.2g} % (dissipated) (at most 5 %)\n", 100 * both.input,
                       100 * both.dissipated) +
           (both.passes() ? "they agree" : "they DISAGREE");
}

}  // namespace voussoir::app::problems
