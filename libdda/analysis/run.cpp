#include "libdda/analysis/run.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "libdda/analysis/collapse.h"
#include "libdda/analysis/crushing.h"
#include "libdda/analysis/diagnosis.h"
#include "libdda/analysis/energies.h"
#include "libdda/step/advance.h"

namespace voussoir
{

namespace
{

constexpr double regrowth = 2;             // of a cut time step after a good one
constexpr int most_parts_of_step = 20000;  // into which cutting may divide a nominal step before the run gives up
constexpr double inexactness = 1e-2;       // residual a static step may keep, as a share of its unbalanced force

/// What the loop over the stages carries along.
struct Progress {
    const Model& model;
    const RunObserver& observer;
    State& state;
    Workspace work;
    RunReport report;
    CollapseWatch watch;
    std::vector<double> widths;  // m, of the blocks
    bool judges_crushing = false;
    State before = {};  // of the step, to go back to
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
    report.max_penetration = std::max(report.max_penetration, step.max_penetration);
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
            << stage.control.time_step << " s needed more than " << most_parts_of_step << " cut ones, the last of "
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
    const auto wrong = diagnose(progress.model, progress.widths, progress.state, progress.report);
    if (!wrong) return true;
    std::ostringstream message;
    message << "stage '" << stage.name << "' stopped at t = " << progress.state.time << " s: " << *wrong;
    progress.state = progress.before;
    progress.report.energy = progress.energy_before;
    return give_up(message.str(), progress);
}

/// Notes crushed joints and fallen blocks; false when the run has ended by collapse.
bool note_damage(const Stage& stage, Progress& progress)
{
    RunReport& report = progress.report;
    if (progress.judges_crushing) note_crushing(progress.model, progress.state, report);
    if (stage.type != StageType::dynamic) return true;
    note_fallen(progress.model, progress.watch, stage.gravity, progress.state, report);
    const bool enough =
        stage.stop_after_fallen > 0 && static_cast<int>(report.fallen.size()) >= stage.stop_after_fallen;
    if (!enough && !all_have_left(progress.model, report)) return true;
    report.outcome = Outcome::collapsed;
    report.message = fallen_in_words(progress.model, report);
    return false;
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
    return true;
}

/// Shows the state, complete and fit to go on from, to the observer; false when asked to stop.
bool observe(const StepReport& step, Progress& progress)
{
    if (progress.observer.step) progress.observer.step(progress.state, step, progress.report);
    if (!progress.observer.stop || !progress.observer.stop()) return true;
    progress.report.outcome = Outcome::interrupted;
    progress.report.message = "stopped on request";
    return false;
}

/// Steps with the velocity set to zero after each, until the unbalanced force of every block is below the
/// tolerance in two steps running without change of contact state. Time does not pass.
bool run_static(const Stage& stage, Progress& progress)
{
    const double start_time = progress.state.time;
    Stage loaded = stage;
    for (int increment = 1; increment <= stage.gravity_increments; ++increment) {
        loaded.gravity = stage.gravity * increment / stage.gravity_increments;
        int quiet = 0;
        double unbalanced = 1;
        for (int n = 0; quiet < 2; ++n) {
            if (n == stage.max_static_steps) {
                std::ostringstream message;
                message
                    << "stage '" << stage.name << "' found no equilibrium in " << n
                    << " steps: the unbalanced force is still " << progress.report.static_unbalanced
                    << " of a block's load; the structure may be a mechanism under its own weight, or it needs a "
                       "larger time_step in this stage to come to rest";
                ++progress.report.unconverged_steps;
                return give_up(message.str(), progress);
            }
            // A step need only be solved as well as its own unbalanced force deserves: far from equilibrium the
            // last digits are friction points taking turns; near it the tolerance must not hide what is left.
            loaded.control.force_tolerance =
                std::min(stage.control.force_tolerance,
                         std::max(inexactness * unbalanced, 0.1 * stage.unbalanced_tolerance));
            StepReport step;
            const double grown = progress.state.next_time_step;
            const double h = grown > 0 ? std::min(grown, stage.control.time_step) : stage.control.time_step;
            if (!step_once(loaded, h, progress, step)) return false;
            progress.state.next_time_step = regrowth * step.time_step;
            progress.state.time = start_time;
            progress.report.static_unbalanced = unbalanced = step.inertia_ratio;
            if (!observe(step, progress) || !note_damage(stage, progress)) return false;
            const bool balanced = step.inertia_ratio <= stage.unbalanced_tolerance && !step.contact_state_changed;
            quiet = balanced ? quiet + 1 : 0;
        }
    }
    return true;
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
    std::int64_t frames = progress.observer.every > 0
                              ? static_cast<std::int64_t>(state.stage_time / progress.observer.every + 1e-9)
                              : 0;
    int parts_of_step = 0;
    while (state.grid < grid_steps) {
        const double next = grid_time(state.grid + 1);
        const double left = next - state.stage_time;
        const double h = state.next_time_step > 0 ? std::min(state.next_time_step, left) : left;
        StepReport step;
        if (!step_once(stage, h, progress, step)) return false;
        const bool on_grid = step.time_step == left;
        parts_of_step = on_grid ? 0 : parts_of_step + 1;
        if (parts_of_step > most_parts_of_step)
            return give_up(explain_repeated_cuts(progress, stage, step), progress);
        if (on_grid) {
            state.stage_time = next;
            ++state.grid;
        }
        // After a division the rest of the step is done at once.
        state.next_time_step = step.divided || (step.cuts == 0 && on_grid) ? 0 : regrowth * step.time_step;
        if (!observe(step, progress) || !note_damage(stage, progress)) return false;
        if (!on_grid || !progress.observer.frame) continue;
        const bool last = state.grid == grid_steps;
        const double due = static_cast<double>(frames + 1) * progress.observer.every;
        if (progress.observer.every > 0 && state.stage_time < due - 1e-9 * stage.control.time_step && !last)
            continue;
        if (progress.observer.every > 0)
            frames = static_cast<std::int64_t>(state.stage_time / progress.observer.every + 1e-9);
        progress.observer.frame(state, progress.report);
    }
    return true;
}

}  // namespace

RunReport run(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer)
{
    Progress progress{model,
                      observer,
                      state,
                      Workspace(model),
                      {},
                      CollapseWatch(model, state),
                      least_widths(model),
                      has_compressive_strength(model)};
    progress.report.energy = open_ledger(model, state);
    if (observer.frame) observer.frame(state, progress.report);
    for (int s = state.stage; s < static_cast<int>(stages.size()); ++s) {
        if (s != state.stage || state.stage_time == 0) begin_stage(model, s, state);
        const bool is_static = stages[s].type == StageType::static_equilibrium;
        const bool done = is_static ? run_static(stages[s], progress) : run_dynamic(stages[s], progress);
        if (observer.frame && (is_static || !done)) observer.frame(state, progress.report);
        if (!done) break;
    }
    if (const auto warning = energy_warning(progress.report.energy)) progress.report.warnings.push_back(*warning);
    const std::string crushed = crushed_in_words(model, progress.report);
    if (!crushed.empty()) progress.report.warnings.push_back(crushed);
    const std::string fallen = fallen_in_words(model, progress.report);
    if (!fallen.empty() && fallen != progress.report.message) progress.report.warnings.push_back(fallen);
    return std::move(progress.report);
}

}  // namespace voussoir
