// Makes the report of a run: gathers, has pictures drawn, writes.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

namespace voussoir::app::report
{

/// Writes report.html, report.md and report.json into a folder, and report/ with tables, diagrams and pictures.
/// What cannot be drawn is missing, and the report says why.
/// @param film whether a film is made, or taken from beside the results
/// @param told of the film, how many of how many frames are done
/// @returns report.html, report.md, report.json and the folder report
/// @throws InputError when the results cannot be read or the folder cannot be written
std::vector<std::filesystem::path> make_report(const std::filesystem::path& results_file,
                                               const std::filesystem::path& folder, bool film,
                                               const std::function<void(int done, int all)>& told);

}  // namespace voussoir::app::report
