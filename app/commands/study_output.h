// Studies that run long and write a table, figures as JSON and a page: converge, ensemble.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/plots/diagram.h"

namespace voussoir::app::commands
{

/// Where a study's answer goes.
struct StudyTargets {
    std::string name;  // of the page NAME.md and the folder of its pictures
    std::optional<std::filesystem::path> json, folder;
    bool quiet = false;
};

/// What a study gives.
struct StudyOutput {
    std::string table, json;
    std::vector<plots::Figure> figures;
    std::function<std::string(const std::vector<std::string>& drawn)> page;  // drawn: the pictures there are
    std::string no_answer;  // why the study has none; empty when it has one
};

/// Of the figures of a page the one of this name, if it is there: docs/ keeps one picture of each page.
std::vector<plots::Figure> figure_alone(std::vector<plots::Figure> figures, const std::string& name);

/// Draws the figures of a page into its folder, which is made. Where this program was built without rendering it
/// says so and draws none. @returns the names of the pictures
std::vector<std::string> page_figures(const std::vector<plots::Figure>& figures,
                                      const std::filesystem::path& folder);

/// Runs a study and writes its answer: the table to standard output, unless the JSON goes there; FOLDER/NAME.md
/// and FOLDER/NAME/*.png. Targets that could not be written are refused before it runs; nothing is written when it
/// is interrupted. @returns exit_done, exit_gave_up when the study has no answer, or exit_interrupted
int publish_study(const StudyTargets& targets, const std::function<StudyOutput()>& study);

}  // namespace voussoir::app::commands
