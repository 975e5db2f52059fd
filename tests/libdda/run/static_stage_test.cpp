// Static stages: what stands comes to rest, whatever its contacts alternate between; what cannot stand is said to
// collapse, and only that. Closed forms: a block overturns at tan(tilt) = b / h and slides at tan(tilt) =
// tan(phi).
#include "libdda/run/static_stage.h"

#include <gtest/gtest.h>

#include <random>

#include "libdda/analysis/block_shifts.h"
#include "tests/libdda/run_in_pieces.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

class StaticStage : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, StaticStage, every_kinematics(), test_name);

class RigidStaticStage : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, RigidStaticStage,
                         ::testing::Values(Kinematics::planar_rigid, Kinematics::spatial_rigid), test_name);

JointMaterial stiff(double friction_degrees)
{
    JointMaterial joint = dry(friction_degrees);
    joint.stiffness.factor = 30;
    return joint;
}

/// A block of half width b and half height h on a floor. @param courses it is cut into, one upon another
Model block_on_floor(Kinematics kinematics, double b, double h, double friction_degrees, int courses = 1,
                     double young = 3e9)
{
    Model model = make_model(kinematics, {"stone", 2000, young, 0.2}, stiff(friction_degrees));
    hold(model, add_box(model, "floor", {-20, -1, -1}, {20, 1, 0}));
    const double course = 2 * h / courses;
    for (int i = 0; i < courses; ++i)
        add_box(model, "block " + std::to_string(i), {-b, -0.2, i * course}, {b, 0.2, (i + 1) * course});
    return model;
}

/// Gravity that leans towards +x by an angle of this tangent.
Vector3d leaning(double tangent)
{
    return gravity * Vector3d(tangent, 0, -1).normalized();
}

RunReport rest(const Model& model, const Vector3d& g, State& state)
{
    state = initial_state(model);
    return run_quietly(model, {static_stage(1, g), dynamic_stage(0.01, 1e-3, g)}, state);
}

/// What a verdict "collapsed" has to say: the moving blocks, each with a way that it has gone and a direction.
void expect_mechanism(const Model& model, const RunReport& report)
{
    ASSERT_EQ(report.outcome, Outcome::collapsed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_EQ(report.simulated_time, 0) << "no stage follows";
    ASSERT_TRUE(report.diagnosis);
    ASSERT_EQ(report.diagnosis->kind, DiagnosisKind::mechanism) << *report.diagnosis;
    ASSERT_TRUE(is_whole(*report.diagnosis));
    double farthest = 0;
    for (std::size_t i = 0; i < report.diagnosis->blocks.size(); ++i) {
        const double* values = report.diagnosis->values.data() + 4 * i;
        farthest = std::max(farthest, values[0] / size_of(model, report.diagnosis->blocks[i]));
        EXPECT_NEAR(Vector3d(values + 1).norm(), 1, 1e-9);
    }
    EXPECT_GT(farthest, 1e-4) << "no verdict without motion";
}

/// A wall of 45 stones with a window, on a slab. @param stiffness of its joints, in E/L
Model wall_with_window(Kinematics kinematics, double stiffness)
{
    JointMaterial joint = dry(35);
    joint.stiffness.value = stiffness;
    Model model = make_model(kinematics, {"stone", 2000, 3e9, 0.2}, joint);
    hold(model, add_box(model, "slab", {-0.2, 0, -0.3}, {3.2, 0.3, 0}));
    const auto add = [&](int course, double from, double to) {
        if (to - from > 1e-9) add_box(model, "stone", {from, 0, 0.25 * course}, {to, 0.3, 0.25 * (course + 1)});
    };
    for (int course = 0; course < 8; ++course) {
        const bool beside = course >= 2 && course < 6, lintel = course == 6;
        const double left = lintel ? 0.75 : 1, right = lintel ? 2.25 : 2;
        const double shift = course % 2 == 1 ? -0.25 : 0;
        for (int i = 0; i < 7; ++i) {
            const double from = std::max(0.0, shift + 0.5 * i), to = std::min(3.0, shift + 0.5 * (i + 1));
            if (!beside && !lintel) {
                add(course, from, to);
                continue;
            }
            add(course, from, std::min(to, left));
            add(course, std::max(from, right), to);
        }
        if (lintel) add(course, left, right);
    }
    return model;
}

}  // namespace

