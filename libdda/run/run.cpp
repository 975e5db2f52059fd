#include "libdda/run/run.h"

#include <algorithm>
#include <utility>

#include "libdda/analysis/bar_forces.h"
#include "libdda/analysis/crushing.h"
#include "libdda/analysis/diagnosis.h"
#include "libdda/analysis/dry_joints.h"
#include "libdda/analysis/energies.h"
#include "libdda/analysis/verdict.h"
#include "libdda/run/automatic_step.h"
#include "libdda/run/dynamic_stage.h"
#include "libdda/run/static_stage.h"

namespace voussoir
{

namespace
{

using Eigen::Vector3d;

/// Makes ready to go on from `progress.position`, or to begin.
void begin_run(driver::RunProgress& progress)
{
    const Model& model = progress.model;
    RunReport& report = progress.report;
    // Of a run that goes on, the start is the model's.
    const bool is_new = progress.position.frames == 0 && report.steps == 0;
    const State start = is_new ? progress.state : initial_state(model);
    progress.watch = CollapseWatch(model, start);
    progress.joints = joints_at_start(model, start);
    if (!progress.position.reference.empty()) count_from(model, progress.position.reference, progress.joints);
    progress.start = start.coordinates;
    if (report.joints.size() != progress.joints.size()) report.joints = no_peaks(progress.joints);
    report.bars.resize(model.bars.size());
    const bool has_moved = progress.state.step > 0;
    progress.overlaps = OverlapWatch(model, has_moved ? initial_state(model) : progress.state);
    progress.judges_crushing = has_compressive_strength(model);
    report.outcome = Outcome::completed;
    report.diagnosis.reset();
    if (is_new)
        if (const auto warning = dry_joints_warning(model, progress.state)) report.warnings.push_back(*warning);
    if (progress.position.frames == 0) driver::show(progress);
}

/// Ends the run before its first step where the model's stones lie too deep within one another.
bool may_begin(driver::RunProgress& progress)
{
    if (progress.state.step > 0) return true;
    auto wrong = start_diagnosis(drawn_overlaps(progress.overlaps));
    return !wrong || driver::give_up(std::move(*wrong), progress);
}

bool is_static(const Stage& stage)
{
    return stage.type == StageType::static_equilibrium;
}

/// In static stages nothing moves in time: the initial motion waits for the first dynamic one.
void hold_back_motion(const Model& model, const std::vector<Stage>& stages, State& state)
{
    const auto stage = static_cast<std::size_t>(state.stage);
    if (model.initial_motions.empty() || state.step > 0 || stage >= stages.size() || !is_static(stages[stage]))
        return;
    std::fill(state.velocities.begin(), state.velocities.end(), 0.0);
}

/// The motion that was held back. Its energy is there from the start.
void release_motion(driver::RunProgress& progress)
{
    EnergyLedger& energy = progress.report.energy;
    const double before = kinetic_energy(progress.model, progress.state);
    set_in_motion(progress.model, progress.state);
    const double gain = kinetic_energy(progress.model, progress.state) - before;
    energy.kinetic += gain;
    energy.start_kinetic += gain;
    energy.note_peaks();
}

/// What stands still does not slide: a point at its friction bound, as under a stone that bulges, sticks until it
/// moves. Whether it came to rest at the bound or a hair below is up to rounding, and what slides is integrated
/// otherwise.
template <int D>
void stick(ContactSetIn<D>& contacts)
{
    for (ContactPointIn<D>& point : contacts.points)
        if (point.status == ContactStatus::sliding) point.status = ContactStatus::locked;
}

void enter_stage(int stage, const std::vector<Stage>& stages, driver::RunProgress& progress)
{
    const Stage& entered = stages[stage];
    begin_stage(progress.model, stage, progress.state);
    if (entered.type == StageType::dynamic) {
        if (!progress.position.before_motion) {
            progress.position.before_motion = progress.report.energy;
            progress.position.rested = progress.state.step > 0;
        }
        if (stage > 0 && is_static(stages[stage - 1])) {
            stick(progress.state.contacts);
            stick(progress.state.planar_contacts);
        }
        const bool waited = stage > 0 && std::all_of(stages.begin(), stages.begin() + stage, is_static);
        if (waited && !progress.model.initial_motions.empty()) release_motion(progress);
        const auto warning = ground_jump_warning(progress.model, entered, progress.state);
        if (warning) progress.report.warnings.push_back(*warning);
    }
    RunPosition fresh;
    fresh.report = std::move(progress.report);
    fresh.frames = progress.position.frames;
    fresh.reference = std::move(progress.position.reference);
    fresh.before_motion = progress.position.before_motion;
    fresh.rested = progress.position.rested;
    if (entered.moves() && fresh.reference.empty()) {
        fresh.reference = progress.state.coordinates;
        count_from(progress.model, fresh.reference, progress.joints);
        fresh.report.joints = no_peaks(progress.joints);
    }
    progress.position = std::move(fresh);
    driver::suit_to_vibrations(stages, stage, progress);
}

/// Judges the structure. One of which stones have fallen has collapsed, whatever came afterwards; where the
/// numerics failed in the ruins, that is told beside it. @returns whether that is news
bool settle_outcome(const Stage& stage, driver::RunProgress& progress)
{
    RunReport& report = progress.report;
    const State& state = progress.state;
    if (report.outcome == Outcome::undecided || report.outcome == Outcome::interrupted) return false;
    const Vector3d gravity = mean_gravity(stage.gravity_ramp, stage.gravity, state.stage_time, state.stage_time);
    std::optional<Verdict> verdict =
        verdict_of(progress.model, progress.joints, {progress.start, progress.position.reference}, gravity, state);
    std::vector<int> lost = blocks_that_fell(progress.model, state, report);
    if (report.outcome == Outcome::collapsed && report.diagnosis)
        lost.insert(lost.end(), report.diagnosis->blocks.begin(), report.diagnosis->blocks.end());
    if (verdict) {
        add_lost(progress.model, lost, *verdict);
        lost = verdict->lost;
    }
    const bool is_news = report.outcome != Outcome::collapsed && !lost.empty();
    if (is_news) {
        note_lost(lost, state.time, report);
        if (report.diagnosis) report.warnings.push_back(std::move(*report.diagnosis));
        report.outcome = Outcome::collapsed;
        report.diagnosis = diagnosis_of_fallen(report);
    }
    if (report.outcome != Outcome::gave_up) report.verdict = std::move(verdict);
    return is_news;
}

/// Runs a stage to its end; false when the run ends in it.
bool run_stage(const Stage& stage, driver::RunProgress& progress)
{
    const bool done =
        is_static(stage) ? driver::run_static(stage, progress) : driver::run_dynamic(stage, progress);
    progress.position.stage_done = done;
    // How far joints are open on the way to rest is no result, nor may it matter that a run was stopped there.
    if (is_static(stage) && progress.report.outcome != Outcome::interrupted) {
        note_joints(progress.model, progress.joints, progress.state, progress.report);
        note_bars(progress.model, progress.state, progress.report);
    }
    if (done && is_static(stage)) {
        if (progress.judges_crushing) note_crushing(progress.model, progress.state, 0, progress.report);
        driver::show(progress);
    }
    if (!done) {
        settle_outcome(stage, progress);
        driver::show_end(progress);
    }
    return done;
}

/// What is said at the end of every run, however it ended.
void add_last_warnings(RunReport& report)
{
    if (auto warning = energy_warning(report.energy)) report.warnings.push_back(std::move(*warning));
    if (auto warning = overlap_warning(report)) report.warnings.push_back(std::move(*warning));
    if (auto warning = crushed_warning(report)) report.warnings.push_back(std::move(*warning));
    if (auto warning = diagnosis_of_fallen(report); warning && warning != report.diagnosis)
        report.warnings.push_back(std::move(*warning));
}

}  // namespace

RunPosition start_position(const Model& model, const std::vector<Stage>& stages, State& state)
{
    hold_back_motion(model, stages, state);
    RunPosition position;
    position.report.energy = open_ledger(model, state);
    return position;
}

RunReport run(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer)
{
    RunPosition position = start_position(model, stages, state);
    position.multiples = driver::multiples_until(state.stage_time, observer.every);
    return run(model, stages, state, observer, std::move(position));
}

RunReport run(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer,
              RunPosition position)
{
    driver::RunProgress progress{model, observer, state, Workspace(model), std::move(position)};
    begin_run(progress);
    if (!may_begin(progress)) return std::move(progress.report);
    for (int s = state.stage; s < static_cast<int>(stages.size()); ++s) {
        if (s == state.stage && progress.position.stage_done) continue;
        if (s != state.stage || state.stage_time == 0) enter_stage(s, stages, progress);
        if (!run_stage(stages[s], progress)) break;
    }
    if (progress.report.outcome == Outcome::completed && !stages.empty() &&
        settle_outcome(stages.back(), progress))
        driver::show_end(progress);
    add_last_warnings(progress.report);
    return std::move(progress.report);
}

}  // namespace voussoir
