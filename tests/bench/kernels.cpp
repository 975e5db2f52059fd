// What the parts of a step cost on a running-bond wall of 504 stones in motion.
#include <benchmark/benchmark.h>

#include <memory>
#include <variant>

#include "libdda/contact/find_contacts.h"
#include "libdda/model/standard_gravity.h"
#include "libdda/run/run.h"
#include "libdda/solve/linear_solver.h"
#include "libdda/step/advance.h"
#include "libdda/step/reach.h"
#include "libdda/step/work.h"
#include "tests/running_bond_wall.h"

namespace voussoir
{
namespace
{

constexpr double time_step = 8e-3;  // s
constexpr int warm_up = 12;         // steps of the motion, to where the push is strongest

template <class K>
struct Wall {
    Model model = running_bond_wall(K::kinematics, 16, 31);
    Stage stage;
    State before;  // of the step that `work` has solved
    Workspace workspace{model};
    Work<K>& work() { return std::get<Work<K>>(workspace.implementation->work); }
    Wall();
};

template <class K>
Wall<K>::Wall()
{
    Stage rest;
    rest.name = "rest";
    rest.type = StageType::static_equilibrium;
    rest.control.time_step = 0.1;
    State state = initial_state(model);
    run(model, {rest}, state, {});
    stage.name = "motion";
    stage.duration = 2;
    stage.control.time_step = time_step;
    const auto push = std::make_shared<const GroundMotion>(
        GroundMotion::sine_acceleration(0.3 * standard_gravity, 2, 0, stage.duration));
    for (int block = 1; block < static_cast<int>(model.blocks.size()); ++block)
        stage.body_accelerations.push_back({block, 0, push});
    state.stage = 0;
    begin_stage(model, 0, state);
    EnergyLedger energy;
    for (int step = 0; step < warm_up; ++step) {
        before = state;
        advance(model, stage, time_step, state, energy, workspace);
    }
}

/// Made once for each kinematics.
template <class K>
Wall<K>& wall()
{
    static Wall<K> made;
    return made;
}

template <class K>
void search_contacts(benchmark::State& bench)
{
    Wall<K>& scene = wall<K>();
    Work<K>& work = scene.work();
    ContactSetIn<K::dimension> found;
    for (auto _ : bench) {
        step::find_reach<K>(scene.model, scene.stage, scene.before, time_step, work.extents, work.reach);
        contact::find_contacts(scene.model, scene.before, work.reach, 1, work.search, found);
        benchmark::DoNotOptimize(found.points.data());
    }
    bench.counters["points"] = static_cast<double>(found.points.size());
}

template <class K>
void set_up_step(benchmark::State& bench)
{
    Wall<K>& scene = wall<K>();
    Work<K>& work = scene.work();
    const Eigen::VectorXd d = work.problem.d;
    for (auto _ : bench)
        step::assemble_blocks(scene.model, scene.stage, scene.before, work.contacts, time_step, work.jumps,
                              work.problem);
    // What follows starts from a solved step.
    work.problem.d = d;
    step::evaluate_contacts(d, 1, work.problem.contacts);
    step::evaluate_residual(d, work.problem);
}

template <class K>
void evaluate(benchmark::State& bench)
{
    step::StepProblem<K>& system = wall<K>().work().problem;
    for (auto _ : bench) {
        step::evaluate_contacts(system.d, 1, system.contacts);
        benchmark::DoNotOptimize(step::evaluate_residual(system.d, system));
    }
}

template <class K>
void assemble(benchmark::State& bench)
{
    step::StepProblem<K>& system = wall<K>().work().problem;
    for (auto _ : bench) {
        step::assemble_matrix(false, system);
        benchmark::DoNotOptimize(system.matrix.values.data());
    }
    bench.counters["rows"] = static_cast<double>(system.matrix.rows() * system.matrix.block_size);
}

/// K x = the weight of the stones.
template <class K, LinearSolverKind kind>
void solve_linear(benchmark::State& bench)
{
    step::StepProblem<K>& system = wall<K>().work().problem;
    step::assemble_matrix(false, system);
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(system.d.size()), solution = weight;
    for (int row = 0; row < system.matrix.rows(); ++row)
        weight[row * system.matrix.block_size + 2] = -system.load[row];
    const auto solver = solve::make_linear_solver(kind, StepControl{}.linear_tolerance);
    solve::LinearReport report;
    for (auto _ : bench) report = solver->solve(system.matrix, weight, solution);
    if (!report.solved) bench.SkipWithError("not solved");
    bench.counters["iterations"] = report.iterations;
}

template <class K>
void whole_step(benchmark::State& bench)
{
    Wall<K>& scene = wall<K>();
    Workspace workspace(scene.model);
    StepReport report;
    for (auto _ : bench) {
        State state = scene.before;
        EnergyLedger energy;
        report = advance(scene.model, scene.stage, time_step, state, energy, workspace);
    }
    bench.counters["iterations"] = report.open_close_iterations;
}

using step::SpatialDeformable;
using step::SpatialRigid;

constexpr auto iterative = LinearSolverKind::conjugate_gradients, direct = LinearSolverKind::cholmod;

BENCHMARK_TEMPLATE(search_contacts, SpatialRigid);
BENCHMARK_TEMPLATE(set_up_step, SpatialRigid);
BENCHMARK_TEMPLATE(evaluate, SpatialRigid);
BENCHMARK_TEMPLATE(assemble, SpatialRigid);
BENCHMARK_TEMPLATE(solve_linear, SpatialRigid, iterative);
BENCHMARK_TEMPLATE(solve_linear, SpatialRigid, direct);
BENCHMARK_TEMPLATE(whole_step, SpatialRigid);
BENCHMARK_TEMPLATE(set_up_step, SpatialDeformable);
BENCHMARK_TEMPLATE(evaluate, SpatialDeformable);
BENCHMARK_TEMPLATE(assemble, SpatialDeformable);
BENCHMARK_TEMPLATE(solve_linear, SpatialDeformable, iterative);
BENCHMARK_TEMPLATE(whole_step, SpatialDeformable);

}  // namespace
}  // namespace voussoir
