// Verdicts at rest are confirmed: by limit analysis, which knows that nothing balances the stones, or by a second
// way.
#include <gtest/gtest.h>

#include <algorithm>

#include "libdda/limit/standing.h"
#include "tests/libdda/run_in_pieces.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

/// A block of half a metre glued to the side of a held one. Its weight bends the joint; the edge tears when the
/// bending stress 6 M / (b^2 t) exceeds the strength, while limit analysis lets the whole upper edge pull, M = f
/// b^2 t / 2.
/// @param strength of the joint, times that bending stress
Model bracket(Kinematics kinematics, double strength)
{
    constexpr double side = 0.5, density = 2000;
    const double moment = density * gravity * side * side * side * side / 2;
    JointMaterial joint = dry(40);
    joint.tensile_strength = strength * 6 * moment / (side * side * side);
    joint.cohesion = 10 * joint.tensile_strength;
    Model model = make_model(kinematics, {"stone", density, 1e10, 0.2}, joint);
    model.thickness = side;
    hold(model, add_box(model, "wall", {-1, 0, -1}, {0, side, 1.5}));
    add_box(model, "bracket", {0, 0, 0}, {side, side, side});
    return model;
}

/// A brick between two held ones that do not press on it.
Model loose_brick(Kinematics kinematics)
{
    Model model = make_model(kinematics, {"stone", 2000, 1e10, 0.2}, dry(40));
    hold(model, add_box(model, "left", {-1, 0, 0}, {0, 0.2, 0.4}));
    hold(model, add_box(model, "right", {0.4, 0, 0}, {1.4, 0.2, 0.4}));
    add_box(model, "brick", {0, 0, 0.1}, {0.4, 0.2, 0.3});
    return model;
}

bool warns(const RunReport& report, DiagnosisKind kind)
{
    return std::any_of(report.warnings.begin(), report.warnings.end(),
                       [&](const Diagnosis& warning) { return warning.kind == kind; });
}

class ConfirmedVerdicts : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Rigid, ConfirmedVerdicts,
                         ::testing::Values(Kinematics::planar_rigid, Kinematics::spatial_rigid), test_name);

}  // namespace

// Limit analysis would have it stand, with all its strength at once: a brittle joint tears edge by edge.
TEST_P(ConfirmedVerdicts, ABrittleJointFallsWhateverLimitAnalysisSays)
{
    const Model model = bracket(GetParam(), 0.7);
    State start = initial_state(model);
    const Vector3d g(0, 0, -gravity);
    EXPECT_EQ(limit::balance_in(model, start, g, 0.01).standing, limit::Standing::balanced);
    const RunReport report = run_quietly(model, {static_stage(1)}, start);
    EXPECT_EQ(report.outcome, Outcome::collapsed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_FALSE(warns(report, DiagnosisKind::friction_open)) << "it is not friction that decides";
    State strong = initial_state(bracket(GetParam(), 1.5));
    EXPECT_EQ(run_quietly(bracket(GetParam(), 1.5), {static_stage(1)}, strong).outcome, Outcome::completed);
}

// Stopped after every step and begun again from what was saved, the second way is the same. It is begun by hand: a
// scene that needs it takes minutes.
TEST_P(ConfirmedVerdicts, TheSecondWayGoesOnFromWhereItStopped)
{
    const Model model = loose_brick(GetParam());
    const std::vector<Stage> stages{static_stage(1)};
    State state = initial_state(model), saved_state = state;
    RunPosition saved;
    saved.report.energy = open_ledger(model, state);
    RunObserver observer;
    observer.stop = [] { return true; };
    observer.save = [&](const State& now, const RunPosition& position) {
        saved_state = now;
        saved = position;
    };
    run(model, stages, state, observer, saved);
    ASSERT_TRUE(saved.course.start);
    saved.course.first_way = WayEnd::fell;
    State whole = saved_state;
    const RunReport reference = run(model, stages, whole, {}, saved);
    ASSERT_EQ(reference.outcome, Outcome::collapsed);
    const RunInPieces ended = run_in_pieces(model, stages, saved_state, saved);
    EXPECT_GT(ended.pieces, 3);
    EXPECT_EQ(hash_of(ended.state), hash_of(whole));
    EXPECT_EQ(ended.report.steps, reference.steps);
    EXPECT_EQ(*ended.report.diagnosis, *reference.diagnosis);
}

// Friction could hold it if it were wedged in, and nothing wedges it: it falls, and that friction decides is said.
TEST_P(ConfirmedVerdicts, ALooseBrickFallsAndFrictionIsSaidToDecide)
{
    const Model model = loose_brick(GetParam());
    State state = initial_state(model);
    EXPECT_EQ(limit::balance_in(model, state, {0, 0, -gravity}, 0.01).standing, limit::Standing::balanced);
    const RunReport report = run_quietly(model, {static_stage(1)}, state);
    EXPECT_EQ(report.outcome, Outcome::collapsed);
    EXPECT_TRUE(warns(report, DiagnosisKind::friction_open));
}

// What nothing balances is seen as it begins to fall: within a few times the iterations of what stands.
TEST_P(ConfirmedVerdicts, AFallCostsAFewTimesARest)
{
    const auto iterations = [&](double lean, Outcome outcome) {
        const Model model = running_bond(GetParam(), 6, 4);
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {static_stage(1, {lean * gravity, 0, -gravity})}, state);
        EXPECT_EQ(report.outcome, outcome) << lean;
        return report.open_close_iterations;
    };
    EXPECT_LT(iterations(0.7, Outcome::collapsed), GetParam() == Kinematics::planar_rigid ? 400 : 3000);
    EXPECT_LT(iterations(0.1, Outcome::completed), 40);
}

// What comes to rest straight is believed: nothing more is computed for it.
TEST_P(ConfirmedVerdicts, ARestThatIsReachedStraightCostsNothingMore)
{
    const Model model = running_bond(GetParam(), 6, 4);
    State state = initial_state(model);
    std::int64_t steps = 0;
    RunObserver observer;
    observer.step = [&](const State&, const StepReport& step, const RunReport&) {
        ++steps;
        EXPECT_LE(step.open_close_iterations, 40);
    };
    const RunReport report = run(model, {static_stage(1)}, state, observer);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_EQ(report.steps, steps) << "on one way";
    EXPECT_TRUE(report.warnings.empty());
}

}  // namespace voussoir::testing
