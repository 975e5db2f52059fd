#include "libdda/iterate/newton.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>

#include "libdda/forces/strength.h"
#include "libdda/iterate/line_search.h"
#include "libdda/model/parallel.h"
#include "libdda/problem/unbalance.h"

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

constexpr double nowhere = std::numeric_limits<double>::infinity();

bool fail(Trouble trouble, StepReport& report)
{
    report.trouble = trouble;
    return false;
}

template <class K>
bool fail_inverted(const StepProblem<K>& problem, StepReport& report)
{
    for (std::size_t row = 0; row < problem.internal.size(); ++row)
        if (!problem.internal[row].admissible) report.worst_block = problem.block_of_row[row];
    return fail(Trouble::inverted_block, report);
}

/// Contacts and residual at d. @returns false if a block inverts
template <class K>
bool evaluate(const VectorXd& d, StepProblem<K>& problem)
{
    evaluate_contacts(d, problem.patch_threads, problem.contacts);
    return evaluate_residual(d, problem);
}

/// Notes the states of the contact points. @returns how many differ from those noted before
template <class K>
std::size_t note_changes(const StepProblem<K>& problem, std::vector<int>& states)
{
    const auto& points = problem.contacts.points;
    std::atomic<std::size_t> changes = 0;
    if (states.size() != points.size()) states.assign(points.size(), -1);
    in_parallel(points.size(), problem.threads, [&](std::size_t first, std::size_t end) {
        std::size_t found = 0;
        for (std::size_t i = first; i < end; ++i) {
            const int state = 2 * static_cast<int>(points[i].status) + (points[i].turns_round ? 1 : 0);
            found += states[i] != state;
            states[i] = state;
        }
        changes += found;
    });
    return changes;
}

/// Notes how far the residual last evaluated is from equilibrium. @returns residual / tolerance of the worst block
template <class K>
double note_unbalance(double tolerance, const StepProblem<K>& problem, StepReport& report)
{
    const Unbalance now = unbalance(problem, tolerance);
    report.unbalanced = now.ratio;
    report.worst_block = now.block;
    return now.worst;
}

/// The open-close iteration of one step.
template <class K>
class Newton
{
 public:
    Newton(const Stage& stage, StepProblem<K>& problem, Iteration<K>& with, StepReport& report)
        : stage_(stage),
          control_(stage.control),
          problem_(problem),
          with_(with),
          rules_(with.rules),
          report_(report)
    {
    }

    bool stays_at_rest();
    bool guess();
    bool descend(double tolerance);
    void evaluate_again() { is_at_hand_ = false; }

 private:
    bool solve_with_states();
    bool find_direction(std::size_t changed, double worst);

    const Stage& stage_;
    const StepControl& control_;
    StepProblem<K>& problem_;
    Iteration<K>& with_;
    const IterationRules& rules_;
    StepReport& report_;
    bool is_at_hand_ = false;  // contacts and residual are known at d
};

/// The solution of the linear problem in which every contact keeps its present state.
template <class K>
bool Newton<K>::solve_with_states()
{
    evaluate_published(problem_.d, problem_.patch_threads, problem_.contacts);
    if (!evaluate_residual(problem_.d, problem_)) return fail_inverted(problem_, report_);
    if (!with_.directions.find(true, problem_, report_)) return fail(Trouble::singular_system, report_);
    ++report_.open_close_iterations;
    return true;
}

/// Whether nothing moves, and nothing has to: then the step is solved. Contacts that bear next to nothing would
/// take turns for what the rounding of places does to their forces, and set the stones in motion.
template <class K>
bool Newton<K>::stays_at_rest()
{
    const bool rests = is_motion(stage_) &&
                       std::all_of(problem_.block_of_row.begin(), problem_.block_of_row.end(), [&](int block) {
                           const BlockStep<K>& b = problem_.blocks[block];
                           return b.predicted.centroid == b.start.centroid && b.predicted.map == b.start.map;
                       });
    if (!rests) return false;
    const ContactStep<K> at_start = problem_.contacts;
    if (evaluate(problem_.d, problem_) && is_balanced_but_for_rounding(problem_, control_.force_tolerance)) {
        note_unbalance(control_.force_tolerance, problem_, report_);
        problem_.stays = true;
        return true;
    }
    problem_.contacts = at_start;  // points have their states of then again
    return false;
}

