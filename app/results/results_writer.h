// Writes what a run found: results.h5, results.xdmf, histories.csv, summary.json.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/case/case_file.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// What a run did not need and therefore did not create ("strains", "renderer", "ground motion", ...).
std::vector<std::string> left_out(const Case& the_case);

/// Readable at any moment: frames are appended and flushed one by one, in the oldest HDF5 format, so that a killed
/// run leaves a file that opens. Nothing is created before the case is known to be good.
class ResultsWriter
{
 public:
    /// @throws InputError when the folder cannot be written
    ResultsWriter(const Case& the_case, const std::filesystem::path& folder);
    ~ResultsWriter();

    void frame(const State& state, const RunReport& report);  // a frame of results.h5, flushed
    void history(const State& state, const StepReport& step, const RunReport& report);  // a line of histories.csv
    /// Closes everything, writes results.xdmf and summary.json. @param wall, cpu times of the whole command [s]
    void finish(const State& state, const RunReport& report, double wall_time, double cpu_time);

    std::filesystem::path results_file() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace voussoir