TEST_P(StaticStage, BlockOverturnsWhereItsWeightLeavesItsBase)
{
    const Model model = block_on_floor(GetParam(), 0.1, 0.3, 60);
    State state;
    const RunReport stands = rest(model, leaning(0.995 / 3), state);
    EXPECT_EQ(stands.outcome, Outcome::completed) << ::testing::PrintToString(stands.diagnosis);
    const RunReport falls = rest(model, leaning(1.005 / 3), state);
    expect_mechanism(model, falls);
    EXPECT_EQ(falls.diagnosis->blocks, std::vector{1});
    EXPECT_GT(falls.diagnosis->values[1], 0.5) << "towards +x";
    EXPECT_LT(falls.steps, 60);
}

TEST_P(StaticStage, BlockSlidesAboveItsFrictionAngle)
{
    const Model model = block_on_floor(GetParam(), 0.5, 0.2, 25);
    const double tangent = std::tan(25 * degrees);
    State state;
    const RunReport stands = rest(model, leaning(0.999 * tangent), state);
    EXPECT_EQ(stands.outcome, Outcome::completed) << ::testing::PrintToString(stands.diagnosis);
    const RunReport falls = rest(model, leaning(1.001 * tangent), state);
    expect_mechanism(model, falls);
    EXPECT_NEAR(falls.diagnosis->values[1], 1, 1e-3) << "along the floor";
    ASSERT_EQ(falls.joints.size(), 1);
    EXPECT_TRUE(falls.joints[0].slid.has_value());
    EXPECT_FALSE(falls.joints[0].opened.has_value());
}

// Far beyond its base a block lands on its side within a step or two, if nobody looks.
TEST_P(StaticStage, BlockThatLandsOnItsSideHasCollapsed)
{
    const Model model = block_on_floor(GetParam(), 0.1, 0.3, 60);
    State state;
    expect_mechanism(model, rest(model, leaning(1), state));
}

// Columns of one to four stones, each at random beside its own limit of sliding and overturning.
TEST_P(StaticStage, IsRightOnBothSidesOfRandomLimits)
{
    std::mt19937 random(18);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    int slid = 0, overturned = 0;
    for (int i = 0; i < 24; ++i) {
        const double b = between(0.1, 0.6), h = between(0.2, 0.6), friction = between(15, 45);
        const int courses = 1 + i % 4;
        const Model model = block_on_floor(GetParam(), b, h, friction, courses);
        const double limit = std::min(b / h, std::tan(friction * degrees));
        (limit < b / h ? slid : overturned) += 1;
        State state;
        const RunReport stands = rest(model, leaning(0.995 * limit), state);
        EXPECT_EQ(stands.outcome, Outcome::completed) << i << " " << ::testing::PrintToString(stands.diagnosis);
        const RunReport falls = rest(model, leaning(1.005 * limit), state);
        expect_mechanism(model, falls);
        EXPECT_LT(falls.steps, 200) << i;
    }
    EXPECT_GE(slid, 5);
    EXPECT_GE(overturned, 5);
}

// With contacts a thousand times as stiff as the stones, friction points take turns for ever: once neither force
// nor motion is left, that is rest.
TEST_P(StaticStage, ComesToRestWhereContactStatesAlternate)
{
    for (const double stiffness : {1e3, 1e4}) {
        if (stiffness > 1e3 && GetParam() == Kinematics::spatial_deformable) continue;  // a minute
        const Model model = wall_with_window(GetParam(), stiffness);
        ASSERT_EQ(model.blocks.size(), 46);
        State state = initial_state(model);
        Stage stage = static_stage(1, leaning(0.34));
        const RunReport report = run_quietly(model, {stage}, state);
        EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        EXPECT_LE(report.static_unbalanced, stage.unbalanced_tolerance);
        EXPECT_LT(report.steps, 400) << stiffness;
        EXPECT_LT(largest_share(model, shifts_between(model, initial_state(model).coordinates, state.coordinates)),
                  1e-3);
    }
}

