// Writes what a run found: results.h5, results.xdmf, histories.csv, summary.json.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/results/error_estimate.h"
#include "app/results/restart_file.h"
#include "app/results/summary.h"

namespace voussoir::app::results
{

/// What a run did not need and therefore did not create ("strains", "renderer", "ground motion", ...).
std::vector<std::string> left_out(const Case& the_case);

/// results.h5 is whole at every moment: see TwinFiles. Nothing is created before the case is known to be good.
class ResultsWriter
{
 public:
    /// Begins anew: what an earlier run left in the folder is removed.
    /// @throws InputError when the folder cannot be written
    ResultsWriter(const Case& the_case, const std::filesystem::path& folder);
    /// Goes on: what was written after the moment of the restart is removed.
    /// @throws InputError also when the results in the folder are not what the restart goes on from
    ResultsWriter(const Case& the_case, const std::filesystem::path& folder, const Restart& restart);
    ~ResultsWriter();

    void frame(const State& state, const RunReport& report);      // a frame of results.h5, stored
    void add_frame(const State& state, const RunReport& report);  // one that may wait in memory for save()
    void history(const State& state, const StepReport& step, const RunReport& report);  // a line of histories.csv
    /// So much waits in memory that it should be saved.
    bool is_full() const;
    /// Stores all that waits, and writes the file that a later run can go on from. @param times of all commands so
    /// far
    void save(const State& state, const RunPosition& position, const CommandTimes& times);
    /// What the summary is to say of how far the run can be trusted; kept in the restart file from now on.
    void note(const TrustStart& trust);
    /// What the summary is to say of runs beside this one.
    void note(const ErrorEstimate& estimate);
    /// Closes everything, writes results.xdmf and summary.json. @param times of all commands
    /// @returns how far joints have opened and slid, the last state included, which a run that stops on the way to
    /// rest has not noted
    std::vector<JointPeaks> finish(const State& state, const RunReport& report, const CommandTimes& times);
    /// Nothing is left to go on with: the restart file says so from now on.
    void end(const RunReport& report);

    std::filesystem::path results_file() const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace voussoir::app::results
