#include "tests/verification/program_run.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/temporary_folder.h"

namespace voussoir::verification
{

namespace
{

std::string bytes_of(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> cells_of(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

void read_histories(const std::filesystem::path& file, ProgramRun& ran)
{
    std::ifstream stream(file);
    std::string line;
    if (std::getline(stream, line)) ran.columns = cells_of(line);
    while (std::getline(stream, line)) {
        ran.rows.emplace_back();
        for (const std::string& cell : cells_of(line)) ran.rows.back().push_back(std::stod(cell));
    }
}

}  // namespace

double ProgramRun::figure(const std::string& key) const
{
    return nlohmann::json::parse(summary).at(key);
}

std::string ProgramRun::word(const std::string& key) const
{
    return nlohmann::json::parse(summary).at(key);
}

bool ProgramRun::has_dataset(const std::string& name) const
{
    const std::string stored = '\0' + name + '\0';  // names stand in the file as they are
    return bytes.find(stored) != std::string::npos;
}

double ProgramRun::last(const std::string& name) const
{
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i] == name) return rows.back().at(i);
    throw std::runtime_error("no column " + name);
}

ProgramRun run_case(const std::filesystem::path& case_file, const std::vector<std::string>& settings,
                    const std::filesystem::path& program)
{
    const TemporaryFolder folder;
    std::string command = program.string() + " run " + case_file.string() + " -q -o " + folder.path().string();
    for (const std::string& setting : settings) command += " --set '" + setting + "'";
    ProgramRun ran;
    ran.status = std::system(command.c_str());
    ran.summary = bytes_of(folder / "summary.json");
    read_histories(folder / "histories.csv", ran);
    ran.bytes = bytes_of(folder / "results.h5");
    return ran;
}

}  // namespace voussoir::verification
