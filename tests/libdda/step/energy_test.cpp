// The energy ledger: each term against its own closed form, and a residual that notices what is missing.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

class Energy : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Energy, every_kinematics(), test_name);

}  // namespace

TEST_P(Energy, OfAFreeFall)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    add_box(model, "block", {-0.5, -0.4, -0.3}, {0.5, 0.4, 0.3});
    State state = initial_state(model);
    set_velocity(model, state, 0, {1, 0, 2});
    const double m = model.mass(0), drop = 0.5 * gravity * 0.49 - 2 * 0.7;
    const RunReport report = run_quietly(model, {dynamic_stage(0.7, 1e-3)}, state);
    EXPECT_NEAR(report.energy.gravity_work, m * gravity * drop, 1e-9 * m * gravity);
    EXPECT_NEAR(report.energy.kinetic, 0.5 * m * (1 + std::pow(2 - 0.7 * gravity, 2)), 1e-9 * m);
    EXPECT_NEAR(report.energy.start_kinetic, 0.5 * m * 5, 1e-12 * m);
    EXPECT_LT(report.energy.relative_residual(), 1e-10);
}

// Friction takes mu N times the distance; gravity gives m g times the drop.
TEST_P(Energy, OfSlidingDownAnIncline)
{
    const Model model = block_on_plane(GetParam(), 20);
    State state = initial_state(model);
    ASSERT_EQ(run_quietly(model, {static_stage(0.1, {0, 0, -gravity})}, state).outcome, Outcome::completed);
    begin_stage(model, 0, state);
    const Vector3d start = centroid(model, state, 1), g = inclined_gravity(45);
    const RunReport report = run_quietly(model, {dynamic_stage(1, 1e-3, g)}, state);
    const Vector3d moved = centroid(model, state, 1) - start;
    const double m = model.mass(1), friction = std::tan(20 * degrees) * m * -g.z() * moved.x();
    EXPECT_NEAR(report.energy.gravity_work, m * g.dot(moved), 1e-9 * m * gravity);
    EXPECT_NEAR(report.energy.friction, friction, 1e-3 * friction);
    EXPECT_NEAR(report.energy.kinetic, 0.5 * m * velocity_of(model.kinematics, state, 1).squaredNorm(), 1e-6 * m);
    EXPECT_EQ(report.energy.foundation_work, 0);
    EXPECT_EQ(report.energy.damping_contact, 0);
    EXPECT_EQ(report.energy.fracture, 0);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// A block carried along by a base that starts gently: the base does all the work, and it becomes motion.
TEST_P(Energy, OfABlockCarriedByAMovingBase)
{
    Model model = make_model(GetParam(), stone(), dry(50));
    hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    Stage carried = dynamic_stage(0.25, 1e-3);
    const auto push = std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(4, 1, 0, 0.5));
    carried.motions = {{0, 0, push}};
    const RunReport report = run_quietly(model, {static_stage(0.1), carried}, state);
    const double speed = push->velocity(0.25), exact = 0.5 * model.mass(block) * speed * speed;
    EXPECT_NEAR(report.energy.foundation_work, exact, 5e-3 * exact);
    EXPECT_NEAR(report.energy.kinetic, exact, 5e-3 * exact);
    EXPECT_LT(report.energy.friction, 1e-3 * exact);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// A base that lifts a block slowly does the work against gravity.
TEST_P(Energy, OfABlockLiftedByItsBase)
{
    Model model = make_model(GetParam(), stone(), dry(50));
    hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    Stage lifting = dynamic_stage(1, 1e-3);
    lifting.motions = {{0, 2, std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(2, 1, 0, 1))}};
    ASSERT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
    begin_stage(model, 0, state);
    const double start = centroid(model, state, block).z();
    const RunReport report = run_quietly(model, {lifting}, state);
    const double lift = centroid(model, state, block).z() - start, work = model.mass(block) * gravity * lift;
    EXPECT_GT(lift, 0.2);
    EXPECT_NEAR(report.energy.gravity_work, -work, 1e-9 * work);
    EXPECT_NEAR(report.energy.foundation_work, work, 1e-3 * work);
    // What went in on the whole is nothing, so the measure is the work that went through. Joints of 2e12 N/m make
    // 2e-4 N of the rounding of a gap.
    EXPECT_LT(std::abs(report.energy.residual()), 1e-11 * work);
}

