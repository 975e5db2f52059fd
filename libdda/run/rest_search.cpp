#include "libdda/run/rest_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libdda/analysis/block_shifts.h"
#include "libdda/analysis/mechanism.h"
#include "libdda/limit/standing.h"
#include "libdda/model/elasticity.h"

namespace voussoir::driver
{

namespace
{

// Residual that a static step may keep. Its contact forces obey friction whatever it is, so all that it costs is
// that the way to rest bends a little.
constexpr double inexactness = 0.1;  // share of the unbalanced force of the step before
constexpr double loosening = 1000;   // times the force_tolerance, at most
constexpr int patience = 3;          // times the iterations of a dynamic step: one that is cut for them costs more
constexpr double longest_step = 0.2;  // of a stone's size, that a corner of it may go in one step
// Motion of a corner since the stage began, as shares of its stone's size.
constexpr double settled = 0.1;    // what settles goes no farther; what does, and goes on, falls
constexpr double creeping = 0.01;  // the same for stones that gather speed all the way, in many steps
constexpr int long_steady = 20;    // as many
constexpr int endless_steady =
    100;  // steps in which stones that were let go gathered speed: however far they came
constexpr double large_strain = 0.01;  // of a stone: no masonry
constexpr double overturned = 0.5;     // what has gone so far has fallen, though it lies still by now
constexpr int enough_steady = 3;       // steps on one way that show that stones do go on
// Of two steps running that lead on one way:
constexpr double same_way = 0.7;   // cosine between them, at least
constexpr double no_slower = 0.7;  // of the acceleration, at least
constexpr double let_go = 1e-4;  // of a stone's size, since the stage began: more than what settles by elasticity
constexpr double nearly_balanced = 1e-5;  // unbalanced force / load
constexpr double motionless = 1e-6;       // of a stone's size in a step of the nominal length
constexpr double rounding = 1e-12;  // of a stone's size: what is unbalanced without moving more drowns in rounding
constexpr double longer = 100;  // times that, at most, in steps so much longer: what falls goes with their square
constexpr int enough_idle = 5;  // negligible steps, after which contacts that still take turns do not matter
constexpr double longest_time = 1e4;  // times the nominal time step: of steps of stones on one way
// Signs of stones that fall, at which it is worth the price of a few steps to ask whether anything balances them:
constexpr int many_iterations = 40;     // of a step
constexpr double far = 5e-3;            // of a stone's size, gone in a step
constexpr double fall_reach = settled;  // of a stone's size: contacts open by less are taken to bear
constexpr double asked_again = 2;       // times as far as when it was last asked, and as far as in one step
constexpr double first_fall = 1e-3;     // of a stone's size, that it falls in the first step in which it is let go
constexpr int enough_fall = 3;          // steps in which stones that nothing balances gathered speed

bool is_at_rest(const RunPosition& at)
{
    return at.quiet_steps >= 2 || at.course.idle >= enough_idle;
}

/// Ends the run with the stones that fall, where some do. What else there was to say of its end becomes a warning.
void collapse(RunProgress& progress, const std::vector<BlockShift>& gone)
{
    RunReport& report = progress.report;
    const auto last = shifts_between(progress.model, progress.position.course.before, progress.state.coordinates);
    if (report.diagnosis) report.warnings.push_back(std::move(*report.diagnosis));
    report.outcome = Outcome::collapsed;
    report.diagnosis = mechanism_of(progress.model, progress.state.stage, gone, last);
}

std::vector<BlockShift> gone_in_stage(const RunProgress& progress)
{
    return shifts_between(progress.model, progress.position.course.start->state.coordinates,
                          progress.state.coordinates);
}

/// What a step adds to the course.
void note_step(const Stage& stage, const StepReport& step, RunProgress& progress)
{
    StaticCourse& course = progress.position.course;
    const Model& model = progress.model;
    const auto last = shifts_between(model, progress.before.coordinates, progress.state.coordinates);
    double mass = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) mass += model.mass(b);
    const double squared = product_of(model, last, last);
    const double acceleration = 2 * std::sqrt(squared / mass) / (step.time_step * step.time_step);
    bool goes_on = false;
    if (!course.before.empty()) {
        const auto previous = shifts_between(model, course.before, progress.before.coordinates);
        const double scale = std::sqrt(squared * product_of(model, previous, previous));
        goes_on =
            product_of(model, last, previous) > same_way * scale && acceleration > no_slower * course.acceleration;
    }
    course.steady = goes_on ? course.steady + 1 : 0;
    const double length = std::clamp(step.time_step / stage.control.time_step, 1.0, longer);
    const double moved = largest_share(model, last);
    const bool idle = (step.inertia_ratio <= stage.unbalanced_tolerance && moved <= motionless * length) ||
                      (step.time_step >= stage.control.time_step && moved <= rounding);
    course.idle = idle ? course.idle + 1 : 0;
    course.acceleration = acceleration;
    course.before = progress.before.coordinates;
}

/// Length of the step after this one [s]: what was hard to solve is not made longer, and stones do not jump.
double next_step(const StepReport& step, double share, const StaticCourse& course, double nominal)
{
    const double growth = step.cuts > 0 || step.open_close_iterations > 25 ? 1.2
                          : step.open_close_iterations > 12                ? 1.6
                                                                           : 3.0;
    const bool nearly_still =
        step.cuts == 0 && step.open_close_iterations <= 12 && step.inertia_ratio < nearly_balanced;
    const double most = nearly_still || course.steady >= enough_steady ? longest_time * nominal
                                                                       : std::max(nominal, 0.3 * step.time_step);
    const double jump = share > 0 ? 0.9 * std::sqrt(longest_step / share) : growth;
    return std::min(step.time_step * std::min(growth, jump), most);
}

/// Whether stones that have gone on one way are to keep their velocity. Held at rest at the start of each step
/// they would go a gravity h^2 / 2 at a time, and joints that slide and open do not let h grow.
bool may_let_go(const StaticCourse& course, double share)
{
    return course.steady >= enough_steady && share > let_go;
}

/// Takes the velocities of all stones.
void stop_stones(RunProgress& progress)
{
    EnergyLedger& energy = progress.report.energy;
    std::fill(progress.state.velocities.begin(), progress.state.velocities.end(), 0);
    energy.damping_static += energy.kinetic;
    energy.kinetic = 0;
    progress.position.course.kinetic = 0;
}

/// What contacts gave or took when they were found anew, and what the residual of a loose solution did, goes with
/// what the stage takes, as in its other steps.
void book_as_static(RunProgress& progress)
{
    EnergyLedger& energy = progress.report.energy;
    const EnergyLedger& before = progress.energy_before;
    energy.damping_static += energy.redetection - before.redetection + energy.residual() - before.residual();
    energy.redetection = before.redetection;
    energy.peak_taken = before.peak_taken;
    energy.peak_given = before.peak_given;
}

/// The stage as stones that are let go see it: time does not pass, but they keep what the step gave them.
Stage let_go_in(const Stage& loaded, bool falls)
{
    Stage free = loaded;
    free.type = StageType::dynamic;
    free.control.integrator = Integrator::newmark;  // forces of the end of the step, as a static step has them
    free.looks_for_rest = true;
    if (falls) free.control.max_open_close = std::min(many_iterations, loaded.control.max_open_close);
    return free;
}

/// After a step of stones that were let go: once they slow down, or turn, they are stopped.
void note_free_step(RunProgress& progress)
{
    StaticCourse& course = progress.position.course;
    const Model& model = progress.model;
    const auto last = shifts_between(model, progress.before.coordinates, progress.state.coordinates);
    const auto previous = shifts_between(model, course.before, progress.before.coordinates);
    const double scale = std::sqrt(product_of(model, last, last) * product_of(model, previous, previous));
    const bool goes_on =
        product_of(model, last, previous) > same_way * scale && progress.report.energy.kinetic >= course.kinetic;
    const bool first = course.kinetic == 0;
    course.before = progress.before.coordinates;
    course.kinetic = progress.report.energy.kinetic;
    course.steady = goes_on ? course.steady + 1 : 0;
    if (goes_on || first) return;
    course.falls = false;
    stop_stones(progress);
}

/// Smallest stone that is not held [m].
double smallest_stone(const Model& model)
{
    double smallest = std::numeric_limits<double>::max();
    std::vector<bool> held(model.blocks.size(), false);
    for (const Foundation& foundation : model.foundations) held[foundation.block] = true;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b)
        if (!held[b]) smallest = std::min(smallest, size_of(model, b));
    return smallest;
}

