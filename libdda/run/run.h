// Stages one after another: static equilibrium, then motion.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/run/static_course.h"

namespace voussoir
{

/// The last step of a dynamic stage whose steps follow their error.
struct StepPace {
    std::vector<double> accelerations;  // (blocks x unknowns) means over it; empty: none, all was at rest
    double time_step = 0;               // s
};

/// What there was of an energy that steps take when they were halved, since the motion began [J].
struct TakenBySteps {
    double put_in = 0, integrator = 0, closing = 0, contacts = 0;
};

/// Where a run stands: with its State, all that is needed to go on as if nothing had happened.
struct RunPosition {
    RunReport report;               // so far
    std::int64_t frames = 0;        // calls of RunObserver::frame so far, that of an interruption not counted
    std::vector<double> reference;  // State::coordinates when the first motion began; empty: it has not yet
    std::optional<EnergyLedger> before_motion;  // when the first dynamic stage began
    bool rested = false;                        // the structure had come to rest by then
    // Of the stage under way:
    bool stage_done = false;
    std::int64_t multiples = 0;  // dynamic: of RunObserver::every that had their frame
    int divisions = 0;           // dynamic: of the nominal step under way, before landings
    int parts = 0;               // dynamic: of the nominal step under way, those that cutting made
    int halvings = 0;            // dynamic, of an automatic time_step
    TakenBySteps at_halving;     // dynamic, by the last of these
    StepPace pace;               // dynamic, with step_error
    int load_increments = 0;     // static: complete ones
    int static_steps = 0;        // static: of the load increment under way
    int quiet_steps = 0;         // static: the last of these, in which nothing moved any more
    double step_unbalanced = 1;  // static: after the last of these
    StaticCourse course;         // static
};

/// What the caller may do between steps. Observers do not steer, but they may ask to stop.
struct RunObserver {
    double every = 0;  // s of simulated time between calls of `frame` in dynamic stages; 0: every step
    /// Called with the initial state, at the end of every static stage, every `every` seconds of a dynamic stage
    /// and at its end. Steps end exactly on nominal grid times, so a frame comes at the first grid time at or
    /// after each multiple. An interrupted run, and one that gave up, ends with a frame of its last state.
    std::function<void(const State&, const RunReport&)> frame;
    /// Called after each `frame`, and after each static step, for these have no frames: what a later run may go on
    /// from. The last call of an interrupted run may come with one frame more than it counts.
    std::function<void(const State&, const RunPosition&)> save;
    /// Called after each accepted step.
    std::function<void(const State&, const StepReport&, const RunReport&)> step;
    /// Asked after each step; true ends the run as `interrupted`.
    std::function<bool()> stop;
};

/// Where a run that has not begun stands: the energies of `state`. Initial motions wait for the first dynamic
/// stage, so `state` loses them if a static one comes first.
RunPosition start_position(const Model& model, const std::vector<Stage>& stages, State& state);

/// Runs the stages from `state` (which names the stage and time to go on from) to the end. Never throws for
/// numerical trouble: the report says `gave_up`, names the block and the remedy, and `state` is the last good one.
RunReport run(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer);

/// Goes on from where a run stood when it called `save` with this state and position. What is observed, reported
/// and found is bit for bit what the run would have observed, reported and found had it not been stopped.
RunReport run(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer,
              RunPosition position);

}  // namespace voussoir
