// The error bar of a run: the same case with half the time step, and with twice the stiffness of its joints,
// beside it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/results/error_estimate.h"
#include "libdda/analysis/material_point.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir::app::commands
{

/// The histories of a run, in memory: every accepted step of its dynamic stages.
class HistoryRecorder
{
 public:
    explicit HistoryRecorder(const Case& the_case);
    void step(const State& state);

    std::vector<std::string> names, units;     // (columns): "crown ux", "m"
    std::vector<double> times;                 // s, rising
    std::vector<std::vector<double>> columns;  // (columns x times)

 private:
    const Model* model_;
    std::vector<MaterialPoint> points_;
};

/// A run that is to be judged, or one beside it.
struct RecordedRun {
    HistoryRecorder histories;
    State state;  // at the end
    RunReport report;
};

/// The error bar of a run: the case is run beside it and compared. What is run is told unless `quiet`.
/// @param is_complete the histories are those of the whole run; of a run that was resumed they are not, and it is
/// run once more
/// @returns none of a run that has not come to an end of its own, and when the user interrupts
std::optional<results::ErrorEstimate> error_of(const Case& the_case, const RecordedRun& own, bool is_complete,
                                               bool quiet);

/// Prints a line for each quantity.
void print_estimate(const results::ErrorEstimate& estimate, Outcome outcome);

}  // namespace voussoir::app::commands