// A held block on springs stores W^2 / (2 K) when gravity has come on slowly.
TEST_P(Energy, OfSpringsUnderAWeight)
{
    JointMaterial joint = dry(30);
    joint.stiffness = {ContactStiffness::Kind::per_area, 1e8};
    Model model = make_model(GetParam(), stone(1e13), joint);
    hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
    const int block = add_box(model, "block", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(0.1)}, state);
    const double weight = model.mass(block) * gravity, stored = weight * weight / (2 * 1e8);
    EXPECT_NEAR(report.energy.contact, stored, 1e-3 * stored);
    EXPECT_NEAR(report.energy.gravity_work, 2 * stored, 1e-3 * stored);
    EXPECT_EQ(report.energy.kinetic, 0);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// Blocks that the model has within one another start with the energy of their springs, which throws them apart; no
// contact made it.
TEST_P(Energy, OfSpringsThatArePressedAtTheStart)
{
    JointMaterial joint = dry(30);
    joint.stiffness = {ContactStiffness::Kind::per_area, 1e9};
    Model model = make_model(GetParam(), stone(), joint);
    hold(model, add_box(model, "base", {-1, -1, -1}, {1, 1, 0}));
    add_box(model, "block", {-0.5, -0.5, -1e-3}, {0.5, 0.5, 1});
    State state = initial_state(model);
    const double depth = is_planar(model.kinematics) ? model.thickness : 1;
    const RunReport report = run_quietly(model, {dynamic_stage(0.1, 1e-4, Vector3d::Zero())}, state);
    EXPECT_NEAR(report.energy.start_contact, 0.5 * 1e9 * 1e-6 * depth, 1e-9 * 500);
    EXPECT_NEAR(report.energy.redetection, 0, 1e-4 * 500);  // areas change with the strain
    EXPECT_GT(report.energy.kinetic, 0.8 * report.energy.start_contact);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
    EXPECT_TRUE(report.warnings.empty()) << ::testing::PrintToString(report.warnings);
}

// Blocks that rock, slide and knock, shaken: the balance of everything, and how it reacts to a falsified term.
// A contact that closes within a step presses with the force of its end all the while, over the gap and the depth,
// and stores k d^2 / 2: it takes k d (g + d / 2). The integrator takes nothing.
TEST_P(Energy, OfAContactThatClosesWithinAStep)
{
    constexpr double gap = 4e-4, speed = 1, stiffness = 1e9;  // m, m/s, Pa/m
    JointMaterial joint = dry(30);
    joint.restitution.reset();
    joint.face = FaceLaw::corners;
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
    Model model = make_model(GetParam(), stone(), joint);
    hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
    const int box = add_box(model, "box", {-0.5, -0.5, gap}, {0.5, 0.5, gap + 1});
    State state = initial_state(model);
    set_velocity(model, state, box, {0, 0, -speed});
    Stage stage = dynamic_stage(1e-3, 1e-3, {0, 0, 0});
    stage.control.dissipation = 0;
    const RunReport report = run(model, {stage}, state, {});
    ASSERT_EQ(report.steps, 1);
    const EnergyLedger& energy = report.energy;
    const double depth = std::sqrt(2 * energy.contact / stiffness);  // on an area of 1 m2
    EXPECT_GT(depth, 1e-5);
    const double share = is_deformable(GetParam()) ? 1e-4 : 1e-6;  // what is elastic changes its shape as well
    EXPECT_NEAR(energy.closing, stiffness * depth * (gap + depth / 2), share * energy.closing);
    EXPECT_NEAR(energy.algorithmic, 0, 1e-6 * energy.closing);
    EXPECT_EQ(energy.impact, 0);
    EXPECT_LT(energy.relative_residual(), 1e-9);
}

