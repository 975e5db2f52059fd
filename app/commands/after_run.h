// What is made of the results of a run when it has ended: pictures, a film, a report, where the case asks for
// them.
#pragma once

#include <filesystem>
#include <vector>

#include "app/case/case.h"

namespace voussoir::app::commands
{

struct AfterRun {
    std::vector<std::filesystem::path> files;  // that were made
    bool complete = true;                      // all that was asked for
};

/// Refuses, before a long run, what cannot be made of it: a film without ffmpeg. @throws InputError
void expect_tools(const Case& the_case);

/// The results stand whatever becomes of the rest, so a failure is told and is no fault of the input.
AfterRun make_after_run(const Case& the_case, const std::filesystem::path& results_file,
                        const std::filesystem::path& folder, bool quiet);

}  // namespace voussoir::app::commands
