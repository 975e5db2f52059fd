// The same bits: from two runs, on one and two threads, and from a run that was interrupted.
#include <gtest/gtest.h>

#include "libdda/step/advance.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

class Determinism : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Determinism, every_kinematics(), test_name);

std::uint64_t hash_after_shaking(const Model& model, Stage stage, int threads, std::size_t& patches)
{
    stage.control.threads = threads;
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {stage}, state);
    EXPECT_EQ(report.outcome, Outcome::completed) << report.message;
    EXPECT_GT(report.energy.friction, 0);
    patches = state.contacts.patches.size() + state.planar_contacts.patches.size();
    return hash_of(state);
}

/// Steps on, with a Workspace of its own.
void step_on(const Model& model, const Stage& stage, int steps, State& state)
{
    Workspace work(model);
    EnergyLedger energy = open_ledger(model, state);
    for (int i = 0; i < steps; ++i)
        ASSERT_EQ(advance(model, stage, stage.control.time_step, state, energy, work).outcome,
                  StepOutcome::converged);
}

}  // namespace

// A wall whose contacts pass every threshold above which the engine uses threads.
TEST_P(Determinism, threads_and_repetition_change_no_bit)
{
    const Model model = running_bond(GetParam(), 12, 12);
    std::size_t patches = 0;
    const Stage stage = shaking(0.012, 2e-3);
    const std::uint64_t first = hash_after_shaking(model, stage, 1, patches);
    EXPECT_GT(patches, 256U);
    EXPECT_EQ(hash_after_shaking(model, stage, 2, patches), first);
    EXPECT_EQ(hash_after_shaking(model, stage, 1, patches), first);
}

// Nothing in the Workspace may change a result: the second half starts with a fresh one.
TEST_P(Determinism, a_restart_changes_no_bit)
{
    for (const LinearSolverKind solver :
         {LinearSolverKind::automatic, LinearSolverKind::cholmod, LinearSolverKind::conjugate_gradients}) {
        const FewBlocks scene(GetParam(), {});
        Stage stage = shaking(1, 1e-3);
        stage.control.linear_solver = solver;
        State whole = scene.state, halves = scene.state;
        step_on(scene.model, stage, 60, whole);
        step_on(scene.model, stage, 30, halves);
        EXPECT_NE(hash_of(halves), hash_of(whole));
        const State copy = halves;
        State later = copy;
        step_on(scene.model, stage, 30, later);
        EXPECT_EQ(hash_of(later), hash_of(whole));
    }
}

// The run, with its grid of times and cut steps, goes on from any state as if it had never stopped.
TEST_P(Determinism, an_interrupted_run_goes_on_as_if_nothing_had_been)
{
    const FewBlocks scene(GetParam(), {});
    Stage stage = shaking(0.12, 2e-3);
    stage.control.max_open_close = 5;  // so that impacts cut steps
    State whole = scene.state, part = scene.state;
    const RunReport report = run_quietly(scene.model, {stage}, whole);
    ASSERT_EQ(report.outcome, Outcome::completed) << report.message;
    EXPECT_GT(report.step_cuts, 0);
    for (const int stop : {7, 25, 40}) {
        RunObserver observer;
        int count = 0;
        observer.step = [&](const State&, const StepReport&, const RunReport&) { ++count; };
        observer.stop = [&] { return count == stop; };
        EXPECT_EQ(run(scene.model, {stage}, part, observer).outcome, Outcome::interrupted);
    }
    EXPECT_EQ(run_quietly(scene.model, {stage}, part).outcome, Outcome::completed);
    EXPECT_EQ(hash_of(part), hash_of(whole));
}

TEST(Hash, sees_the_last_bit_of_everything_that_changes)
{
    FewBlocks scene(Kinematics::spatial_deformable, {});
    step_on(scene.model, shaking(1, 1e-3), 5, scene.state);
    const std::uint64_t before = hash_of(scene.state);
    const auto changes = [&](double& number) {
        const double kept = number;
        number = std::nextafter(number, 1e9);
        const bool seen = hash_of(scene.state) != before;
        number = kept;
        return seen;
    };
    EXPECT_TRUE(changes(scene.state.time));
    EXPECT_TRUE(changes(scene.state.next_time_step));
    EXPECT_TRUE(changes(scene.state.coordinates[17]));
    EXPECT_TRUE(changes(scene.state.velocities[17]));
    EXPECT_TRUE(changes(scene.state.foundation_anchors[0]));
    EXPECT_TRUE(changes(scene.state.contacts.patches.back().stiffness));
    EXPECT_TRUE(changes(scene.state.contacts.points.back().elastic_slip[1]));
    EXPECT_TRUE(changes(scene.state.contacts.points.back().plastic_slip[2]));
    EXPECT_EQ(hash_of(scene.state), before);
}

}  // namespace voussoir::testing