TEST_P(Energy, ResidualIsSmallAndNoticesAMissingTerm)
{
    for (const Integrator integrator : {Integrator::newmark, Integrator::energy_decaying}) {
        FewBlocks scene(GetParam(), {});
        scene.model.joints[0].relaxation_time = 1e-4;
        Stage stage = shaking(0.5, 1e-3);
        stage.control.integrator = integrator;
        stage.control.force_tolerance = 1e-8;
        stage.damping.rate = 0.2;
        const RunReport report = run_quietly(scene.model, {stage}, scene.state);
        ASSERT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
        const EnergyLedger& e = report.energy;
        std::printf(
            "shaken blocks: gravity %.0f, foundation %.0f, friction %.0f, dashpot %.0f, damping %.0f, algorithmic "
            "%.1f, rotation %.2f, redetection %.2f, kinetic %.0f J, residual %.1e\n",
            e.gravity_work, e.foundation_work, e.friction, e.damping_contact, e.damping_kinetic, e.algorithmic,
            e.algorithmic_rotation, e.redetection, e.kinetic, e.relative_residual());
        EXPECT_LT(e.relative_residual(), 1e-6);
        EXPECT_GT(e.friction, 0);
        EXPECT_GT(e.damping_contact, 0);
        EXPECT_LT(std::abs(e.algorithmic_rotation) + std::abs(e.redetection), 0.05 * e.dissipated());
        for (double EnergyLedger::*term :
             {&EnergyLedger::gravity_work, &EnergyLedger::foundation_work, &EnergyLedger::friction,
              &EnergyLedger::kinetic, &EnergyLedger::damping_contact, &EnergyLedger::damping_kinetic,
              &EnergyLedger::algorithmic}) {
            EnergyLedger falsified = e;
            falsified.*term *= 0.5;
            EXPECT_GT(falsified.relative_residual(), 1e-4);
        }
        EnergyLedger without_friction = e;
        without_friction.friction = 0;
        EXPECT_GT(without_friction.relative_residual(), 1e-3);
    }
}

// Contacts take 8 J, give 10, take 30, give 6: 10 is the most they gave between two moments, though on balance of
// the whole run they never gave more than 2.
TEST(EnergyLedger, WhatContactsTookIsNoCreditForWhatTheyGive)
{
    EnergyLedger energy;
    energy.kinetic = 50;
    for (const double taken : {3.0, 8.0, 1.0, -2.0, 5.0, 28.0, 22.0}) {
        energy.redetection = taken;
        energy.note_peaks();
    }
    EXPECT_EQ(energy.peak_given, 10);
    EXPECT_EQ(energy.peak_taken, 28);
    energy.kinetic = 20;
    energy.note_peaks();
    EXPECT_EQ(energy.peak_stored, 50);
}

TEST(EnergyLedger, RelativeResidualIsAShareOfWhatWasPutInLostOrStored)
{
    EnergyLedger energy;
    EXPECT_EQ(energy.relative_residual(), 0);
    energy.gravity_work = 100;
    energy.kinetic = 60;
    energy.friction = 39;
    EXPECT_NEAR(energy.residual(), 1, 1e-12);
    EXPECT_NEAR(energy.relative_residual(), 0.01, 1e-12);
    energy.start_kinetic = 1;
    EXPECT_NEAR(energy.relative_residual(), 0.02, 1e-12);
    energy.start_kinetic = energy.kinetic = 200;  // a block that flies in
    energy.friction = 98;
    EXPECT_NEAR(energy.residual(), 2, 1e-12);
    EXPECT_NEAR(energy.relative_residual(), 0.01, 1e-12);
    energy.peak_stored = 400;  // thrown up, and as high again now
    EXPECT_NEAR(energy.relative_residual(), 0.005, 1e-12);
    energy.kinetic = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(energy.relative_residual()));
}

}  // namespace voussoir::testing
