// The joints of a run in its summary.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "libdda/analysis/joint_openings.h"
#include "libdda/model/report.h"

namespace voussoir::app::results
{

/// More joints than this are not listed: those that opened or slid most are.
constexpr std::size_t most_listed_joints = 1000;

/// How many joints there are, how many have opened, slid, broken, and a list of them in the order of /joints in
/// results.h5. @param joints of the start of the run; the report has an entry for each
nlohmann::ordered_json joint_summary(const Model& model, const std::vector<WatchedJoint>& joints,
                                     const State& state, const RunReport& report);

}  // namespace voussoir::app::results
