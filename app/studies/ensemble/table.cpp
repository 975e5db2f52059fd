#include <fmt/format.h>

#include <cmath>

#include "app/studies/ensemble/report.h"
#include "app/words/figures_in_words.h"

namespace voussoir::app::studies::ensemble
{

namespace
{

int collapsed(const std::vector<MemberRun>& runs)
{
    int count = 0;
    for (const MemberRun& run : runs) count += run.collapse.has_value();
    return count;
}

std::string collapses_in_words(const EnsembleStudy& study)
{
    std::string words;
    for (std::size_t s = 0; s < study.settings.size(); ++s)
        if (const int count = collapsed(study.runs[s]))
            words += fmt::format(" At {} {} of {} runs collapsed.", setting_in_words(study, s), count,
                                 study.runs[s].size());
    return words;
}

}  // namespace

std::string value_in_words(double value)
{
    if (std::isnan(value)) return "-";
    return std::isinf(value) ? "collapsed" : fmt::format("{:.3g}", value);
}

std::string run_in_words(const EnsembleStudy& study, const MemberRun& run)
{
    std::string line =
        fmt::format("{} at {}: ", study.variation.values[run.member], setting_in_words(study, run.setting));
    if (!run.failure.empty()) return line + "gave up: " + run.failure;
    if (run.collapse)
        line += fmt::format("collapsed at {:.3f} s, block '{}', ", run.collapse->time, run.collapse->block);
    return line + fmt::format("{} steps, {} cuts, {:.1f} iterations per step, {:.3g} s CPU", run.steps,
                              run.step_cuts, static_cast<double>(run.iterations) / static_cast<double>(run.steps),
                              run.cpu);
}

std::string verdict_of(const EnsembleStudy& study)
{
    if (const int count = study.given_up())
        return fmt::format("{} of the runs failed to converge or to come to rest: no verdict is possible.", count);
    std::string differing;
    for (const MeasureStudy& each : study.measures)
        if (!each.agrees) differing += (differing.empty() ? "" : "; ") + each.measure.name;
    const std::string steps = setting_in_words(study, 0) + " and " + setting_in_words(study, 1);
    const std::string what = differing.empty()
                                 ? fmt::format("The medians at {} agree in every measure.", steps)
                                 : fmt::format(
                                       "The medians at {} differ by more than the runs among themselves "
                                       "and more than {:g} %: {}.",
                                       steps, 100 * study.choices.tolerance, differing);
    return what + collapses_in_words(study);
}

std::string ensemble_table(const EnsembleStudy& study)
{
    std::string text =
        fmt::format("{}; {} = {}\n\n", study.title, study.variation.key, fmt::join(study.variation.values, ", "));
    for (const std::string& warning : study.warnings) text += "warning: " + warning + "\n";
    for (const auto& runs : study.runs)
        for (const MemberRun& run : runs) {
            text += "  " + run_in_words(study, run) + "\n";
            for (const std::string& warning : run.warnings) text += "    warning: " + warning + "\n";
        }
    for (const MeasureStudy& each : study.measures) {
        text += fmt::format("\n{}{}\n", each.measure.name,
                            each.measure.unit.empty() ? "" : " [" + each.measure.unit + "]");
        for (std::size_t s = 0; s < study.settings.size(); ++s) {
            text += fmt::format("  {:>32}: median {:>9}, spread {:>9};", setting_in_words(study, s),
                                value_in_words(each.medians[s]), value_in_words(each.ranges[s]));
            for (const double value : each.values[s]) text += fmt::format(" {:>9}", value_in_words(value));
            text += "\n";
        }
        text += fmt::format("  medians differ by {}, allowed {}: {}\n", value_in_words(each.difference),
                            value_in_words(each.allowed), each.agrees ? "agree" : "DIFFER");
    }
    return text + "\n" + verdict_of(study) + "\n";
}

}  // namespace voussoir::app::studies::ensemble
