#include <fmt/format.h>
#include <unistd.h>

#include "app/commands/commands.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_words.h"
#include "app/commands/say.h"
#include "app/commands/study_output.h"
#include "app/reader/case_file.h"
#include "app/studies/converge/conclusion.h"
#include "app/studies/converge/report.h"
#include "app/studies/converge/threshold.h"
#include "app/words/figures_in_words.h"
#include "app/words/nearest_word.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{
namespace
{

studies::converge::CollapseRule read_collapse_rule(const std::string& text)
{
    const std::string option = "--collapse-displacement";
    if (text == "none") return {{}, {}};
    const words::ParsedQuantity quantity = words::parse_quantity(text);
    if (quantity.problem.empty() && quantity.has(words::dimension::length))
        return {{}, read_positive(option, text, words::dimension::length)};
    if (!quantity.problem.empty() || !quantity.has(words::dimension::number) || !(quantity.value > 0))
        throw InputError(option, "\"" + text + "\"", "write 0.5 (of a block's size), 10 cm, or none");
    return {quantity.value, {}};
}

// -; finer than the first, a bracket says less of the structure than of the runs' own errors.
constexpr double least_bracket = 1e-6, widest_bracket = 0.5;

constexpr double largest_tolerance = 0.5;  // -; wider, nothing is known

studies::converge::Threshold threshold_of(const ConvergeArguments& arguments)
{
    studies::converge::Threshold threshold = studies::converge::read_threshold(*arguments.threshold);
    threshold.bracket = read_positive("--bracket", arguments.bracket, words::dimension::number);
    if (threshold.bracket < least_bracket || threshold.bracket > widest_bracket)
        throw InputError(
            "--bracket", "\"" + arguments.bracket + "\"",
            fmt::format("write a fraction from {:g} to {:g}, such as 1 %", least_bracket, widest_bracket));
    return threshold;
}

/// One line on a terminal, written over and over: which run, how far it is.
class ConvergeLine
{
 public:
    ConvergeLine(bool quiet, std::size_t settings, double time_step)
        : shown_(!quiet && isatty(STDERR_FILENO) == 1), settings_(settings), time_step_(time_step)
    {
    }
    ~ConvergeLine()
    {
        if (shown_) say_over("", true);
    }
    ConvergeLine(const ConvergeLine&) = delete;
    ConvergeLine& operator=(const ConvergeLine&) = delete;

    void show(const studies::converge::ConvergeSetting& setting, double share)
    {
        if (!shown_) return;
        if (number_ == 0 || setting != last_) ++number_;
        const int percent = static_cast<int>(100 * share);
        if (setting == last_ && percent == percent_) return;
        last_ = setting;
        percent_ = percent;
        say_over(
            fmt::format("setting {} of {}: time step {}, stiffness x {:g}: {} %", number_, settings_,
                        words::step_in_words(setting.step_factor * time_step_), setting.stiffness_factor, percent),
            true);
    }

 private:
    bool shown_;
    std::size_t settings_, number_ = 0;
    double time_step_;  // s, the case's own
    studies::converge::ConvergeSetting last_;
    int percent_ = -1;
};

studies::converge::ConvergeStudy run_chosen(const ConvergeArguments& arguments)
{
    const studies::converge::CollapseRule rule = read_collapse_rule(arguments.collapse_displacement);
    const double tolerance = read_positive("--tolerance", arguments.tolerance, words::dimension::number);
    if (tolerance > largest_tolerance)
        throw InputError("--tolerance", "\"" + arguments.tolerance + "\"", "write a fraction of at most 50 %");
    std::optional<studies::converge::Threshold> threshold;
    if (arguments.threshold) threshold = threshold_of(arguments);
    if (threshold && !rule.sizes && !rule.length)
        throw InputError("--threshold",
                         "a threshold requires a collapse criterion, but --collapse-displacement is none",
                         "give a fraction of the block size or a length");
    // A key that only the threshold writes may be one that the case cannot do without.
    std::vector<std::string> overrides = arguments.overrides;
    if (threshold)
        for (std::string& setting : settings_of(*threshold, threshold->stands))
            overrides.push_back(std::move(setting));
    Case the_case = reader::read_case(arguments.case_file, overrides);
    the_case.overrides = arguments.overrides;
    for (Stage& stage : the_case.stages) stage.control.threads = arguments.threads;
    const std::vector<studies::converge::Quantity> quantities =
        studies::converge::read_quantities(arguments.quantities, the_case);
    const studies::converge::ConvergePlan plan = studies::converge::plan_of(
        {arguments.time_steps, arguments.stiffness_factors, arguments.integrators, threshold.has_value()},
        the_case);
    const studies::converge::SettingList list = studies::converge::list_settings(plan);

    ConvergeLine line(arguments.quiet, list.settings.size(),
                      studies::converge::leading_stage(the_case).control.time_step);
    const studies::converge::ConvergeWatch watch{
        [&](const studies::converge::ConvergeSetting& setting, double share) { line.show(setting, share); },
        interrupted};
    studies::converge::ConvergeStudy study =
        threshold ? studies::converge::run_threshold_study(the_case, list, *threshold, rule, arguments.threads,
                                                           watch, reader::case_reader)
                  : studies::converge::run_study(the_case, list, quantities, rule, watch);
    study.tolerance = tolerance;
    study.notes.insert(study.notes.end(), plan.notes.begin(), plan.notes.end());
    return study;
}

/// How the study can be had again.
std::string command_line(const ConvergeArguments& arguments)
{
    std::string text = "voussoir converge " + shell_word(arguments.case_file.string());
    const auto add = [&](const std::string& option, const std::string& value) {
        text += " " + option + " " + shell_word(value);
    };
    const auto add_list = [&](const std::string& option, const auto& values) {
        if (!values.empty()) add(option, fmt::format("{}", fmt::join(values, ",")));
    };
    add_list("--quantity", arguments.quantities);
    add_list("--time-steps", arguments.time_steps);
    add_list("--stiffness-factors", arguments.stiffness_factors);
    add_list("--integrators", arguments.integrators);
    const ConvergeArguments defaults;
    if (arguments.threshold) add("--threshold", *arguments.threshold);
    if (arguments.bracket != defaults.bracket) add("--bracket", arguments.bracket);
    if (arguments.tolerance != defaults.tolerance) add("--tolerance", arguments.tolerance);
    if (arguments.collapse_displacement != defaults.collapse_displacement)
        add("--collapse-displacement", arguments.collapse_displacement);
    for (const std::string& setting : arguments.overrides) add("--set", setting);
    if (arguments.threads != defaults.threads) add("--threads", std::to_string(arguments.threads));
    return text + folder_option(*arguments.folder);
}

/// Why no run of the study gave anything to compare; empty if one did.
std::string no_answer_of(const studies::converge::ConvergeStudy& study)
{
    const studies::converge::Conclusion conclusion = studies::converge::conclude(study);
    if (conclusion.row) return {};
    return "converge: " + studies::converge::in_words(conclusion).front();
}

}  // namespace

int converge_command(const ConvergeArguments& arguments)
{
    return publish_study({"converge", arguments.json, arguments.folder, arguments.quiet}, [&] {
        const studies::converge::ConvergeStudy study = run_chosen(arguments);
        return StudyOutput{studies::converge::converge_table(study), studies::converge::converge_json(study),
                           studies::converge::converge_figures(study),
                           [study, &arguments](const std::vector<std::string>& drawn) {
                               return studies::converge::converge_page(study, command_line(arguments), drawn);
                           },
                           no_answer_of(study)};
    });
}

}  // namespace voussoir::app::commands
