// Running a case through the program, and what came of it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace voussoir::verification
{

struct ProgramRun {
    int status = -1;                        // of the shell; 0: done
    std::string summary;                    // of summary.json, its text
    std::vector<std::string> columns;       // of histories.csv
    std::vector<std::vector<double>> rows;  // of histories.csv
    std::string bytes;                      // of results.h5

    /// A number or a word of summary.json.
    double figure(const std::string& key) const;
    std::string word(const std::string& key) const;
    /// Has results.h5 a dataset or group of this name?
    bool has_dataset(const std::string& name) const;
    /// Column `name` of histories.csv at the end.
    double last(const std::string& name) const;
};

/// @param settings as after --set; @param program the one to start
ProgramRun run_case(const std::filesystem::path& case_file, const std::vector<std::string>& settings,
                    const std::filesystem::path& program = VOUSSOIR_PROGRAM);

}  // namespace voussoir::verification
