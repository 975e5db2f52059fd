// Blocks that follow the ground, wholly or in some components.
#include <gtest/gtest.h>

#include <memory>

#include "libdda/step/advance.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

std::shared_ptr<const GroundMotion> sine(double amplitude, double frequency)
{
    return std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(amplitude, frequency, 0, 100));
}

class Foundations : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Foundations, spatial_kinematics(), test_name);

}  // namespace

// The ground is the same whatever the step and the cuts: every held block stands at anchor + d(t) of the time
// reached.
TEST_P(Foundations, HeldBlocksStandWhereTheGroundIs)
{
    for (const double h : {1e-3, 7.3e-3}) {
        Model model = make_model(GetParam(), stone(), dry(30));
        hold(model, add_box(model, "west", {-1, -1, -1}, {1, 1, 0}));
        hold(model, add_box(model, "east", {3, -1, -1}, {5, 1, 0}));
        const int box = add_box(model, "box", {-0.4, -0.4, 0}, {0.4, 0.4, 0.5});
        const Vector3d anchors[2] = {model.blocks[0].moments.centroid, model.blocks[1].moments.centroid};
        Stage stage = dynamic_stage(0.5, h);
        const auto x = sine(3, 2.5), z = sine(1, 4), late = sine(2, 1.5);
        stage.motions = {{0, 0, x}, {0, 2, z}, {1, 1, late}};
        // A step that cannot be taken at once: the iteration may not exceed two passes, so that the impacts, which
        // are left to the springs, cut it.
        model.joints[0].restitution.reset();
        stage.control.max_open_close = 2;
        State state = initial_state(model);
        set_velocity(model, state, box, {0, 0, -0.5});
        RunObserver observer;
        int cuts = 0;
        observer.step = [&](const State& now, const StepReport& report, const RunReport&) {
            cuts += report.cuts;
            const double t = now.stage_time;
            const Vector3d west(x->displacement(t), 0, z->displacement(t)), east(0, late->displacement(t), 0);
            EXPECT_LT((centroid(model, now, 0) - anchors[0] - west).norm(), 1e-14) << t;
            EXPECT_LT((centroid(model, now, 1) - anchors[1] - east).norm(), 1e-14) << t;
            EXPECT_NEAR(velocity_of(model.kinematics, now, 0).x(), x->velocity(t), 1e-13);
            EXPECT_EQ(pose_of(model.kinematics, now, 0).map, Eigen::Matrix3d::Identity());
        };
        const RunReport report = run(model, {stage}, state, observer);
        EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        EXPECT_GT(cuts, 0);
        EXPECT_EQ(state.stage_time, 0.5);
    }
}

// x free, all else held, under a body acceleration a sin(w t): x'' = a sin(w t), x = a/w t - a/w^2 sin(w t).
TEST_P(Foundations, FreeComponentFollowsItsBodyAcceleration)
{
    const double amplitude = 4, frequency = 2.5, w = 2 * std::numbers::pi * frequency, end = 0.55;
    const double exact = amplitude / w * end - amplitude / (w * w) * std::sin(w * end);
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        const double h = i ? 5e-4 : 1e-3;
        Model model = make_model(GetParam(), stone(), dry(30));
        const int box = add_box(model, "abutment", {-1, -1, -1}, {1, 1, 0});
        model.foundations.push_back({box, {false, true, true}, true});
        Stage stage = dynamic_stage(end, h);
        stage.body_accelerations = {{box, 0, sine(amplitude, frequency)}};
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {stage}, state);
        EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        const Vector3d moved = centroid(model, state, box) - model.blocks[box].moments.centroid;
        errors[i] = std::abs(moved.x() - exact) / exact;
        EXPECT_EQ(moved.y(), 0);
        EXPECT_EQ(moved.z(), 0);
        EXPECT_EQ(pose_of(model.kinematics, state, box).map, Eigen::Matrix3d::Identity());
        const double speed = velocity_of(model.kinematics, state, box).x();
        // The mean of the load over each step: the speed is exact.
        EXPECT_NEAR(speed, amplitude / w * (1 - std::cos(w * end)), 1e-12);
        EXPECT_NEAR(report.energy.load_work, 0.5 * model.mass(box) * speed * speed,
                    1e-9 * report.energy.load_work);
        EXPECT_LT(report.energy.relative_residual(), 1e-11);
    }
    // The way is the speed's sum by trapezia.
    const double due = 1e-3 * 1e-3 / 12 * amplitude * std::sin(w * end) / exact;
    EXPECT_NEAR(errors[0], due, 1e-3 * due);
    EXPECT_NEAR(errors[0] / errors[1], 4, 0.01);
}

