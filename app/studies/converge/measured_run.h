// One run of the case at one setting: what it gave, and what it cost.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>

#include "app/studies/converge/recorder.h"
#include "app/studies/converge/setting.h"

namespace voussoir::app::studies::converge
{

/// CPU times by the process clock, and counts; of one run or of several added up.
struct RunCost {
    double cpu_static = 0, cpu_dynamic = 0;  // s, in static and in dynamic stages
    std::int64_t steps = 0, step_cuts = 0, iterations = 0;

    double cpu() const { return cpu_static + cpu_dynamic; }
    /// The same to tell which run is cheaper [s]: below 10 ms chance would decide, and they count as equal.
    double cpu_to_compare() const { return std::max(cpu(), 0.01); }
    RunCost& operator+=(const RunCost& other);
};

struct MeasuredRun {
    ConvergeSetting setting;
    Recording recording;
    std::optional<Collapse> collapse;  // the run ended there
    bool collapsed = false;            // the engine ended it: blocks have fallen, or fall without end
    RunCost cost;
    std::string failure;  // why the run gave up; empty when it did not
    std::string no_rest;  // why nothing ever moved: it found no equilibrium to begin with; empty when it did
};

/// What a study tells while it runs, and asks.
struct ConvergeWatch {
    /// Called after each step with the setting and the share of the run's motion that is done.
    std::function<void(const ConvergeSetting&, double)> progress;
    std::function<bool()> stop;  // true ends the study
};

/// The user asked the study to stop.
struct Interrupted {
};

/// Runs the stages as `voussoir run` does, writing nothing, until the end or a collapse.
/// @throws Interrupted when `watch.stop` says so
MeasuredRun run_setting(const Case& the_case, const ConvergeSetting& setting,
                        const std::vector<Quantity>& channels, const CollapseRule& rule,
                        const ConvergeWatch& watch);

}  // namespace voussoir::app::studies::converge
