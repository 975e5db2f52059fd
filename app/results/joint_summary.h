// The joints of a run in its summary.
#pragma once

#include <string>
#include <vector>

#include "libdda/analysis/joints_now.h"

namespace voussoir::app::results
{

/// More joints than this are not listed: those that opened or slid most are.
constexpr std::size_t most_listed_joints = 1000;

/// JSON: how many joints there are, how many have opened, slid, broken; the `list` of them is empty.
std::string joint_counts(const std::vector<JointPeaks>& peaks, const std::vector<JointNow>& now);

/// The list: a line for each joint, in the order of /joints in results.h5, lengths, areas and forces to seven
/// digits.
/// @param joints of the start of the run; @param peaks, now of each of them
std::string joint_lines(const Model& model, const std::vector<WatchedJoint>& joints,
                        const std::vector<JointPeaks>& peaks, const std::vector<JointNow>& now);

}  // namespace voussoir::app::results