/// Whether a structure has not been asked where it is now.
bool may_ask(const RunProgress& progress)
{
    const double asked = progress.position.course.asked_at;
    return asked < 0 || largest_share(progress.model, gone_in_stage(progress)) > asked_again * asked + far;
}

/// Asks whether anything balances the stones where they are. If nothing does they fall, and are let go in steps
/// that are short enough to follow them.
void look_for_balance(const Stage& loaded, RunProgress& progress)
{
    RunPosition& at = progress.position;
    at.course.asked_at = largest_share(progress.model, gone_in_stage(progress));
    const auto balance = limit::balance_in(progress.model, progress.state, loaded.gravity, fall_reach);
    at.course.falls = balance.standing == limit::Standing::mechanism;
    if (!at.course.falls) return;
    const double fall = 2 * first_fall * smallest_stone(progress.model) / loaded.gravity.norm();
    progress.state.next_time_step = std::min(loaded.control.time_step, std::sqrt(fall));
    at.course.steady = 0;
    at.course.kinetic = 0;
    at.course.before = progress.state.coordinates;
}

/// Makes a step in which no stone jumps; false when the run ends here.
bool try_short_step(const Stage& loaded, double h, RunProgress& progress, StepReport& step, double& share)
{
    int cuts = 0;
    while (true) {
        if (!try_step(loaded, h, progress, step)) return false;
        share = largest_share(progress.model, shifts_between(progress.model, progress.before.coordinates,
                                                             progress.state.coordinates));
        if (share <= longest_step || step.time_step <= loaded.control.min_time_step) break;
        h = step.time_step * std::clamp(0.9 * std::sqrt(longest_step / share), 0.01, 0.9);
        h = std::max(h, loaded.control.min_time_step);
        take_back(progress);
        cuts += step.cuts + 1;
    }
    step.cuts += cuts;
    return true;
}

