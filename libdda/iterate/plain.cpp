#include "libdda/iterate/plain.h"

#include <cmath>
#include <limits>
#include <optional>

#include "libdda/forces/strength.h"
#include "libdda/problem/unbalance.h"
#include "libdda/solve/linear_solver.h"

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

constexpr int most_bisections = 60;  // double numbers have no more digits

/// The residual R(d) with friction at its bound of the same iterate. @returns false if a block inverts
template <class K>
bool evaluate(const VectorXd& d, StepProblem<K>& problem)
{
    evaluate_contacts(d, 1, problem.contacts);
    return evaluate_residual(d, problem) && problem.residual.allFinite();
}

/// K direction = -R, K the stiffness at the last evaluation with the friction bound held.
/// @param published with the states of contacts held instead
template <class K>
bool find_direction(bool published, StepProblem<K>& problem, StepReport& report, VectorXd& direction)
{
    const auto cholesky = solve::make_linear_solver(LinearSolverKind::cholmod, 0);
    assemble_matrix(published, problem);
    const bool solved = cholesky->solve(problem.matrix, problem.residual, direction).solved;
    direction = -direction;
    ++report.open_close_iterations;
    ++report.factorisations;
    return solved && direction.allFinite();
}

/// A share s of the direction at which what the forces do along it has halved: 1, or what bisection finds.
/// R . direction is negative at 0; where it is positive at 1 it has gone through zero.
template <class K>
double share_of_direction(const VectorXd& direction, StepProblem<K>& problem)
{
    const auto slope = [&](double s) {
        const bool is_whole = evaluate(VectorXd(problem.d + s * direction), problem);
        return is_whole ? problem.residual.dot(direction) : std::numeric_limits<double>::infinity();
    };
    const double enough = 0.5 * std::abs(problem.residual.dot(direction));
    if (slope(1) <= enough) return 1;
    double low = 0, high = 1;
    for (int i = 0; i < most_bisections; ++i) {
        const double s = 0.5 * (low + high), there = slope(s);
        if (std::abs(there) <= enough) return s;
        (there > 0 ? high : low) = s;
    }
    return low;
}

/// Begins where the step leads if every contact keeps the state that it has, if that is better than where it
/// leads without forces.
template <class K>
bool guess(const StepControl& control, StepProblem<K>& problem, StepReport& report)
{
    VectorXd direction;
    evaluate_published(problem.d, 1, problem.contacts);
    if (!evaluate_residual(problem.d, problem) || !find_direction(true, problem, report, direction)) return false;
    if (!evaluate(problem.d, problem)) return false;
    const double flight = unbalance(problem, control.force_tolerance).worst;
    if (evaluate(direction, problem) && unbalance(problem, control.force_tolerance).worst < flight)
        problem.d = direction;
    return true;
}

/// Goes on until every block is in equilibrium.
template <class K>
bool descend(const StepControl& control, StepProblem<K>& problem, StepReport& report)
{
    for (int iteration = 0; iteration < control.max_open_close; ++iteration) {
        if (!evaluate(problem.d, problem)) return false;
        const Unbalance now = unbalance(problem, control.force_tolerance);
        report.unbalanced = now.ratio;
        report.worst_block = now.block;
        if (now.worst <= 1) return true;
        VectorXd direction;
        if (!find_direction(false, problem, report, direction)) return false;
        problem.d += share_of_direction(direction, problem) * direction;
    }
    return false;
}

}  // namespace

template <class K>
bool iterate_plain(const Model& model, const Stage& stage, const ContactSetIn<K::dimension>& contacts,
                   StepProblem<K>& problem, StepReport& report)
{
    report.trouble = Trouble::chatter;
    if (!problem.contacts.patches.empty() && !guess(stage.control, problem, report)) return false;
    while (descend(stage.control, problem, report)) {
        const std::optional<double> lost = break_weakest_joint(model, contacts, problem.contacts);
        problem.fracture += lost.value_or(0);
        if (lost) continue;
        report.trouble = Trouble::none;
        return true;
    }
    return false;
}

#define VOUSSOIR_INSTANTIATE(K)                                                                                 \
    template bool iterate_plain(const Model&, const Stage&, const ContactSetIn<K::dimension>&, StepProblem<K>&, \
                                StepReport&)
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
