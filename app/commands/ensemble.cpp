#include <fmt/format.h>
#include <unistd.h>

#include "app/commands/commands.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_words.h"
#include "app/commands/say.h"
#include "app/commands/study_output.h"
#include "app/reader/case_file.h"
#include "app/studies/ensemble/report.h"

namespace voussoir::app::commands
{

namespace
{

studies::ensemble::EnsembleChoices choices_of(const EnsembleArguments& arguments)
{
    studies::ensemble::EnsembleChoices choices;
    choices.limit = read_positive("--open", arguments.open, words::dimension::length);
    choices.stiffness_factor = arguments.stiffness_factor;
    choices.jobs = arguments.jobs;
    return choices;
}

studies::ensemble::EnsembleStudy run_chosen(const EnsembleArguments& arguments)
{
    const studies::ensemble::EnsembleChoices choices = choices_of(arguments);
    const studies::ensemble::Variation variation = studies::ensemble::read_variation(arguments.vary);
    const std::vector<Case> members =
        studies::ensemble::read_members(arguments.case_file, arguments.overrides, variation, reader::case_reader);
    const bool shown = !arguments.quiet && isatty(STDERR_FILENO) == 1;
    const auto tell = [&](const studies::ensemble::MemberRun& run, int done, int of) {
        if (shown)
            complain(
                fmt::format("run {} of {}: {}, {:.3g} s CPU", done, of, variation.values[run.member], run.cpu));
    };
    return studies::ensemble::run_ensemble(members, variation, choices, {tell, interrupted});
}

/// How the study can be had again.
std::string command_line(const EnsembleArguments& arguments)
{
    const EnsembleArguments defaults;
    std::string text =
        "voussoir ensemble " + shell_word(arguments.case_file.string()) + " --vary " + shell_word(arguments.vary);
    if (arguments.open != defaults.open) text += " --open " + shell_word(arguments.open);
    if (arguments.stiffness_factor != defaults.stiffness_factor)
        text += fmt::format(" --stiffness-factor {:g}", arguments.stiffness_factor);
    for (const std::string& setting : arguments.overrides) text += " --set " + shell_word(setting);
    if (arguments.jobs != defaults.jobs) text += fmt::format(" --jobs {}", arguments.jobs);
    return text + folder_option(*arguments.folder);
}

}  // namespace

int ensemble_command(const EnsembleArguments& arguments)
{
    return publish_study({"ensemble", arguments.json, arguments.folder, arguments.quiet}, [&] {
        const studies::ensemble::EnsembleStudy study = run_chosen(arguments);
        return StudyOutput{studies::ensemble::ensemble_table(study), studies::ensemble::ensemble_json(study),
                           studies::ensemble::ensemble_figures(study),
                           [study, &arguments](const std::vector<std::string>& drawn) {
                               return studies::ensemble::ensemble_page(study, command_line(arguments), drawn);
                           },
                           study.given_up() == 0 ? "" : "ensemble: " + verdict_of(study)};
    });
}

}  // namespace voussoir::app::commands