/// Whether stones are so soft that they settle by their own strain, as far as others fall.
bool settle_by_strain(const Model& model, const State& state)
{
    for (int b = 0; is_deformable(model.kinematics) && b < static_cast<int>(model.blocks.size()); ++b)
        if (green_strain_of(pose_of(model.kinematics, state, b).map).norm() > large_strain) return true;
    return false;
}

/// Whether stones that were let go have gone on one way and gained energy, in as many steps running.
bool gathers_speed(const StaticCourse& course, int steps)
{
    return course.kinetic > 0 && course.steady >= steps;
}

/// Whether stones are higher than they were drawn, because they were drawn within one another and pressed apart:
/// they may go far and gather speed, but not by falling.
bool are_pressed_apart(const RunProgress& progress)
{
    const EnergyLedger& energy = progress.report.energy;
    return progress.state.stage == 0 && energy.start_contact > 0 && energy.input() < 0;
}

/// Whether stones fall, as far as can be seen by now. @param gone since the stage began
bool is_falling(const RunProgress& progress, const std::vector<BlockShift>& gone)
{
    const StaticCourse& course = progress.position.course;
    const double share = largest_share(progress.model, gone);
    if (settle_by_strain(progress.model, progress.state) || are_pressed_apart(progress)) return false;
    if (course.falls && gathers_speed(course, enough_fall) && share > let_go) return true;
    return (course.steady >= enough_steady && share > settled) ||
           (gathers_speed(course, long_steady) && share > creeping) || gathers_speed(course, endless_steady);
}

/// Whether stones lie still where they have fallen to.
bool has_fallen(const RunProgress& progress, const std::vector<BlockShift>& gone)
{
    return largest_share(progress.model, gone) > overturned && !settle_by_strain(progress.model, progress.state);
}

/// After the last step that the stage allows, or one that could not be made. @returns false
bool end_unbalanced(RunProgress& progress)
{
    const auto gone = gone_in_stage(progress);
    const StaticCourse& course = progress.position.course;
    const double share = largest_share(progress.model, gone);
    const bool goes_on = (share > settled && course.steady > 0) || gathers_speed(course, long_steady);
    if (has_fallen(progress, gone) || (goes_on && !are_pressed_apart(progress))) collapse(progress, gone);
    return false;
}

bool give_up_resting(RunProgress& progress)
{
    give_up({DiagnosisKind::no_equilibrium,
             progress.state.stage,
             {},
             {static_cast<double>(progress.position.static_steps), progress.report.static_unbalanced}},
            progress);
    end_unbalanced(progress);
    progress.report.unconverged_steps += progress.report.outcome == Outcome::gave_up;
    return false;
}

