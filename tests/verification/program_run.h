// Running a case through the program, and what came of it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace voussoir::verification
{

struct ProgramRun {
    int status = -1;  // of the shell; 0: done
    nlohmann::json summary;
    std::vector<std::string> columns;       // of histories.csv
    std::vector<std::vector<double>> rows;  // of histories.csv
    std::string bytes;                      // of results.h5, in which dataset names stand as they are

    /// Column `name` of histories.csv at the end.
    double last(const std::string& name) const
    {
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (columns[i] == name) return rows.back().at(i);
        throw std::runtime_error("no column " + name);
    }
};

inline void read_histories(const std::filesystem::path& file, ProgramRun& ran)
{
    std::ifstream stream(file);
    std::string line, cell;
    std::getline(stream, line);
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) ran.columns.push_back(cell);
    while (std::getline(stream, line)) {
        ran.rows.emplace_back();
        for (std::istringstream cells(line); std::getline(cells, cell, ',');)
            ran.rows.back().push_back(std::stod(cell));
    }
}

/// @param settings as after --set; @param program the one to start
inline ProgramRun run_case(const std::filesystem::path& case_file, const std::vector<std::string>& settings,
                           const std::filesystem::path& program = VOUSSOIR_PROGRAM)
{
    std::string pattern = (std::filesystem::temp_directory_path() / "voussoir_run_XXXXXX").string();
    const std::filesystem::path folder = mkdtemp(pattern.data());
    std::string command = program.string() + " run " + case_file.string() + " -q -o " + folder.string();
    for (const std::string& setting : settings) command += " --set '" + setting + "'";
    ProgramRun ran;
    ran.status = std::system(command.c_str());
    if (std::filesystem::exists(folder / "summary.json")) std::ifstream(folder / "summary.json") >> ran.summary;
    read_histories(folder / "histories.csv", ran);
    std::ifstream results(folder / "results.h5", std::ios::binary);
    ran.bytes.assign(std::istreambuf_iterator<char>(results), {});
    std::filesystem::remove_all(folder);
    return ran;
}

}  // namespace voussoir::verification
