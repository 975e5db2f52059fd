// How a run ended, as its results file tells: a run that was killed told nothing.
#pragma once

#include <filesystem>
#include <string>

namespace voussoir::app::results
{

struct RunEnd {
    std::string outcome;  // as in summary.json; empty: the run was killed, or still goes on
    std::string message;  // why it ended, in words; often empty
    double planned = 0;   // s, the duration of all dynamic stages
    double reached = 0;   // s, of the last whole frame
};

/// @throws InputError when it is no results file, or damaged there
RunEnd run_end_of(const std::filesystem::path& results_file);

/// "the run collapsed at 3.2 of 10 s"; empty when it went to its end.
std::string early_end_in_words(const RunEnd& end);

}  // namespace voussoir::app::results