/// Makes a step if that takes few iterations and no stone goes far in it. @returns whether it was made
bool make_easy_step(const Stage& loaded, double h, RunProgress& progress, StepReport& step, double& share)
{
    Stage brief = loaded;
    brief.control.max_open_close = std::min(many_iterations, loaded.control.max_open_close);
    brief.control.min_time_step = h;
    RunReport& report = progress.report;
    if (!try_step(brief, h, progress, step)) {
        report.outcome = Outcome::completed;
        report.diagnosis.reset();
        --report.unconverged_steps;
        report.step_cuts -= step.cuts;  // they are counted with the step that is made instead
        return false;
    }
    share = largest_share(progress.model,
                          shifts_between(progress.model, progress.before.coordinates, progress.state.coordinates));
    if (share <= far) return true;
    take_back(progress);
    return false;
}

/// Makes one step under `loaded` and counts it; false when it gave up. @param share gone in it, of a stone's size
bool make_step(Stage& loaded, bool& is_free, RunProgress& progress, StepReport& step, double& share)
{
    State& state = progress.state;
    const double time = state.time;
    const auto length = [&] { return state.next_time_step > 0 ? state.next_time_step : loaded.control.time_step; };
    const bool asks = !is_free && may_ask(progress);
    if (!asks || !make_easy_step(loaded, length(), progress, step, share)) {
        const StepReport lost = asks ? step : StepReport{};
        if (asks) {
            progress.position.course.was_hard = true;
            look_for_balance(loaded, progress);
            is_free = progress.position.course.falls;
        }
        if (!try_short_step(is_free ? let_go_in(loaded, progress.position.course.falls) : loaded, length(),
                            progress, step, share))
            return false;
        add_cost(lost, step);
    }
    progress.position.course.was_hard |= step.cuts > 0;
    state.time = time;
    if (is_free) book_as_static(progress);
    return keep_step(loaded, progress, step);
}

/// What the step says of how far the stage has come.
void note_balance(const Stage& stage, bool is_free, RunProgress& progress, StepReport& step)
{
    RunPosition& at = progress.position;
    if (is_free) {
        note_free_step(progress);
        step.inertia_ratio = at.step_unbalanced;
    } else {
        note_step(stage, step, progress);
    }
    progress.report.static_unbalanced = at.step_unbalanced = step.inertia_ratio;
    const bool balanced =
        !is_free && step.inertia_ratio <= stage.unbalanced_tolerance && !step.contact_state_changed;
    at.quiet_steps = balanced ? at.quiet_steps + 1 : 0;
    ++at.static_steps;
}

/// One step under `loaded`; false when the run ends here.
bool step_at_rest(const Stage& stage, Stage& loaded, RunProgress& progress)
{
    RunPosition& at = progress.position;
    // A step need only be solved as well as its own unbalanced force deserves: far from equilibrium the
    // last digits are friction points taking turns; near it the tolerance must not hide what is left.
    bool is_free = at.course.falls || at.course.kinetic > 0 ||
                   may_let_go(at.course, largest_share(progress.model, gone_in_stage(progress)));
    loaded.control.force_tolerance =
        std::min(loosening * stage.control.force_tolerance,
                 std::max(inexactness * at.step_unbalanced, 0.1 * stage.unbalanced_tolerance));
    StepReport step;
    double share = 0;
    if (!make_step(loaded, is_free, progress, step, share)) return end_unbalanced(progress);
    note_balance(stage, is_free, progress, step);
    progress.state.next_time_step = next_step(step, share, at.course, stage.control.time_step);
    if (progress.observer.step) progress.observer.step(progress.state, step, progress.report);
    const auto gone = gone_in_stage(progress);
    if (is_falling(progress, gone) || (is_at_rest(at) && has_fallen(progress, gone))) {
        collapse(progress, gone);
        return false;
    }
    if (!is_at_rest(at) && at.static_steps == stage.max_static_steps) return give_up_resting(progress);
    save(progress);
    return goes_on(progress);
}

}  // namespace

bool search_rest(const Stage& stage, RunProgress& progress)
{
    RunPosition& at = progress.position;
    Stage loaded = stage;
    if (stage.control.open_close == OpenClose::newton) loaded.control.max_open_close *= patience;
    for (; at.load_increments < stage.gravity_increments; ++at.load_increments) {
        loaded.gravity = stage.gravity * (at.load_increments + 1) / stage.gravity_increments;
        while (!is_at_rest(at)) {
            if (!step_at_rest(stage, loaded, progress)) return false;
        }
        at.static_steps = at.quiet_steps = at.course.idle = 0;
        at.step_unbalanced = 1;
    }
    return true;
}

}  // namespace voussoir::driver
