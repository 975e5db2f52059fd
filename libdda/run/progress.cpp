#include "libdda/run/progress.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "libdda/analysis/bar_forces.h"
#include "libdda/analysis/crushing.h"
#include "libdda/analysis/diagnosis.h"
#include "libdda/problem/part_timer.h"
#include "libdda/run/step_error.h"
#include "libdda/step/advance.h"

namespace voussoir::driver
{

namespace
{

void add_step(const StepReport& step, RunReport& report)
{
    ++report.steps;
    report.step_cuts += step.cuts;
    report.divided_steps += step.divided;
    report.refused_steps += step.refused;
    report.open_close_iterations += step.open_close_iterations;
    report.acted += step.acted;
    report.blows += step.blows;
    report.factorisations += step.factorisations;
    report.linear_iterations += step.linear_iterations;
    if (step.factor_entries > 0) report.factor_entries = step.factor_entries;
    for (std::size_t i = 0; i < step.seconds.size(); ++i) report.seconds[i] += step.seconds[i];
}

constexpr double shortening = 0.3;  // of a step after which to go on would be nonsense
constexpr int most_shortened = 5;   // times

/// Why it would be nonsense to go on after the step that was made; it is taken back then.
std::optional<Diagnosis> judge(RunProgress& progress)
{
    note_overlap(progress.model, progress.overlaps, progress.state, progress.report);
    auto wrong = diagnose(progress.model, progress.state, progress.report);
    if (wrong) take_back(progress);
    return wrong;
}

/// Notes crushed joints, fallen blocks and how far joints have opened.
void note_damage(const Stage& stage, double elapsed, RunProgress& progress)
{
    if (stage.type != StageType::dynamic) return;  // on the way to rest nothing moves in time
    if (progress.judges_crushing) note_crushing(progress.model, progress.state, elapsed, progress.report);
    const double now = progress.state.stage_time;
    note_fallen(progress.model, progress.watch, mean_gravity(stage.gravity_ramp, stage.gravity, now, now),
                progress.state, progress.report);
    note_joints(progress.model, progress.joints, progress.state, progress.report, stage.control.threads);
    note_bars(progress.model, progress.state, progress.report);
}

void frame(RunProgress& progress)
{
    if (!progress.observer.frame) return;
    const step::PartTimer timer(progress.report.seconds, Part::output);
    progress.observer.frame(progress.state, progress.report);
}

}  // namespace

bool give_up(Diagnosis diagnosis, RunProgress& progress)
{
    progress.report.outcome = Outcome::gave_up;
    progress.report.diagnosis = std::move(diagnosis);
    return false;
}

bool try_step(const Stage& stage, double h, RunProgress& progress, StepReport& step)
{
    progress.before = progress.state;
    progress.energy_before = progress.report.energy;
    step = advance(progress.model, stage, h, progress.state, progress.report.energy, progress.work);
    if (step.outcome != StepOutcome::converged) {
        progress.report.step_cuts += step.cuts;
        ++progress.report.unconverged_steps;
        return give_up(explain(stage, progress.state, step), progress);
    }
    return true;
}

void take_back(RunProgress& progress)
{
    progress.state = progress.before;
    progress.report.energy = progress.energy_before;
}

void add_cost(const StepReport& undone, StepReport& step)
{
    step.cuts += undone.cuts;
    step.refused += undone.refused;
    step.open_close_iterations += undone.open_close_iterations;
    step.acted += undone.acted;
    step.factorisations += undone.factorisations;
    step.linear_iterations += undone.linear_iterations;
    for (std::size_t i = 0; i < step.seconds.size(); ++i) step.seconds[i] += undone.seconds[i];
}

namespace
{

void count_step(const Stage& stage, const StepReport& step, RunProgress& progress)
{
    add_step(step, progress.report);
    if (stage.type == StageType::dynamic) progress.report.simulated_time += step.time_step;
    note_damage(stage, step.time_step, progress);
    progress.shown = false;
}

constexpr double shortest_share = 1.0 / 1024;  // of time_step, that an error may ask for

/// The step that the error of the one that was made allows. Nothing if that one may stay: then it notes its pace,
/// and how long the next may be.
std::optional<double> finer_step(const Stage& stage, RunProgress& progress, const StepReport& step)
{
    const StepControl& control = stage.control;
    if (control.step_error == 0) return std::nullopt;
    StepPace& pace = progress.position.pace;
    StepPace now{mean_accelerations(progress.before, progress.state, step.time_step), step.time_step};
    const double error =
        step_error(progress.model, pace.accelerations, pace.time_step, now.accelerations, now.time_step);
    const double shortest = std::max(control.min_time_step, shortest_share * control.time_step);
    const double next = std::max(next_share(error, control.step_error) * step.time_step, shortest);
    if (error > control.step_error && next < step.time_step) return next;
    pace = std::move(now);
    progress.state.next_time_step = std::min(next, control.time_step);
    return std::nullopt;
}

}  // namespace

bool keep_step(const Stage& stage, RunProgress& progress, const StepReport& step)
{
    if (auto wrong = judge(progress)) return give_up(std::move(*wrong), progress);
    count_step(stage, step, progress);
    return true;
}

bool step_once(const Stage& stage, double h, RunProgress& progress, StepReport& step)
{
    const DeepestOverlap deepest = progress.report.deepest;
    std::optional<StepReport> undone;
    int shortened = 0;
    for (;;) {
        if (!try_step(stage, h, progress, step)) return false;
        if (undone) add_cost(*undone, step);
        if (auto wrong = judge(progress)) {
            h = shortening * step.time_step;
            if (shortened == most_shortened || h < stage.control.min_time_step)
                return give_up(std::move(*wrong), progress);
            ++shortened;
            ++step.cuts;
        } else if (const std::optional<double> finer = finer_step(stage, progress, step)) {
            take_back(progress);
            h = *finer;
            ++step.refused;
        } else {
            break;
        }
        progress.report.deepest = deepest;
        undone = step;
    }
    count_step(stage, step, progress);
    return true;
}

void save(RunProgress& progress)
{
    if (!progress.observer.save) return;
    const step::PartTimer timer(progress.report.seconds, Part::output);
    progress.observer.save(progress.state, progress.position);
}

void show(RunProgress& progress)
{
    ++progress.position.frames;
    progress.shown = true;
    frame(progress);
    save(progress);
}

void show_end(RunProgress& progress)
{
    if (!progress.shown) frame(progress);
    save(progress);
}

bool goes_on(RunProgress& progress)
{
    if (!progress.observer.stop || !progress.observer.stop()) return true;
    progress.report.outcome = Outcome::interrupted;
    progress.report.diagnosis = Diagnosis{DiagnosisKind::interrupted, -1, {}, {}};
    return false;
}

}  // namespace voussoir::driver
