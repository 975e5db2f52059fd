#include "libdda/run/run.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "libdda/analysis/collapse.h"
#include "libdda/analysis/crushing.h"
#include "libdda/analysis/diagnosis.h"
#include "libdda/analysis/dry_joints.h"
#include "libdda/analysis/energies.h"
#include "libdda/analysis/overlaps.h"
#include "libdda/step/advance.h"

namespace voussoir
{

namespace
{

constexpr double regrowth = 2;            // of a cut time step after a good one
constexpr int max_parts_of_step = 20000;  // into which cutting may divide a nominal step before the run gives up
constexpr int max_divisions = 8;          // of a nominal step; joints that tremble turn round without end
constexpr double inexactness = 1e-2;      // residual a static step may keep, as a share of its unbalanced force

/// What the loop over the stages carries along.
struct Progress {
    const Model& model;
    const RunObserver& observer;
    State& state;
    Workspace work;
    RunPosition position;
    RunReport& report = position.report;
    CollapseWatch watch = {};
    std::vector<double> widths = {};  // m, of the blocks
    bool judges_crushing = false;
    bool shown = false;  // the state as it is has its frame
    State before = {};   // of the step, to go back to
    EnergyLedger energy_before = {};
};

void add_step(const StepReport& step, RunReport& report)
{
    ++report.steps;
    report.step_cuts += step.cuts;
    report.divided_steps += step.divided;
    report.open_close_iterations += step.open_close_iterations;
    report.factorisations += step.factorisations;
    report.linear_iterations += step.linear_iterations;
    if (step.factor_entries > 0) report.factor_entries = step.factor_entries;
    for (std::size_t i = 0; i < step.seconds.size(); ++i) report.seconds[i] += step.seconds[i];
}

bool give_up(const std::string& message, Progress& progress)
{
    progress.report.outcome = Outcome::gave_up;
    progress.report.message = message;
    return false;
}

std::string explain_repeated_cuts(const Progress& progress, const Stage& stage, const StepReport& step)
{
    std::ostringstream message;
    message << "stage '" << stage.name << "' stopped at t = " << progress.state.time << " s: a nominal step of "
            << stage.control.time_step << " s needed more than " << max_parts_of_step << " cut ones, the last of "
            << step.time_step << " s";
    if (step.worst_block >= 0)
        message << "; block '" << progress.model.blocks[step.worst_block].name
                << "' settles worst: look at its joints; a lower contact_stiffness, a dashpot or a larger "
                   "force_tolerance may help";
    return message.str();
}

/// Takes back a step after which to go on would be nonsense, and says why; false then.
bool is_sound(const Stage& stage, Progress& progress)
{
    note_overlap(progress.model, progress.widths, progress.state, progress.report);
    const auto wrong = diagnose(progress.model, progress.state, progress.report);
    if (!wrong) return true;
    std::ostringstream message;
    message << "stage '" << stage.name << "' stopped at t = " << progress.state.time << " s: " << *wrong;
    progress.state = progress.before;
    progress.report.energy = progress.energy_before;
    return give_up(message.str(), progress);
}

/// Notes crushed joints and fallen blocks.
void note_damage(const Stage& stage, Progress& progress)
{
    if (progress.judges_crushing) note_crushing(progress.model, progress.state, progress.report);
    if (stage.type == StageType::dynamic)
        note_fallen(progress.model, progress.watch, stage.gravity, progress.state, progress.report);
}

/// Ends the run when enough has fallen; true then.
bool has_collapsed(const Stage& stage, Progress& progress)
{
    RunReport& report = progress.report;
    const bool enough =
        stage.stop_after_fallen > 0 && static_cast<int>(report.fallen.size()) >= stage.stop_after_fallen;
    if (!enough && !all_have_left(progress.model, report)) return false;
    report.outcome = Outcome::collapsed;
    report.message = fallen_in_words(progress.model, report);
    return true;
}

/// One step; false when it gave up.
bool step_once(const Stage& stage, double h, Progress& progress, StepReport& step)
{
    progress.before = progress.state;
    progress.energy_before = progress.report.energy;
    step = advance(progress.model, stage, h, progress.state, progress.report.energy, progress.work);
    if (step.outcome != StepOutcome::converged) {
        progress.report.step_cuts += step.cuts;
        ++progress.report.unconverged_steps;
        return give_up(explain(progress.model, stage, progress.state, step), progress);
    }
    if (!is_sound(stage, progress)) return false;
    add_step(step, progress.report);
    if (stage.type == StageType::dynamic) progress.report.simulated_time += step.time_step;
    note_damage(stage, progress);
    progress.shown = false;
    return true;
}

/// A frame of the run, counted, and a place to go on from.
void show(Progress& progress)
{
    ++progress.position.frames;
    progress.shown = true;
    if (progress.observer.frame) progress.observer.frame(progress.state, progress.report);
    if (progress.observer.save) progress.observer.save(progress.state, progress.position);
}

/// The last state of a run that was stopped or gave up.
void show_end(Progress& progress)
{
    if (progress.observer.frame && !progress.shown) progress.observer.frame(progress.state, progress.report);
    if (progress.observer.save) progress.observer.save(progress.state, progress.position);
}

/// Ends the run when asked to; false then. The state is complete and fit to go on from.
bool goes_on(Progress& progress)
{
    if (!progress.observer.stop || !progress.observer.stop()) return true;
    progress.report.outcome = Outcome::interrupted;
    progress.report.message = "stopped on request";
    return false;
}

bool give_up_resting(const Stage& stage, Progress& progress)
{
    std::ostringstream message;
    message << "stage '" << stage.name << "' found no equilibrium in " << progress.position.static_steps
            << " steps: the unbalanced force is still " << progress.report.static_unbalanced
            << " of a block's load; the structure may be a mechanism under its own weight, or it needs a "
               "larger time_step in this stage to come to rest";
    ++progress.report.unconverged_steps;
    return give_up(message.str(), progress);
}

/// One step at rest under `loaded`; false when the run ends here.
bool step_at_rest(const Stage& stage, Stage& loaded, Progress& progress)
{
    RunPosition& at = progress.position;
    State& state = progress.state;
    // A step need only be solved as well as its own unbalanced force deserves: far from equilibrium the
    // last digits are friction points taking turns; near it the tolerance must not hide what is left.
    loaded.control.force_tolerance =
        std::min(stage.control.force_tolerance,
                 std::max(inexactness * at.step_unbalanced, 0.1 * stage.unbalanced_tolerance));
    StepReport step;
    const double grown = state.next_time_step;
    const double h = grown > 0 ? std::min(grown, stage.control.time_step) : stage.control.time_step;
    if (!step_once(loaded, h, progress, step)) return false;
    state.next_time_step = regrowth * step.time_step;
    progress.report.static_unbalanced = at.step_unbalanced = step.inertia_ratio;
    const bool balanced = step.inertia_ratio <= stage.unbalanced_tolerance && !step.contact_state_changed;
    at.quiet_steps = balanced ? at.quiet_steps + 1 : 0;
    ++at.static_steps;
    if (progress.observer.step) progress.observer.step(state, step, progress.report);
    if (progress.observer.save) progress.observer.save(state, at);
    return goes_on(progress);
}

/// Steps with the velocity set to zero after each, until the unbalanced force of every block is below the
/// tolerance in two steps running without change of contact state. Time does not pass.
bool run_static(const Stage& stage, Progress& progress)
{
    RunPosition& at = progress.position;
    Stage loaded = stage;
    for (; at.load_increments < stage.gravity_increments; ++at.load_increments) {
        loaded.gravity = stage.gravity * (at.load_increments + 1) / stage.gravity_increments;
        while (at.quiet_steps < 2) {
            if (at.static_steps == stage.max_static_steps) return give_up_resting(stage, progress);
            if (!step_at_rest(stage, loaded, progress)) return false;
        }
        at.static_steps = at.quiet_steps = 0;
        at.step_unbalanced = 1;
    }
    return true;
}

/// How many multiples of `every` lie in [0, time], 0 excluded; 0 when every step has its frame.
std::int64_t multiples_until(double time, double every)
{
    return every > 0 ? static_cast<std::int64_t>(time / every + 1e-9) : 0;
}

/// Steps on the nominal grid: a cut step is followed by growing ones that end on the next grid time, so that
/// output and ground motion are sampled at the same times whatever was cut.
bool run_dynamic(const Stage& stage, Progress& progress)
{
    State& state = progress.state;
    const auto grid_steps = static_cast<std::int64_t>(std::ceil(stage.duration / stage.control.time_step - 1e-9));
    const auto grid_time = [&](std::int64_t n) {
        return n == grid_steps ? stage.duration : static_cast<double>(n) * stage.control.time_step;
    };
    const double every = progress.observer.every;
    std::int64_t& multiples = progress.position.multiples;
    int& divisions = progress.position.divisions;
    int& parts = progress.position.parts;
    Stage undivided = stage;
    undivided.control.divide_up_to_blocks = 0;
    while (state.grid < grid_steps) {
        if (has_collapsed(stage, progress)) return false;
        const double next = grid_time(state.grid + 1);
        const double left = next - state.stage_time;
        const double h = state.next_time_step > 0 ? std::min(state.next_time_step, left) : left;
        StepReport step;
        if (!step_once(divisions < max_divisions ? stage : undivided, h, progress, step)) return false;
        const bool on_grid = step.time_step == left;
        divisions = on_grid ? 0 : divisions + step.divided;
        parts = on_grid ? 0 : parts + !step.divided;
        if (parts > max_parts_of_step) return give_up(explain_repeated_cuts(progress, stage, step), progress);
        if (on_grid) {
            state.stage_time = next;
            ++state.grid;
        }
        // After a division the rest of the step is done at once.
        state.next_time_step = step.divided || (step.cuts == 0 && on_grid) ? 0 : regrowth * step.time_step;
        if (progress.observer.step) progress.observer.step(state, step, progress.report);
        const double due = static_cast<double>(multiples + 1) * every;
        const bool is_due = every == 0 || state.stage_time >= due - 1e-9 * stage.control.time_step;
        if (on_grid && (is_due || state.grid == grid_steps)) {
            multiples = multiples_until(state.stage_time, every);
            show(progress);
        }
        if (!goes_on(progress)) return false;
    }
    return !has_collapsed(stage, progress);
}

void enter_stage(int stage, const Stage& entered, Progress& progress)
{
    begin_stage(progress.model, stage, progress.state);
    if (entered.type == StageType::dynamic) {
        const auto warning = ground_jump_warning(progress.model, entered, progress.state);
        if (warning) progress.report.warnings.push_back(*warning);
    }
    RunPosition fresh;
    fresh.report = std::move(progress.report);
    fresh.frames = progress.position.frames;
    progress.position = std::move(fresh);
}

}  // namespace

RunReport run(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer)
{
    RunPosition position;
    position.report.energy = open_ledger(model, state);
    position.multiples = multiples_until(state.stage_time, observer.every);
    return run(model, stages, state, observer, std::move(position));
}

RunReport run(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer,
              RunPosition position)
{
    Progress progress{model, observer, state, Workspace(model), std::move(position)};
    // Of a run that goes on, the start is the model's.
    const bool is_new = progress.position.frames == 0 && progress.report.steps == 0;
    progress.watch = CollapseWatch(model, is_new ? state : initial_state(model));
    progress.widths = least_widths(model);
    progress.judges_crushing = has_compressive_strength(model);
    progress.report.outcome = Outcome::completed;
    progress.report.message.clear();
    if (is_new)
        if (const auto warning = dry_joints_warning(model, state)) progress.report.warnings.push_back(*warning);
    if (progress.position.frames == 0) show(progress);
    for (int s = state.stage; s < static_cast<int>(stages.size()); ++s) {
        if (s == state.stage && progress.position.stage_done) continue;
        if (s != state.stage || state.stage_time == 0) enter_stage(s, stages[s], progress);
        const bool is_static = stages[s].type == StageType::static_equilibrium;
        const bool done = is_static ? run_static(stages[s], progress) : run_dynamic(stages[s], progress);
        progress.position.stage_done = done;
        if (done && is_static) show(progress);
        if (!done) {
            show_end(progress);
            break;
        }
    }
    if (const auto warning = energy_warning(progress.report.energy)) progress.report.warnings.push_back(*warning);
    if (const auto warning = overlap_warning(model, progress.report)) progress.report.warnings.push_back(*warning);
    const std::string crushed = crushed_in_words(model, progress.report);
    if (!crushed.empty()) progress.report.warnings.push_back(crushed);
    const std::string fallen = fallen_in_words(model, progress.report);
    if (!fallen.empty() && fallen != progress.report.message) progress.report.warnings.push_back(fallen);
    return std::move(progress.report);
}

}  // namespace voussoir
