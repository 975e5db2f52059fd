#include "libdda/iterate/directions.h"

#include <algorithm>

#include "libdda/problem/part_timer.h"

namespace voussoir::step
{

using Eigen::VectorXd;

namespace
{

/// What blocks feel of others that feel nothing of them: the free fields of a boundary. y += C x.
template <class K>
void add_one_sided(const StepProblem<K>& problem, const VectorXd& x, VectorXd& y)
{
    constexpr int n = K::unknowns;
    for (const Coupling<K>& coupling : problem.others.applied.couplings) {
        const int row = problem.blocks[coupling.block].row, column = problem.blocks[coupling.other].row;
        if (coupling.mutual || row < 0 || column < 0) continue;
        const typename K::Unknowns force = coupling.matrix * x.segment<n>(n * column);
        for (int k = 0; k < n; ++k)
            if (!problem.blocks[coupling.block].held[k]) y[n * row + k] -= force[k];
    }
}

template <class K>
void assemble(bool published, StepProblem<K>& problem, StepReport& report)
{
    const PartTimer timer(report.seconds, Part::assembly);
    assemble_matrix(published, problem);
}

}  // namespace

template <class K>
void Directions<K>::place_rows(const StepProblem<K>& problem)
{
    constexpr int D = K::dimension;
    places_.kinematics = K::kinematics;
    places_.centres.resize(D * problem.block_of_row.size());
    places_.free.resize(problem.block_of_row.size());
    for (std::size_t row = 0; row < problem.block_of_row.size(); ++row) {
        const BlockStep<K>& block = problem.blocks[problem.block_of_row[row]];
        typename K::Vector::MapType(places_.centres.data() + D * row) = block.start.centroid;
        places_.free[row] = std::none_of(block.held.begin(), block.held.end(), [](bool held) { return held; });
    }
    solver_->place(places_);
}

template <class K>
void Directions<K>::begin(const StepControl& control, const StepProblem<K>& problem)
{
    if (!solver_ || kind_ != control.linear_solver) {
        solver_ = solve::make_linear_solver(control.linear_solver, control.linear_tolerance);
        kind_ = control.linear_solver;
    }
    solver_->set_tolerance(control.linear_tolerance);
    solver_->use_threads(control.threads);
    place_rows(problem);
}

template <class K>
bool Directions<K>::find(bool published, StepProblem<K>& problem, StepReport& report)
{
    assemble(published, problem, report);
    const PartTimer timer(report.seconds, Part::linear_solve);
    const solve::LinearReport linear = solver_->solve(problem.matrix, problem.residual, direction);
    direction = -direction;
    report.factorisations += linear.factorisations;
    report.linear_iterations += linear.iterations;
    report.factor_entries = linear.factor_entries;
    return linear.solved && direction.allFinite();
}

template <class K>
bool Directions<K>::find_whole(double tolerance, const IterationRules& rules, StepProblem<K>& problem,
                               StepReport& report)
{
    if (!coupling_.gather(problem)) return false;
    assemble(false, problem, report);
    const PartTimer timer(report.seconds, Part::linear_solve);
    if (!solver_->prepare(problem.matrix)) return false;
    ++report.factorisations;
    const auto multiply = [&](const VectorXd& x, VectorXd& y) {
        solver_->multiply(problem.matrix, x, y);
        coupling_.add_product(problem, x, y);
        add_one_sided(problem, x, y);
    };
    const auto precondition = [&](const VectorXd& r, VectorXd& z) { solver_->precondition(r, z); };
    const solve::LinearReport linear =
        gmres_.solve(multiply, precondition, problem.residual, tolerance, rules.most_vectors,
                     solve::Pieces(problem.matrix.rows(), K::unknowns, problem.threads), direction);
    direction = -direction;
    report.linear_iterations += linear.iterations;
    return linear.iterations > 0 && direction.allFinite();
}

#define VOUSSOIR_INSTANTIATE(K) template class Directions<K>
VOUSSOIR_FOR_ALL_KINEMATICS(VOUSSOIR_INSTANTIATE);
#undef VOUSSOIR_INSTANTIATE

}  // namespace voussoir::step
