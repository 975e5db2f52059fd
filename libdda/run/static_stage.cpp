#include "libdda/run/static_stage.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "libdda/analysis/block_shifts.h"
#include "libdda/analysis/sliding.h"
#include "libdda/limit/standing.h"
#include "libdda/run/rest_search.h"

namespace voussoir::driver
{

namespace
{

using limit::Standing;

constexpr double shorter = 0.01;       // steps of the second way
constexpr double went_far = 0.01;      // of a stone's size, by a corner: a rest that was not reached straight
constexpr double within_reach = 0.01;  // of a stone's size: contacts open by less may bear
constexpr double worth_a_look = 1e-3;  // of the mean weight of a stone, by the normal force of such a joint

double share_gone(const RunProgress& progress)
{
    return largest_share(progress.model,
                         shifts_between(progress.model, progress.position.course.start->state.coordinates,
                                        progress.state.coordinates));
}

/// What limit analysis says of the structure as it was when the stage began.
Standing standing_at_start(const Stage& stage, const RunProgress& progress, double reach = within_reach)
{
    return limit::balance_in(progress.model, progress.position.course.start->state, stage.gravity, reach).standing;
}

/// The same of stones that slide without opening. @param moving if only these may
Standing sliding_at_start(const Stage& stage, const RunProgress& progress, const std::vector<int>& moving = {})
{
    return limit::sliding_in(progress.model, progress.position.course.start->state, stage.gravity, within_reach,
                             moving);
}

/// The stones that friction alone holds, and has been used up.
std::vector<int> held_by_used_up_friction(const Stage& stage, const RunProgress& progress)
{
    const Model& model = progress.model;
    double weight = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) weight += model.mass(b) * stage.gravity.norm();
    return held_by_sliding_joints(model, progress.state,
                                  worth_a_look * weight / static_cast<double>(model.blocks.size()));
}

WayEnd end_of_way(bool rested, const RunProgress& progress)
{
    if (rested) return WayEnd::rested;
    return progress.report.outcome == Outcome::collapsed ? WayEnd::fell : WayEnd::lost;
}

/// Begins the stage again; what the first way cost is counted.
void begin_again(WayEnd first, RunProgress& progress)
{
    RunPosition& at = progress.position;
    RunReport report = at.course.start->report;
    const RunReport& way = at.report;
    report.steps = way.steps;
    report.step_cuts = way.step_cuts;
    report.unconverged_steps = way.unconverged_steps;
    report.open_close_iterations = way.open_close_iterations;
    report.factorisations = way.factorisations;
    report.linear_iterations = way.linear_iterations;
    report.factor_entries = way.factor_entries;
    report.acted = way.acted;
    report.seconds = way.seconds;
    progress.state = at.course.start->state;
    StaticCourse course;
    course.start = std::move(at.course.start);
    course.first_way = first;
    at.report = std::move(report);
    at.course = std::move(course);
    at.load_increments = at.static_steps = at.quiet_steps = 0;
    at.step_unbalanced = 1;
}

Stage second_way(Stage stage)
{
    stage.control.time_step *= shorter;
    stage.control.min_time_step = std::min(stage.control.min_time_step, stage.control.time_step);
    stage.gravity_increments *= most_times_the_increments;
    stage.max_static_steps *= most_times_the_steps;
    return stage;
}

/// Statics does not determine the normal forces of joints that rub on all sides, and with other ones the answer
/// would be another.
void say_that_friction_leaves_it_open(WayEnd end, Standing sliding, RunProgress& progress)
{
    const double balanced = sliding == Standing::balanced ? 1 : 0;
    progress.report.warnings.push_back(
        {DiagnosisKind::friction_open, progress.state.stage, {}, {static_cast<double>(end), balanced}});
}

/// Whether a fall is to be believed: nothing balances the stones, or what does would not if joints slid without
/// opening.
bool is_sure_of_fall(const Stage& stage, RunProgress& progress)
{
    const Standing standing = standing_at_start(stage, progress);
    if (standing != Standing::balanced) return standing == Standing::mechanism;
    const Standing sliding = sliding_at_start(stage, progress);
    if (sliding != Standing::mechanism) return false;
    say_that_friction_leaves_it_open(WayEnd::fell, sliding, progress);
    return true;
}

/// Whether a rest is to be believed: it was reached straight, or forces within friction balance the stones.
bool is_sure_of_rest(const Stage& stage, RunProgress& progress)
{
    const double share = share_gone(progress);
    const bool straight = !progress.position.course.was_hard && share <= went_far;
    if (!straight && standing_at_start(stage, progress, std::max(within_reach, share)) != Standing::balanced)
        return false;
    const std::vector<int> sliding_parts = held_by_used_up_friction(stage, progress);
    if (straight && sliding_parts.empty()) return true;
    const Standing sliding = sliding_at_start(stage, progress, straight ? sliding_parts : std::vector<int>{});
    if (sliding == Standing::mechanism) say_that_friction_leaves_it_open(WayEnd::rested, sliding, progress);
    return true;
}

/// The run ends without a verdict. @param second how the second way ended
bool stay_undecided(const Stage& stage, WayEnd second, RunProgress& progress)
{
    RunReport& report = progress.report;
    if (report.diagnosis) report.warnings.push_back(std::move(*report.diagnosis));
    report.outcome = Outcome::undecided;
    report.diagnosis = Diagnosis{DiagnosisKind::undecided,
                                 progress.state.stage,
                                 {},
                                 {stage.control.time_step, static_cast<double>(progress.position.course.first_way),
                                  second_way(stage).control.time_step, static_cast<double>(second)}};
    return false;
}

/// After the second way: what two of the three say, the two ways and limit analysis, which did not agree with the
/// first. Two ways that fall do so from forces that a structure has which was laid down stone by stone; limit
/// analysis knows of others, by which stones are wedged.
bool conclude(const Stage& stage, WayEnd second, RunProgress& progress)
{
    const WayEnd first = progress.position.course.first_way;
    const Standing standing = standing_at_start(stage, progress);
    if (second == WayEnd::rested && first == second) return true;
    // What balances in space may do so by more torsion than faces bear; sliding_at_start knows better.
    const auto is_bound = [&] {
        return is_planar(progress.model.kinematics) || held_by_used_up_friction(stage, progress).empty() ||
               sliding_at_start(stage, progress) == Standing::balanced;
    };
    if (second == WayEnd::rested && standing == Standing::balanced && is_bound()) return true;
    if (second == WayEnd::fell && first == second) {
        const Standing sliding = sliding_at_start(stage, progress);
        if (sliding == Standing::balanced) say_that_friction_leaves_it_open(WayEnd::fell, sliding, progress);
        return false;
    }
    if (second == WayEnd::fell && standing == Standing::mechanism) return false;
    return stay_undecided(stage, second, progress);
}

bool look_two_ways(const Stage& stage, RunProgress& progress)
{
    StaticCourse& course = progress.position.course;
    if (!course.start) course.start = StageStart{progress.state, progress.report};
    if (course.first_way == WayEnd::none) {
        const bool rested = search_rest(stage, progress);
        if (progress.report.outcome == Outcome::interrupted) return false;
        const WayEnd end = end_of_way(rested, progress);
        if (end == WayEnd::lost) return false;
        if (rested ? is_sure_of_rest(stage, progress) : is_sure_of_fall(stage, progress)) return rested;
        begin_again(end, progress);
    }
    const bool rested = search_rest(second_way(stage), progress);
    if (progress.report.outcome == Outcome::interrupted) return false;
    return conclude(stage, end_of_way(rested, progress), progress);
}

}  // namespace

bool run_static(const Stage& stage, RunProgress& progress)
{
    const bool rested = look_two_ways(stage, progress);
    if (progress.report.outcome != Outcome::interrupted) progress.position.course = {};
    return rested;
}

}  // namespace voussoir::driver