/// States of the step before are forgotten: they are no part of the run's state, and before the first direction
/// stones are relaxed, however few have changed. The guess is kept only if it leaves less unbalanced force than
/// the free flight D = 0.
template <class K>
bool Newton<K>::guess()
{
    with_.states.clear();
    if (!solve_with_states()) return false;
    if (!evaluate(problem_.d, problem_)) return fail_inverted(problem_, report_);
    const double flight = unbalance(problem_, control_.force_tolerance).worst;
    is_at_hand_ = evaluate(with_.directions.direction, problem_) &&
                  unbalance(problem_, control_.force_tolerance).worst < flight;
    if (is_at_hand_) problem_.d = with_.directions.direction;
    return true;
}

/// Towards equilibrium of all stones. In motion, where few states change, what is left is how the bound follows
/// the normal force, and the whole tangent knows it. On the way to rest, where steps are long, it may lead to
/// another equilibrium than the potential.
template <class K>
bool Newton<K>::find_direction(std::size_t changed, double worst)
{
    const double few = static_cast<double>(rules_.few_changes) +
                       rules_.few_changes_of_all * static_cast<double>(with_.states.size());
    const VectorXd& direction = with_.directions.direction;
    ++report_.open_close_iterations;
    if (is_motion(stage_) && static_cast<double>(changed) <= few) {
        const double tolerance = std::clamp(rules_.linear_share / worst, rules_.finest, rules_.coarsest);
        if (with_.directions.find_whole(tolerance, rules_, problem_, report_) &&
            problem_.residual.dot(direction) < 0) {
            ++report_.acted.whole_tangents;
            return true;
        }
    }
    if (!with_.directions.find(false, problem_, report_)) return fail(Trouble::singular_system, report_);
    return problem_.residual.dot(direction) < 0 || fail(Trouble::inaccurate_solution, report_);
}

/// From d on until every block is in equilibrium within the tolerance.
template <class K>
bool Newton<K>::descend(double tolerance)
{
    for (int iteration = 0;; ++iteration) {
        if (!is_at_hand_ && !evaluate(problem_.d, problem_)) return fail_inverted(problem_, report_);
        if (!problem_.residual.allFinite()) return fail(Trouble::inaccurate_solution, report_);
        const double worst = note_unbalance(tolerance, problem_, report_);
        if (worst <= 1) return true;
        if (iteration >= control_.max_open_close) return fail(Trouble::chatter, report_);
        const std::size_t changed = note_changes(problem_, with_.states);
        if (changed > rules_.few_changes) {
            with_.relaxation.sweep(tolerance, worst, rules_, problem_);
            ++report_.acted.relaxed;
        }
        if (!find_direction(changed, worst)) return false;
        const VectorXd& direction = with_.directions.direction;
        const double slope_0 = problem_.residual.dot(direction);
        const auto slope_at = [&](double s) {
            with_.trial = problem_.d + s * direction;
            return evaluate(with_.trial, problem_) ? problem_.residual.dot(direction) : nowhere;
        };
        const Reach reach = line_search(slope_0, rules_.of_all, slope_at);
        // A little beyond a corner is better than no way at all.
        if (!reach.is_found) slope_at(reach.low > 0 ? reach.low : reach.high);
        report_.acted.shortened += reach.high < 1 || !reach.is_found;
        problem_.d.swap(with_.trial);
        is_at_hand_ = true;
    }
}

}  // namespace

template <class K>
bool iterate_newton(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                    StepProblem<K>& problem, Iteration<K>& iteration, StepReport& report)
{
    report.trouble = Trouble::none;
    Newton<K> newton(stage, problem, iteration, report);
    if (newton.stays_at_rest()) return true;
    if (!problem.contacts.patches.empty() && !newton.guess()) return false;
    while (newton.descend(stage.control.force_tolerance)) {
        const std::optional<double> lost = break_weakest_joint(model, contacts, problem.contacts);
        if (!lost) return true;
        problem.fracture += *lost;
        newton.evaluate_again();
    }
    return false;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                                  \
    template bool iterate_newton(const Model&, const Stage&, const ContactSetIn<K::dimension>&, StepProblem<K>&, \
                                 Iteration<K>&, StepReport&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
