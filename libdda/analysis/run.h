// Stages one after another: static equilibrium, then motion.
#pragma once

#include <functional>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// What the caller may do between steps. Observers do not steer, but they may ask to stop.
struct RunObserver {
    double every = 0;  // s of simulated time between calls of `frame` in dynamic stages; 0: every step
    /// Called with the initial state, at the end of every static stage, every `every` seconds of a dynamic stage
    /// and at its end. Steps end exactly on nominal grid times, so a frame comes at the first grid time at or
    /// after each multiple.
    std::function<void(const State&, const RunReport&)> frame;
    /// Called after each accepted step.
    std::function<void(const State&, const StepReport&, const RunReport&)> step;
    /// Asked after each step; true ends the run as `interrupted`.
    std::function<bool()> stop;
};

/// Runs the stages from `state` (which names the stage and time to go on from) to the end. Never throws for
/// numerical trouble: the report says `gave_up`, names the block and the remedy, and `state` is the last good one.
RunReport run(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer);

}  // namespace voussoir
