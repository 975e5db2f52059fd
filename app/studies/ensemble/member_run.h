// One run of one member at one setting, and the numbers that are compared of it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/converge/recorder.h"
#include "app/studies/converge/setting.h"

namespace voussoir::app::studies::ensemble
{

/// Shares of the energy that was put in: what is told of every run, not judged.
struct EnergyShares {
    double residual = 0;  // -, EnergyLedger::relative_residual
    // NaN when nothing was put in:
    double algorithmic = 0;  // -, (closing + algorithmic + algorithmic_rotation + redetection) / (input + start)
    double friction = 0;     // -
    double damping = 0;      // -, kinetic, static and contact damping
    double input = 0;        // J
};

struct MemberRun {
    std::size_t member = 0, setting = 0;         // indices
    converge::Recording recording;               // of the points' drift, a channel each
    std::optional<converge::Collapse> collapse;  // the run ended there
    std::string failure;                         // why the run gave up; empty when it did not
    std::vector<std::string> warnings;           // of the run itself
    double largest_opening = 0;                  // m, of any joint at any output time
    int opened = 0, open = 0;                    // joints that were open at any output time, and at the end
    int joints = 0;
    std::int64_t steps = 0, step_cuts = 0, iterations = 0;
    double cpu = 0, cpu_dynamic = 0;  // s
    double simulated = 0;             // s
    EnergyShares energy;
};

/// @param limit a joint is open when a corner of it is by more [m]
/// @param stop true ends the run, whose figures are then not to be used
MemberRun run_member(const Case& member, const converge::ConvergeSetting& setting, double limit,
                     const std::function<bool()>& stop);

}  // namespace voussoir::app::studies::ensemble
