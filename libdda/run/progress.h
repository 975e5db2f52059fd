// A run under way: what the loops over its stages carry along, and what they all do.
#pragma once

#include <vector>

#include "libdda/analysis/collapse.h"
#include "libdda/analysis/joint_openings.h"
#include "libdda/analysis/overlaps.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/run/run.h"
#include "libdda/step/workspace.h"

namespace voussoir::driver
{

constexpr double regrowth = 2;  // of a cut time step after a good one

/// What the loops over the stages carry along.
struct RunProgress {
    const Model& model;
    const RunObserver& observer;
    State& state;
    Workspace work;
    RunPosition position;
    RunReport& report = position.report;
    CollapseWatch watch = {};
    OverlapWatch overlaps = {};
    std::vector<WatchedJoint> joints = {};
    std::vector<double> start = {};  // State::coordinates at the start of the run
    bool judges_crushing = false;
    bool shown = false;  // the state as it is has its frame
    State before = {};   // of the step, to go back to
    EnergyLedger energy_before = {};
};

/// Ends the run. @returns false
bool give_up(Diagnosis diagnosis, RunProgress& progress);

/// Makes a step of at most h [s], which may be taken back; false when it gave up.
bool try_step(const Stage& stage, double h, RunProgress& progress, StepReport& step);

/// Undoes the last step that was made.
void take_back(RunProgress& progress);

/// Adds what a step that was taken back has cost to the one made instead.
void add_cost(const StepReport& undone, StepReport& step);

/// Judges and counts the step that was made; false, and the step undone, when to go on would be nonsense.
bool keep_step(const Stage& stage, RunProgress& progress, const StepReport& step);

/// Both: one step of at most h [s], judged and counted, and shortened where to go on after it would be nonsense
/// or its error is larger than step_error; false when it gave up.
bool step_once(const Stage& stage, double h, RunProgress& progress, StepReport& step);

/// Lets the caller keep the state as a place to go on from. What that takes is output.
void save(RunProgress& progress);

/// A frame of the run, counted, and a place to go on from.
void show(RunProgress& progress);

/// The last state of a run that was stopped or gave up.
void show_end(RunProgress& progress);

/// Ends the run when asked to; false then. The state is complete and fit to go on from.
bool goes_on(RunProgress& progress);

}  // namespace voussoir::driver
