// Blocks that move when motion begins: at once, or after the static stages.
#include <gtest/gtest.h>

#include "libdda/analysis/energies.h"
#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

class InitialMotionOf : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, InitialMotionOf, every_kinematics(), test_name);

/// A box that flies, above a held floor on which another rests.
Model flying(Kinematics kinematics)
{
    Model model = make_model(kinematics, stone(), dry(30));
    hold(model, add_box(model, "floor", {-5, -5, -1}, {5, 5, 0}));
    add_box(model, "resting", {1, -0.5, 0}, {2, 0.5, 1});
    add_box(model, "flying", {-2, -0.2, 3}, {-1.6, 0.2, 3.3});
    model.initial_motions = {{2, {3, 0, 2}, {0, -4, 0}}};
    return model;
}

}  // namespace

// Thrown: a parabola and a constant spin.
TEST_P(InitialMotionOf, FliesAsThrown)
{
    const Model model = flying(GetParam());
    State state = initial_state(model);
    const Eigen::Vector3d from = pose_of(model.kinematics, state, 2).centroid;
    Stage stage = dynamic_stage(0.25, 1e-3);
    const RunReport report = run_quietly(model, {stage}, state);
    ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    const Eigen::Vector3d exact = from + 0.25 * Eigen::Vector3d(3, 0, 2 - gravity * 0.25 / 2);
    EXPECT_LT((pose_of(model.kinematics, state, 2).centroid - exact).norm(), 1e-2 * 0.25 * gravity * 0.25);
    EXPECT_NEAR(angular_velocity_of(model, state, 2).y(), -4, 1e-6);
    const Eigen::Matrix3d map = pose_of(model.kinematics, state, 2).map;
    EXPECT_NEAR(std::atan2(map(2, 0), map(0, 0)), 4 * 0.25, 2e-3) << "from x to z";
    EXPECT_NEAR(report.energy.start_kinetic, kinetic_energy(model, initial_state(model)), 1e-9);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// What the static stages leave is then set in motion, with the energy of the motion on the books.
TEST_P(InitialMotionOf, WaitsForTheFirstDynamicStage)
{
    Model model = flying(GetParam());
    model.blocks.pop_back();
    model.initial_motions = {{1, {0.5, 0, 0}, {0, 0, 0}}};
    State state = initial_state(model);
    std::vector<double> speeds;
    double booked = -1;
    RunObserver observer;
    observer.every = 0.01;
    observer.frame = [&](const State& now, const RunReport&) {
        speeds.push_back(velocity_of(model.kinematics, now, 1).x());
    };
    observer.step = [&](const State& now, const StepReport&, const RunReport& so_far) {
        if (now.stage == 1 && booked < 0) booked = so_far.energy.start_kinetic;
    };
    const std::vector<Stage> stages = {static_stage(0.1), dynamic_stage(0.02, 1e-3), dynamic_stage(0.5, 1e-3)};
    const RunReport report = run(model, stages, state, observer);
    ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    ASSERT_GE(speeds.size(), 4);
    EXPECT_EQ(speeds[0], 0);
    EXPECT_NEAR(speeds[1], 0, 1e-6) << "at rest after the static stage";
    const double braked = gravity * std::tan(30 * degrees) * 0.01;
    EXPECT_NEAR(speeds[2], 0.5 - braked, 0.1 * braked);
    EXPECT_NEAR(booked, 0.5 * model.mass(1) * 0.25, 1e-3 * booked);
    EXPECT_NEAR(velocity_of(model.kinematics, state, 1).x(), 0, 1e-3)
        << "given once: not again by the third stage";
    EXPECT_LT(report.energy.relative_residual(), 1e-3);
}

// A run that is stopped at any place and goes on gives the same bits, and no block is pushed twice.
TEST_P(InitialMotionOf, IsGivenOnceToARunThatGoesOn)
{
    Model model = flying(GetParam());
    model.blocks.pop_back();
    model.initial_motions = {{1, {0.5, 0, 0}, {0, 0, 0}}};
    const std::vector<Stage> stages = {static_stage(0.1), dynamic_stage(0.03, 1e-3)};
    State whole = initial_state(model);
    std::vector<std::pair<State, RunPosition>> places;
    RunObserver observer;
    observer.every = 0.01;
    observer.save = [&](const State& now, const RunPosition& at) { places.emplace_back(now, at); };
    const RunReport report = run(model, stages, whole, observer);
    ASSERT_EQ(report.outcome, Outcome::completed);
    ASSERT_GE(places.size(), 5);
    for (auto& [state, position] : places) {
        const RunReport again = run(model, stages, state, {}, position);
        EXPECT_EQ(hash_of(state), hash_of(whole)) << position.frames;
        EXPECT_EQ(again.energy.start_kinetic, report.energy.start_kinetic);
    }
}

}  // namespace voussoir::testing
