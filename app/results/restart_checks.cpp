#include "app/results/restart_checks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/results/counts.h"
#include "app/results/state_checks.h"
#include "libdda/analysis/joint_openings.h"
#include "libdda/run/static_stage.h"

namespace voussoir::app::results
{

namespace
{

bool is_sound(const RunReport& report)
{
    const std::array counts{report.steps,
                            report.step_cuts,
                            report.unconverged_steps,
                            report.divided_steps,
                            report.refused_steps,
                            report.open_close_iterations,
                            report.factorisations,
                            report.linear_iterations,
                            report.factor_entries,
                            report.acted.relaxed,
                            report.acted.whole_tangents,
                            report.acted.shortened,
                            report.blows.solved,
                            report.blows.unfinished};
    const auto& verdict = report.verdict;
    if (verdict && (verdict->standing < Standing::stands || verdict->standing > Standing::fallen ||
                    verdict->damage < DamageLevel::none || verdict->damage > DamageLevel::significant_damage))
        return false;
    return report.outcome >= Outcome::completed && report.outcome <= Outcome::interrupted &&
           std::all_of(counts.begin(), counts.end(), is_count) &&
           (!report.diagnosis || is_whole(*report.diagnosis)) &&
           std::all_of(report.warnings.begin(), report.warnings.end(), is_whole);
}

bool is_sound(const TrustStart& trust)
{
    return trust.modes.outcome >= ModesOutcome::found && trust.modes.outcome <= ModesOutcome::failed &&
           is_count(trust.modes.loose);
}

bool are_finite(const std::vector<double>& numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

bool is_sound(const StaticCourse& course)
{
    const bool start = !course.start || (results::is_sound(course.start->state) && is_sound(course.start->report));
    return start && course.first_way >= WayEnd::none && course.first_way <= WayEnd::lost &&
           are_finite(course.before) && std::isfinite(course.acceleration) && std::isfinite(course.kinetic) &&
           std::isfinite(course.asked_at);
}

bool is_sound(const RunPosition& at)
{
    constexpr int most_halvings = 30;
    const std::array<std::int64_t, 9> counts{at.parts,       at.frames,          at.multiples,
                                             at.divisions,   at.load_increments, at.static_steps,
                                             at.quiet_steps, at.course.steady,   at.course.idle};
    return at.halvings >= 0 && at.halvings <= most_halvings && is_sound(at.report) &&
           are_finite(at.pace.accelerations) && std::isfinite(at.pace.time_step) && is_sound(at.course) &&
           are_finite(at.reference) && std::all_of(counts.begin(), counts.end(), is_count);
}

/// The clock of the stage is where its grid is, and the counters of a static stage are within its own.
bool fits(const State& state, const RunPosition& at, const Stage& stage)
{
    constexpr double rounding = 1e-9;
    const double step = stage.control.time_step;
    const auto is_place = [&](const std::vector<double>& place) {
        return place.empty() || place.size() == state.coordinates.size();
    };
    if (!is_place(at.course.before) || !is_place(at.reference)) return false;
    if (!at.pace.accelerations.empty() && at.pace.accelerations.size() != state.velocities.size()) return false;
    if (stage.type == StageType::static_equilibrium)
        return at.load_increments <= stage.gravity_increments * driver::most_times_the_increments &&
               at.static_steps <= stage.max_static_steps * driver::most_times_the_steps;
    return state.stage_time >= 0 && state.stage_time <= stage.duration * (1 + rounding) &&
           std::abs(state.stage_time - static_cast<double>(state.grid) * step) <= step * (1 + rounding);
}

/// What was said of the run is said of blocks and stages that there are.
bool fits(const Diagnosis& diagnosis, const Case& the_case)
{
    const auto blocks = static_cast<int>(the_case.model.blocks.size());
    return diagnosis.stage < static_cast<int>(the_case.stages.size()) &&
           std::all_of(diagnosis.blocks.begin(), diagnosis.blocks.end(),
                       [&](int block) { return block >= 0 && block < blocks; });
}

bool told_fits(const RunReport& report, const Case& the_case)
{
    const auto stages = static_cast<int>(the_case.stages.size());
    const auto is_of_a_stage = [&](const ShorterSteps& shorter) {
        return shorter.stage >= 0 && shorter.stage < stages && shorter.time_step > 0;
    };
    return std::all_of(report.shorter_steps.begin(), report.shorter_steps.end(), is_of_a_stage) &&
           (!report.diagnosis || fits(*report.diagnosis, the_case)) &&
           std::all_of(report.warnings.begin(), report.warnings.end(),
                       [&](const Diagnosis& warning) { return fits(warning, the_case); });
}

/// The run would go on with the joints that the model has at its start.
bool are_joints_of(const std::vector<JointPeaks>& peaks, const Model& model)
{
    const std::vector<WatchedJoint> joints = joints_at_start(model, initial_state(model));
    return std::equal(peaks.begin(), peaks.end(), joints.begin(), joints.end(),
                      [](const JointPeaks& entry, const WatchedJoint& joint) {
                          return entry.block_a == joint.block_a && entry.block_b == joint.block_b;
                      });
}

bool fits(const Verdict& verdict, const Model& model)
{
    const auto count = static_cast<int>(model.blocks.size());
    const auto is_block = [&](int block) { return block >= 0 && block < count; };
    const auto is_maybe_block = [&](int block) { return block >= -1 && block < count; };
    return std::all_of(verdict.lost.begin(), verdict.lost.end(), is_block) && is_maybe_block(verdict.fastest) &&
           verdict.blocks.size() == model.blocks.size() && is_maybe_block(verdict.worst.block_a) &&
           is_maybe_block(verdict.worst.block_b);
}

bool fits(const RunReport& report, const Model& model)
{
    const auto is_block = [&](int block) {
        return block >= 0 && static_cast<std::size_t>(block) < model.blocks.size();
    };
    if (report.verdict && !fits(*report.verdict, model)) return false;
    const DeepestOverlap& deepest = report.deepest;
    const bool no_overlap = deepest.share == 0 && deepest.block_a == -1 && deepest.block_b == -1;
    if (!no_overlap && (!is_block(deepest.block_a) || !is_block(deepest.block_b))) return false;
    if (!are_joints_of(report.joints, model) || report.bars.size() != model.bars.size()) return false;
    return std::all_of(report.fallen.begin(), report.fallen.end(),
                       [&](const FallenBlock& fallen) { return is_block(fallen.block); }) &&
           std::all_of(report.crushed.begin(), report.crushed.end(), [&](const CrushedJoint& crushed) {
               return is_block(crushed.block_a) && is_block(crushed.block_b);
           });
}

bool fits(const StaticCourse& course, const Model& model)
{
    return !course.start || (results::fits(course.start->state, model) && fits(course.start->report, model));
}

}  // namespace

bool is_sound(const Restart& restart)
{
    return is_sound(restart.state) && is_sound(restart.position) && is_count(restart.history_rows) &&
           (!restart.trust || is_sound(*restart.trust)) && std::isfinite(restart.wall_time) &&
           std::isfinite(restart.cpu_time);
}

bool fits(const Restart& restart, const Case& the_case)
{
    if (!told_fits(restart.position.report, the_case)) return false;
    if (restart.ended) return true;
    const auto stage = static_cast<std::size_t>(restart.state.stage);
    return stage < the_case.stages.size() && fits(restart.state, restart.position, the_case.stages[stage]) &&
           fits(restart.state, the_case.model) && fits(restart.position.report, the_case.model) &&
           fits(restart.position.course, the_case.model);
}

}  // namespace voussoir::app::results
