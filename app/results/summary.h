// summary.json: what a run was and how well it was computed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/case/case.h"
#include "app/results/error_estimate.h"
#include "libdda/analysis/joint_openings.h"
#include "libdda/analysis/trust.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir::app::results
{

struct CommandTimes {
    double wall = 0, cpu = 0;  // s, of the whole command
};

/// What is known of how good a run is.
struct RunQuality {
    std::optional<Trust> trust;
    std::optional<ErrorEstimate> estimate;
};

/// @param joints of the start of the run; @param files names of the files the run wrote, relative to its folder
/// @returns JSON text; keys in docs/results_format.md
std::string summary_json(const Case& the_case, const std::vector<WatchedJoint>& joints, const State& state,
                         const RunReport& report, const RunQuality& quality, const CommandTimes& times,
                         const std::vector<std::string>& files);

}  // namespace voussoir::app::results