// Newmark takes the load of the end of the step, the energy-decaying integrator its mean.
TEST_P(Foundations, BodyAccelerationIsMoreExactWithTheEnergyDecayingIntegrator)
{
    const double amplitude = 4, frequency = 2.5, w = 2 * std::numbers::pi * frequency, end = 0.6;
    const double exact = amplitude / w * end - amplitude / (w * w) * std::sin(w * end);
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        Model model = make_model(GetParam(), stone(), dry(30));
        const int box = add_box(model, "block", {-1, -1, -1}, {1, 1, 0});
        Stage stage = dynamic_stage(end, 1e-3, Vector3d::Zero());
        stage.control.integrator = i ? Integrator::energy_decaying : Integrator::newmark;
        stage.body_accelerations = {{box, 0, sine(amplitude, frequency)}};
        State state = initial_state(model);
        run_quietly(model, {stage}, state);
        errors[i] = std::abs(centroid(model, state, box).x() - exact) / exact;
    }
    EXPECT_LT(errors[1], 0.12 * errors[0]);
}

// A stage begins where the foundations stand: a second stage with a motion of its own does not jump back.
TEST_P(Foundations, TheNextStageStartsWhereTheLastOneEnded)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "base", {-1, -1, -1}, {1, 1, 0}));
    Stage first = dynamic_stage(0.37, 1e-3), second = first;
    first.motions = {{0, 0, sine(2, 1)}};
    second.motions = {{0, 0, sine(1, 1)}};
    State state = initial_state(model);
    run_quietly(model, {first, second}, state);
    const double exact = sine(2, 1)->displacement(0.37) + sine(1, 1)->displacement(0.37);
    EXPECT_NEAR(centroid(model, state, 0).x(), exact, 1e-14);
}

// A base under an eccentric load, on springs: with its rotation held it sinks level, else it tilts.
TEST_P(Foundations, HeldRotationKeepsABlockLevelUnderAnEccentricLoad)
{
    for (const bool rotation_held : {true, false}) {
        Model model = make_model(GetParam(), stone(), dry(30));
        hold(model, add_box(model, "ground", {-3, -3, -1}, {3, 3, 0}));
        const int base = add_box(model, "base", {-1, -1, 0}, {1, 1, 0.4});
        const int load = add_box(model, "load", {0.4, -0.5, 0.4}, {1, 0.5, 2.4});
        model.foundations.push_back({base, {true, true, false}, rotation_held});
        State state = initial_state(model);
        ASSERT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
        const Eigen::Matrix3d map = pose_of(model.kinematics, state, base).map;
        const double tilt = (map - map.transpose()).norm();
        EXPECT_EQ(tilt == 0, rotation_held) << tilt;
        EXPECT_TRUE(rotation_held || tilt > 1e-9);
        const Vector3d moved = centroid(model, state, base) - model.blocks[base].moments.centroid;
        EXPECT_EQ(moved.x(), 0);
        double carried = 0, stiffness = 0;
        for (const ContactPatch& patch : state.contacts.patches)
            for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
                if (patch.block_a == 0 || patch.block_b == 0) {
                    carried += state.contacts.points[i].normal_force;
                    stiffness += patch.stiffness * state.contacts.points[i].area;
                }
        const double weight = (model.mass(base) + model.mass(load)) * gravity;
        EXPECT_NEAR(carried, weight, 1e-6 * weight);
        if (rotation_held)
            EXPECT_NEAR(-moved.z(), weight / stiffness, 1e-6 * weight / stiffness);
        else
            EXPECT_LT(moved.z(), 0);
    }
}

}  // namespace voussoir::testing
