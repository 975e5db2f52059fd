// The same bits: from two runs, on one, two and four threads, and from a run that was interrupted.
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
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_GT(report.energy.friction, 0);
    patches = state.contacts.patches.size() + state.planar_contacts.patches.size();
    return hash_of(state);
}

bool touch(const Block& a, const Block& b)
{
    Eigen::AlignedBox3d of_a, of_b;
    for (const auto& [block, box] : {std::pair{&a, &of_a}, {&b, &of_b}}) {
        for (const ConvexPolyhedron& part : block->parts)
            for (const Eigen::Vector3d& x : part.vertices) box->extend(block->moments.centroid + x);
        for (const ConvexPolygon& outline : block->outlines)
            for (const Eigen::Vector2d& x : outline.vertices) box->extend(block->moments.centroid + to_space(x));
    }
    return of_a.exteriorDistance(of_b) < 0.1;
}

/// An order in which the first of two blocks that touch stays the first, otherwise as different as it can be: of
/// all blocks whose earlier neighbours are placed, the last one is next.
std::vector<int> another_order(const Model& model)
{
    const int count = static_cast<int>(model.blocks.size());
    std::vector<int> order, waits_for(model.blocks.size(), 0);
    std::vector<std::vector<int>> later(model.blocks.size());
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b)
            if (touch(model.blocks[a], model.blocks[b])) {
                later[a].push_back(b);
                ++waits_for[b];
            }
    while (static_cast<int>(order.size()) < count) {
        int next = count - 1;
        while (waits_for[next] != 0) --next;
        waits_for[next] = -1;
        for (const int b : later[next]) --waits_for[b];
        order.push_back(next);
    }
    return order;
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

// A wall of 281 blocks, which pass every threshold above which the engine uses threads and a coarse space.
TEST_P(Determinism, ThreadsAndRepetitionChangeNoBit)
{
    const Model model = running_bond(GetParam(), 16, 17);
    EXPECT_EQ(model.blocks.size(), 281U);
    std::size_t patches = 0;
    const Stage stage = shaking(0.012, 2e-3);
    const std::uint64_t first = hash_after_shaking(model, stage, 1, patches);
    EXPECT_GT(patches, 256U);
    EXPECT_EQ(hash_after_shaking(model, stage, 2, patches), first);
    EXPECT_EQ(hash_after_shaking(model, stage, 4, patches), first);
    EXPECT_EQ(hash_after_shaking(model, stage, 1, patches), first);
}

// A wall of more than a thousand stones, whose rows are factorised and relaxed domain by domain. On a machine of
// few cores the larger numbers come down to those.
TEST_P(Determinism, ThreadsChangeNoBitOfSceneInDomains)
{
    const Model model = running_bond(GetParam(), 33, 31);
    EXPECT_GT(model.blocks.size(), 1025U);
    std::size_t patches = 0;
    const Stage stage = shaking(0.008, 2e-3);
    const std::uint64_t first = hash_after_shaking(model, stage, 1, patches);
    for (const int threads : {2, 3, 8, 16}) EXPECT_EQ(hash_after_shaking(model, stage, threads, patches), first);
}

// The wall of 281 blocks interrupted on one thread and continued on four.
TEST_P(Determinism, ARestartOnOtherThreadsChangesNoBit)
{
    const Model model = running_bond(GetParam(), 16, 17);
    Stage stage = shaking(1, 2e-3);
    State whole = initial_state(model), part = whole;
    begin_stage(model, 0, whole);
    begin_stage(model, 0, part);
    step_on(model, stage, 6, whole);
    step_on(model, stage, 3, part);
    stage.control.threads = 4;
    step_on(model, stage, 3, part);
    EXPECT_EQ(hash_of(part), hash_of(whole));
}

// What is promised of the order of the blocks: equal up to rounding, as long as the first of two touching blocks
// stays the first. Sums over contacts run in another order, so the last bits may differ; with another first block
// the reference faces change too (see invariance_test.cpp).
TEST_P(Determinism, TheOrderOfTheBlocksChangesNoMoreThanRounding)
{
    const Model model = running_bond(GetParam(), 14, 14);
    const std::vector<int> order = another_order(model);
    Model shuffled = model;
    for (std::size_t i = 0; i < order.size(); ++i) shuffled.blocks[i] = model.blocks[order[i]];
    EXPECT_EQ(order[0], 0) << "the base, which the foundation names";
    EXPECT_FALSE(std::is_sorted(order.begin(), order.end()));
    Stage stage = shaking(1, 2e-3);
    stage.control.force_tolerance = 1e-11;
    stage.control.max_open_close = 400;  // so many decimals take long: no step is to be cut in one order alone
    State plain = initial_state(model), other = initial_state(shuffled);
    begin_stage(model, 0, plain);
    begin_stage(shuffled, 0, other);
    step_on(model, stage, 6, plain);
    step_on(shuffled, stage, 6, other);
    double largest = 0, moved = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Eigen::Vector3d expected = centroid(model, plain, order[i]);
        largest = std::max(largest, (centroid(shuffled, other, static_cast<int>(i)) - expected).norm());
        moved = std::max(moved, (expected - model.blocks[order[i]].moments.centroid).norm());
    }
    EXPECT_GT(moved, 1e-4);
    EXPECT_LT(largest, 1e-9 * moved) << "m";
}

// Nothing in the Workspace may change a result: the second half starts with a fresh one.
TEST_P(Determinism, ARestartChangesNoBit)
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
TEST_P(Determinism, AnInterruptedRunGoesOnAsIfNothingHadBeen)
{
    const FewBlocks scene(GetParam(), {});
    Stage stage = shaking(0.12, 2e-3);
    stage.control.max_open_close = 2;  // so that impacts cut steps
    State whole = scene.state, part = scene.state;
    const RunReport report = run_quietly(scene.model, {stage}, whole);
    ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
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

TEST(Hash, SeesTheLastBitOfEverythingThatChanges)
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
    scene.state.boundary_reactions = {1};
    EXPECT_NE(hash_of(scene.state), before);
    scene.state.boundary_reactions.clear();
    EXPECT_TRUE(changes(scene.state.contacts.patches.back().stiffness));
    EXPECT_TRUE(changes(scene.state.contacts.points.back().rest_gap));
    EXPECT_TRUE(changes(scene.state.contacts.points.back().elastic_slip[1]));
    EXPECT_TRUE(changes(scene.state.contacts.points.back().plastic_slip[2]));
    EXPECT_EQ(hash_of(scene.state), before);
}

}  // namespace voussoir::testing
