#include "libdda/step/newton.h"

#include <Eigen/Core>
#include <atomic>
#include <cmath>
#include <limits>

#include "libdda/model/parallel.h"
#include "libdda/step/bold_steps.h"
#include "libdda/step/line_search.h"
#include "libdda/step/strength.h"
#include "libdda/step/unbalance.h"

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

// After a step that only a small share of its direction was good for, the next direction is held by a brake.
constexpr double small_share = 0.2;
constexpr double braked = 0.03;  // of the shear stiffness of sliding points

constexpr int patience = 3;  // iterations that stall, or that overshoot, before the line search changes its ways

// A direction along which many states change anyway need not be followed to its third digit. On the way to rest it
// must: steps are long there, and what is left of loose stones moves them far.
constexpr double slack_of_changes = 10;  // x linear_tolerance

// On the way to rest many changes at once are first looked for with softened joints. Source: docs/numerics.md 3.
constexpr double softness = 1.0 / 128;   // of the stiffness, where stones are let go; powers of two round nothing
constexpr double softest = 1.0 / 65536;  // the same in a static step, in which hardly any inertia helps
constexpr double hardening = 4;          // from there, each time by this
constexpr double soft_tolerance = 1e-2;  // unbalanced force / load: only the states of the contacts are wanted
constexpr double many_changes = 0.05;    // of the points
constexpr std::size_t few_changes = 8;   // points
// Of the tolerance: so far stones are relaxed in motion, and a step that is left with no more is done. What sweeps
// leave is not small like what a direction leaves: at the whole tolerance it shakes an arch that rests.
constexpr double relaxed = 0.3;

/// What the open points of a joint that breaks had stored at the start of the step [J].
template <class K>
double tension_energy(const ContactStep<K>& contacts, int patch)
{
    const PatchStep<K>& broken = contacts.patches[patch];
    double energy = 0;
    for (int i = broken.first; i < broken.first + broken.count; ++i) {
        const double opening = std::max(contacts.points[i].gap_start, 0.0);
        energy += 0.5 * contacts.points[i].normal_stiffness * opening * opening;
    }
    return energy;
}

bool fail(Trouble trouble, StepReport& report)
{
    report.trouble = trouble;
    return false;
}

template <class K>
bool fail_inverted(const StepSystem<K>& system, StepReport& report)
{
    for (std::size_t row = 0; row < system.internal.size(); ++row)
        if (!system.internal[row].admissible) report.worst_block = system.block_of_row[row];
    return fail(Trouble::inverted_block, report);
}

/// Whether so many contacts have changed their state that the iteration would be long.
template <int D>
bool is_loose(const std::vector<ContactStatus>& before, const std::vector<PointStep<D>>& points, int threads)
{
    std::atomic<std::size_t> changes = 0;
    in_parallel(points.size(), threads, [&](std::size_t first, std::size_t end) {
        std::size_t found = 0;
        for (std::size_t i = first; i < end; ++i) found += points[i].status != before[i];
        changes += found;
    });
    return changes > few_changes &&
           static_cast<double>(changes.load()) > many_changes * static_cast<double>(points.size());
}

/// The solution of the linear problem in which every contact keeps its present state: system.direction.
template <class K>
bool solve_with_states(const StepControl& control, StepSystem<K>& system, StepReport& report)
{
    evaluate_published(system.d, control.threads, system.contacts);
    if (!evaluate_residual(system.d, system)) return fail_inverted(system, report);
    if (!solve_direction(control, true, 1, system, report)) return fail(Trouble::singular_system, report);
    ++report.open_close_iterations;
    return true;
}

/// What was evaluated at system.d: contacts and residual.
enum class Known {
    nothing,
    frozen,  // with the bound as it was before
    exact,
};

struct Guess {
    Known known = Known::nothing;
    bool loose = false;
};

