#include "app/commands/study_output.h"

#include <fmt/format.h>

#include <cstdio>

#include "app/commands/commands.h"
#include "app/commands/interrupt.h"
#include "app/commands/outputs.h"
#include "app/commands/say.h"
#include "app/plots/plots.h"
#include "app/results/atomic_file.h"
#include "app/results/own_folder.h"
#include "app/studies/converge/measured_run.h"

namespace voussoir::app::commands
{

namespace
{

void write_page(const StudyTargets& targets, const StudyOutput& output)
{
    const std::filesystem::path folder = *targets.folder, page = folder / (targets.name + ".md");
    make_output_folder(folder);
    results::write_atomically(page, output.page(page_figures(output.figures, folder / targets.name)));
    if (!targets.quiet) say(fmt::format("written: {}", page.string()));
}

}  // namespace

std::vector<plots::Figure> figure_alone(std::vector<plots::Figure> figures, const std::string& name)
{
    std::erase_if(figures, [&](const plots::Figure& figure) { return figure.name != name; });
    return figures;
}

std::vector<std::string> page_figures(const std::vector<plots::Figure>& figures,
                                      const std::filesystem::path& folder)
{
    if (figures.empty()) return {};
    if (!plots::can_draw_figures()) {
        complain(
            "the page has no pictures: there is no voussoir-plot beside this program (built without rendering)");
        return {};
    }
    results::make_own_folder(folder);
    return plots::draw_figures(figures, folder);
}

int publish_study(const StudyTargets& targets, const std::function<StudyOutput()>& study)
{
    catch_interrupts();
    expect_writable(targets.json, targets.folder);
    try {
        const StudyOutput output = study();
        const bool to_stdout = targets.json && *targets.json == "-";
        if (!to_stdout && !targets.quiet) say_lines(output.table);
        if (targets.json) write_json_text(*targets.json, output.json);
        if (targets.folder) write_page(targets, output);
        if (output.no_answer.empty()) return exit_done;
        complain(output.no_answer);
        return exit_gave_up;
    } catch (const studies::converge::Interrupted&) {
        complain("interrupted: the study is incomplete and nothing is written");
        return exit_interrupted;
    }
}

}  // namespace voussoir::app::commands