// Rigid: they show it in a tenth of the time.
TEST_P(RigidStaticStage, NamesTheStonesOfAWallThatFall)
{
    const Model model = wall_with_window(GetParam(), 1e3);
    State state;
    const RunReport stands = rest(model, leaning(0.34), state), falls = rest(model, leaning(0.6), state);
    EXPECT_EQ(stands.outcome, Outcome::completed) << ::testing::PrintToString(stands.diagnosis);
    expect_mechanism(model, falls);
    EXPECT_LT(falls.diagnosis->blocks.size(), 40) << "the others stand";
    EXPECT_GT(falls.diagnosis->values[1], 0.5) << "towards +x";
    EXPECT_LT(falls.steps, 20 * stands.steps);
}

// What a stage remembers of its steps is in its position: a run that is stopped after every step and goes on from
// there ends as one that was never stopped, bit for bit.
TEST_P(StaticStage, GoesOnAsIfItHadNotBeenStopped)
{
    const Model model = block_on_floor(GetParam(), 0.1, 0.3, 60, 2);
    const std::vector<Stage> stages{static_stage(1, leaning(1.02 / 3))};
    State whole = initial_state(model);
    const RunReport reference = run_quietly(model, stages, whole);
    expect_mechanism(model, reference);

    RunPosition start;
    State state = initial_state(model);
    start.report.energy = open_ledger(model, state);
    const RunInPieces ended = run_in_pieces(model, stages, state, start);
    EXPECT_GT(ended.pieces, 3);
    EXPECT_EQ(hash_of(ended.state), hash_of(whole));
    EXPECT_EQ(ended.report.steps, reference.steps);
    EXPECT_EQ(*ended.report.diagnosis, *reference.diagnosis);
}

// Under a stone that bulges the shear at the corners is just the friction bound, or a hair below by rounding. What
// moves next does not depend on it: at rest nothing slides.
TEST_P(StaticStage, WhetherPointsRestAtTheirBoundOrJustBelowDecidesNothing)
{
    const Model model = block_on_floor(GetParam(), 0.2, 0.3, 30);
    const std::vector<Stage> stages = {static_stage(1, leaning(0)), dynamic_stage(0.01, 1e-3, leaning(0.1))};
    State rested = initial_state(model);
    RunPosition position;
    RunObserver observer;
    observer.save = [&](const State& state, const RunPosition& at) {
        if (!at.stage_done) return;
        rested = state;
        position = at;
    };
    State state = rested;
    run(model, {stages[0]}, state, observer);
    ASSERT_TRUE(position.stage_done);

    const auto go_on = [&](ContactStatus status) {
        State ended = rested;
        for (auto& point : ended.contacts.points) point.status = status;
        for (auto& point : ended.planar_contacts.points) point.status = status;
        EXPECT_EQ(run(model, stages, ended, {}, position).outcome, Outcome::completed);
        return ended;
    };
    const State from_below = go_on(ContactStatus::locked), from_bound = go_on(ContactStatus::sliding);
    EXPECT_GT(from_below.time, 0);
    EXPECT_EQ(from_below.coordinates, from_bound.coordinates);
    EXPECT_EQ(from_below.velocities, from_bound.velocities);
}

// The last digit of where stones are is worth a millionth of their weight in joints so stiff.
TEST_P(StaticStage, StonesRestWhoseWeightDrownsInRounding)
{
    const Model model = block_on_floor(GetParam(), 0.5, 1, 35, 5, 1e16);
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(1, leaning(0.45))}, state);
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_LT(report.steps, 40);
    State falling = initial_state(model);
    EXPECT_EQ(run_quietly(model, {static_stage(1, leaning(0.55))}, falling).outcome, Outcome::collapsed);
}

}  // namespace voussoir::testing