/// Contacts and residual at system.d with the exact bound. @returns false if a block inverts
template <class K>
bool evaluate_exactly(Known known, int threads, StepSystem<K>& system)
{
    if (known == Known::exact) return true;
    if (known == Known::frozen)
        follow_bounds(threads, system.contacts);
    else
        evaluate_contacts(system.d, FrictionBound::exact, threads, system.contacts);
    return evaluate_residual(system.d, system);
}

/// First guess: every contact keeps the state it had at the end of the last step. Right when no state changes;
/// kept only if it leaves less unbalanced force than the free flight D = 0.
template <class K>
bool guess(const StepControl& control, StepSystem<K>& system, StepReport& report, Guess& found)
{
    std::vector<ContactStatus>& before = system.statuses;
    before.resize(system.contacts.points.size());
    in_parallel(before.size(), system.threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) before[i] = system.contacts.points[i].status;
    });
    if (!solve_with_states(control, system, report)) return false;
    evaluate_contacts(system.d, FrictionBound::exact, control.threads, system.contacts);
    if (!evaluate_residual(system.d, system)) return fail_inverted(system, report);
    const double flight = unbalance(system, control.force_tolerance).worst;
    system.trial = system.direction;
    evaluate_contacts(system.trial, FrictionBound::exact, control.threads, system.contacts);
    if (evaluate_residual(system.trial, system) && unbalance(system, control.force_tolerance).worst < flight) {
        system.d = system.trial;
        found.known = Known::exact;
    }
    found.loose = is_loose(before, system.contacts.points, system.threads);
    return true;
}

/// Notes the states of the contact points. @returns how many differ from those noted before
template <class K>
std::size_t note_changes(StepSystem<K>& system)
{
    const auto& points = system.contacts.points;
    const auto state_of = [](const auto& p) { return 2 * static_cast<int>(p.status) + (p.turns_round ? 1 : 0); };
    std::atomic<std::size_t> changes = 0;
    if (system.states.size() != points.size()) system.states.assign(points.size(), -1);
    in_parallel(points.size(), system.threads, [&](std::size_t first, std::size_t end) {
        std::size_t found = 0;
        for (std::size_t i = first; i < end; ++i) {
            const int state = state_of(points[i]);
            found += system.states[i] != state;
            system.states[i] = state;
        }
        changes += found;
    });
    return changes;
}

/// Notes how far the residual last evaluated is from equilibrium. @returns residual / tolerance of the worst
/// block, infinity if the residual is no number
template <class K>
double note_unbalance(double tolerance, const StepSystem<K>& system, StepReport& report)
{
    const Unbalance now = unbalance(system, tolerance);
    report.unbalanced = now.ratio;
    report.worst_block = now.block;
    return system.residual.allFinite() ? now.worst : std::numeric_limits<double>::infinity();
}

