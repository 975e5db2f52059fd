#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_words.h"
#include "app/commands/study_output.h"
#include "app/reader/case_file.h"
#include "app/studies/converge/measured_run.h"
#include "app/studies/limit/study.h"
#include "libdda/errors.h"

namespace voussoir::app::commands
{

namespace
{

Eigen::Vector3d direction_of(const std::vector<double>& towards)
{
    const auto given = fmt::format("\"{}\"", fmt::join(towards, ","));
    if (towards.size() != 3) throw InputError("--towards", given, "write three numbers, as 1,0,0");
    Eigen::Vector3d direction(towards[0], towards[1], towards[2]);
    if (!direction.allFinite() || !(direction.norm() > 0))
        throw InputError("--towards", given, "write a direction, as 1,0,0");
    return direction;
}

/// How the study can be had again.
std::string command_line(const LimitArguments& arguments)
{
    std::string text = fmt::format("voussoir limit {} --towards={}", shell_word(arguments.case_file.string()),
                                   fmt::join(arguments.towards, ","));
    for (const std::string& setting : arguments.overrides) text += " --set " + shell_word(setting);
    return text + folder_option(*arguments.folder);
}

}  // namespace

int limit_command(const LimitArguments& arguments)
{
    return publish_study({"limit", arguments.json, arguments.folder, arguments.quiet}, [&] {
        const Eigen::Vector3d towards = direction_of(arguments.towards);
        const studies::limit::LimitStudy study =
            studies::limit::limit_study(reader::read_case(arguments.case_file, arguments.overrides), towards, [] {
                if (interrupted()) throw studies::converge::Interrupted();
            });
        const bool is_known = study.associated.outcome == voussoir::limit::UnderLoad::limited;
        return StudyOutput{studies::limit::limit_table(study),
                           studies::limit::limit_json(study),
                           {},
                           [study, &arguments](const std::vector<std::string>&) {
                               return studies::limit::limit_page(study, command_line(arguments));
                           },
                           is_known ? "" : "limit: " + studies::limit::in_words(study).front()};
    });
}

}  // namespace voussoir::app::commands
