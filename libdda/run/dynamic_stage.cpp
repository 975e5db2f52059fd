#include "libdda/run/dynamic_stage.h"

#include <algorithm>
#include <cmath>

#include "libdda/run/automatic_step.h"

namespace voussoir::driver
{

namespace
{

constexpr int max_parts_of_step = 20000;  // into which cutting may divide a nominal step before the run gives up
constexpr int max_divisions = 8;          // of a nominal step; stones that tremble land without end

/// The times at which nominal steps end.
struct Grid {
    std::int64_t steps = 0;
    double duration = 0, time_step = 0;  // s

    explicit Grid(const Stage& stage)
        : steps(static_cast<std::int64_t>(std::ceil(stage.duration / stage.control.time_step - 1e-9))),
          duration(stage.duration),
          time_step(stage.control.time_step)
    {
    }
    double time(std::int64_t n) const { return n == steps ? duration : static_cast<double>(n) * time_step; }
};

Diagnosis too_many_cuts(const Stage& stage, const State& state, const StepReport& step)
{
    Diagnosis diagnosis{DiagnosisKind::too_many_cuts, state.stage, {}, {}};
    if (step.worst_block >= 0) diagnosis.blocks = {step.worst_block};
    diagnosis.values = {state.time, stage.control.time_step, max_parts_of_step, step.time_step};
    return diagnosis;
}

/// Ends the run when enough has fallen; true then.
bool has_collapsed(const Stage& stage, RunProgress& progress)
{
    RunReport& report = progress.report;
    const bool enough =
        stage.stop_after_fallen > 0 && static_cast<int>(report.fallen.size()) >= stage.stop_after_fallen;
    if (!enough && !all_have_left(progress.model, report)) return false;
    report.outcome = Outcome::collapsed;
    report.diagnosis = diagnosis_of_fallen(report);
    return true;
}

/// Whether the grid time that has been reached has a frame: the first at or after each multiple, and the last.
bool is_due(const Grid& grid, const RunProgress& progress)
{
    const double every = progress.observer.every;
    const double due = static_cast<double>(progress.position.multiples + 1) * every;
    return every == 0 || progress.state.stage_time >= due - 1e-9 * grid.time_step ||
           progress.state.grid == grid.steps;
}

/// How long the next step is to be, of what is left of a nominal one [s].
double next_step(const Stage& stage, const State& state, const RunPosition& at, double left)
{
    // Steps that follow their error, or have been halved, share what is left: none is a crumb.
    const auto shared = [&](double step) { return left / std::ceil(left / step - 1e-9); };
    const double longest = shared(longest_so_far(stage, at));
    if (state.next_time_step == 0) return longest;
    return std::min(longest, stage.control.step_error > 0 ? shared(state.next_time_step) : state.next_time_step);
}

/// The stage as a step of h [s] is made in it. @param now a copy of the stage
void suit_to_step(const Stage& stage, const RunPosition& at, double h, Stage& now)
{
    now.control.divide_up_to_blocks = at.divisions < max_divisions ? stage.control.divide_up_to_blocks : 0;
    if (stage.control.step_error == 0 && at.halvings == 0) return;
    StepControl of_step = stage.control;
    of_step.time_step = h;
    now.control.dissipation = of_step.dissipation_used();
}

/// One step towards the next grid time. @param now a copy of the stage; @param motions energy_of_motions() [J]
/// @returns false when the run ends here
bool step_on_grid(const Stage& stage, Stage& now, const Grid& grid, double motions, RunProgress& progress)
{
    State& state = progress.state;
    RunPosition& at = progress.position;
    const double next = grid.time(state.grid + 1);
    const double left = next - state.stage_time;
    const double h = next_step(stage, state, at, left);
    suit_to_step(stage, at, h, now);
    StepReport step;
    if (!step_once(now, h, progress, step)) return false;
    const bool on_grid = step.time_step == left;
    at.divisions = on_grid ? 0 : at.divisions + step.divided;
    at.parts = on_grid ? 0 : at.parts + !step.divided;
    if (at.parts > max_parts_of_step) return give_up(too_many_cuts(stage, progress.state, step), progress);
    if (on_grid) {
        state.stage_time = next;
        ++state.grid;
        shorten_where_steps_take_much(stage, motions, progress);
    }
    // After a division the rest of the step is done at once. Steps that follow their error have found the next.
    if (stage.control.step_error == 0)
        state.next_time_step = step.divided || (step.cuts == 0 && on_grid) ? 0 : regrowth * step.time_step;
    if (progress.observer.step) progress.observer.step(state, step, progress.report);
    if (on_grid && is_due(grid, progress)) {
        at.multiples = multiples_until(state.stage_time, progress.observer.every);
        show(progress);
    }
    return goes_on(progress);
}

}  // namespace

std::int64_t multiples_until(double time, double every)
{
    return every > 0 ? static_cast<std::int64_t>(time / every + 1e-9) : 0;
}

bool run_dynamic(const Stage& stage, RunProgress& progress)
{
    const Grid grid(stage);
    Stage now = stage;
    const double motions = stage.control.automatic ? energy_of_motions(progress.model, stage) : 0;
    while (progress.state.grid < grid.steps) {
        if (has_collapsed(stage, progress)) return false;
        if (!step_on_grid(stage, now, grid, motions, progress)) return false;
    }
    return !has_collapsed(stage, progress);
}

}  // namespace voussoir::driver