/// Newton iteration from system.d until every block is in equilibrium within the tolerance.
template <class K>
bool descend(const Stage& stage, double tolerance, Known known, StepSystem<K>& system, StepReport& report)
{
    const StepControl& control = stage.control;
    double last = std::numeric_limits<double>::infinity();
    double last_slope = -std::numeric_limits<double>::infinity();
    BoldSteps<K> bold;
    double went = 1;  // of the last direction
    int stalled = 0, rises = 0;
    for (int iteration = 0;; ++iteration) {
        if (!evaluate_exactly(known, control.threads, system)) return fail_inverted(system, report);
        if (!system.residual.allFinite()) return fail(Trouble::inaccurate_solution, report);
        double worst = note_unbalance(tolerance, system, report);
        if (worst <= 1) return true;
        // What the last direction left of few stones is dealt with among them.
        if (iteration > 0 && is_motion(stage) && system.local.improve(tolerance, system)) {
            worst = note_unbalance(tolerance, system, report);
            if (worst <= relaxed) return true;
        }
        if (bold.have_failed(worst, system)) {
            known = Known::nothing;
            last = std::numeric_limits<double>::infinity();
            continue;
        }
        if (iteration >= control.max_open_close) return fail(Trouble::chatter, report);
        stalled = worst > 0.7 * last ? stalled + 1 : 0;
        last = worst;

        const std::size_t changed = note_changes(system);
        const bool changes = changed > few_changes;
        // On the way to rest the steps are long, and may have other solutions than the one that the potential
        // leads to.
        if (is_motion(stage) && bold.are_due(changed, system) &&
            bold.take(control, tolerance, worst, changes, system, report)) {
            known = Known::exact;
            continue;
        }
        // At rest what an elastic stone does reaches far, and nothing is saved.
        if (changes && (!K::deformable || is_motion(stage))) {
            const double share = is_motion(stage) ? relaxed : 1;
            system.relaxation.sweep(share * tolerance, worst / share, system);
            // On the way to rest one more direction makes it exact, which rest needs.
            if (is_motion(stage) && note_unbalance(tolerance, system, report) <= share) return true;
        }
        const double slack = changes && is_motion(stage) ? slack_of_changes : 1;
        system.contacts.brake = is_motion(stage) && went < small_share ? braked : 0;
        const bool solved = solve_direction(control, false, slack, system, report);
        system.contacts.brake = 0;
        if (!solved) return fail(Trouble::singular_system, report);
        ++report.open_close_iterations;
        const double slope = system.residual.dot(system.direction);
        if (!(slope < 0)) return fail(Trouble::inaccurate_solution, report);
        // Down a fixed potential the slope only flattens; where it keeps growing, the bound moves as fast as d.
        rises += slope < last_slope;
        last_slope = slope;
        const FrictionBound bound = rises >= patience ? FrictionBound::exact : FrictionBound::frozen;
        const Reach reach = line_search(slope, bound, stalled >= patience, control.threads, system);
        system.d += reach.s * system.direction;
        went = reach.s;
        known = !reach.at_hand ? Known::nothing : bound == FrictionBound::exact ? Known::exact : Known::frozen;
    }
}

/// Of nearly rigid stones every corner that opens shifts the load to others, and the iteration would try them one
/// after the other. Joints softened at the same forces let stones yield enough to find nearly all of them at once;
/// the states found then make the next guess. That the soft problem is not solved is no failure. A static step
/// goes from very soft joints to the true ones, each guess made by the one before. In motion inertia keeps what
/// one stone does from the others, and relaxation finds the states for less.
template <class K>
bool find_states_softened(const Stage& stage, StepSystem<K>& system, StepReport& report)
{
    const StepControl& control = stage.control;
    const bool is_static = stage.type == StageType::static_equilibrium;
    for (double share = is_static ? softest : softness; share < 1;) {
        const double next = is_static ? hardening * share : 1;
        scale_stiffness(share, control.threads, system.contacts);
        descend(stage, soft_tolerance, Known::nothing, system, report);
        scale_stiffness(next / share, control.threads, system.contacts);
        report.trouble = Trouble::none;
        if (!system.residual.allFinite()) system.d.setZero();
        const bool solved = solve_with_states(control, system, report);
        scale_stiffness(1 / next, control.threads, system.contacts);
        if (!solved) return false;
        system.d += system.direction;
        share = next;
    }
    return true;
}

}  // namespace

template <class K>
bool iterate_newton(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                    StepSystem<K>& system, StepReport& report)
{
    const StepControl& control = stage.control;
    report.trouble = Trouble::none;
    system.states.clear();  // those of the step before are no part of the run's state: a resumed run has none
    Guess found;
    if (!system.contacts.patches.empty() && !guess(control, system, report, found)) return false;
    if (found.loose && !is_motion(stage)) {
        if (!find_states_softened(stage, system, report)) return false;
        found.known = Known::nothing;
    }
    while (descend(stage, control.force_tolerance, found.known, system, report)) {
        const int broken = break_weakest_patch(model, contacts, system.contacts);
        if (broken < 0) return true;
        // Another structure, which has not been iterated on yet: any number of joints may break in a step.
        system.fracture += tension_energy(system.contacts, broken);
        found.known = Known::nothing;
    }
    return false;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                                 \
    template bool iterate_newton(const Model&, const Stage&, const ContactSetIn<K::dimension>&, StepSystem<K>&, \
                                 StepReport&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
