// What a run beside others says of its own error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libdda/model/report.h"

namespace voussoir::app::results
{

/// A run beside: the same case with half the time step, or with twice the stiffness of the joints.
struct RunBeside {
    std::string name;     // "half the time step"
    std::string key;      // "half_step": its name in summary.json
    std::string outcome;  // as of runs, with what was said of it
};

/// A history or a result, and how far the runs beside are from it.
struct ComparedQuantity {
    std::string name, unit;           // "crown ux", "m"
    double size = 0;                  // largest |value| of the run itself
    std::vector<double> differences;  // (runs beside) largest |difference|, at the times that both runs have
};

struct ErrorEstimate {
    std::vector<RunBeside> runs;
    std::vector<ComparedQuantity> quantities;
};

/// A sentence for each run beside that ended otherwise than the run itself: then no difference tells the error.
std::vector<std::string> doubts_of(const ErrorEstimate& estimate, Outcome outcome);

/// JSON: keys in docs/results_format.md.
std::string estimate_json(const ErrorEstimate& estimate);

}  // namespace voussoir::app::results
