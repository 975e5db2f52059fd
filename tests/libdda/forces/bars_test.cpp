// Bars: tie rods that pull, dowels that hold joints, and both where they yield.
#include "libdda/forces/bars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libdda/analysis/bar_forces.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

constexpr double endless = std::numeric_limits<double>::infinity();

class Bars : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Bars, every_kinematics(), test_name);

/// Two cubes of 1 m, whose middles are 4 m apart along x; they weigh 2.5 t each.
Model two_cubes(Kinematics kinematics)
{
    Model model = make_model(kinematics, stone(), dry(30));
    add_box(model, "left", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    add_box(model, "right", {3.5, -0.5, -0.5}, {4.5, 0.5, 0.5});
    return model;
}

Bar rod(const Model& model, int a, int b, double stiffness, const Vector3d& lever_a = Vector3d::Zero(),
        const Vector3d& lever_b = Vector3d::Zero())
{
    Bar bar;
    bar.name = "rod";
    bar.block_a = a;
    bar.block_b = b;
    bar.anchor_a = lever_a;
    bar.anchor_b = lever_b;
    bar.length = (model.blocks[b].moments.centroid + lever_b - model.blocks[a].moments.centroid - lever_a).norm();
    bar.axial = stiffness;
    return bar;
}

/// A dowel at a place [m], across the joint of two blocks.
Bar dowel(const Model& model, int a, int b, const Vector3d& at, const Vector3d& axis, double stiffness)
{
    Bar bar;
    bar.name = "dowel";
    bar.block_a = a;
    bar.block_b = b;
    bar.anchor_a = at - model.blocks[a].moments.centroid;
    bar.anchor_b = at - model.blocks[b].moments.centroid;
    bar.is_rod = false;
    bar.axis = axis;
    bar.axial = bar.lateral = stiffness;
    bar.compression = endless;
    return bar;
}

constexpr double cube = 2500;  // kg

}  // namespace

// A spring between two masses: after half a period they have changed their speeds. Second order in the step.
TEST_P(Bars, ARodBetweenTwoStonesVibrates)
{
    Model model = two_cubes(GetParam());
    const double stiffness = 1e7, speed = 0.1;
    model.bars = {rod(model, 0, 1, stiffness)};
    model.bars[0].compression = endless;
    const double half_period = std::numbers::pi * std::sqrt(cube / 2 / stiffness);
    std::vector<double> elongations;
    for (const int steps : {50, 100, 200}) {
        State state = initial_state(model);
        set_velocity(model, state, 1, {speed, 0, 0});
        const RunReport report =
            run_quietly(model, {dynamic_stage(half_period, half_period / steps, Vector3d::Zero())}, state);
        EXPECT_NEAR(velocity_of(model.kinematics, state, 0).x(), speed, 2e-4 * speed);
        EXPECT_LT(report.energy.relative_residual(), 1e-9);
        EXPECT_NEAR(report.bars[0].tension, speed * std::sqrt(stiffness * cube / 2), 2e-3 * 11000);
        elongations.push_back(bars_now(model, state)[0].elongation);
    }
    for (const int i : {0, 1}) EXPECT_NEAR(elongations[i] / elongations[i + 1], 4, 0.1);
}

// What a rod that yields takes is its yield force times how much longer it is afterwards.
TEST_P(Bars, AYieldingRodStopsStones)
{
    Model model = two_cubes(GetParam());
    const double stiffness = 1e8, speed = 1, limit = 2e4;
    model.bars = {rod(model, 0, 1, stiffness)};
    model.bars[0].tension = limit;
    const double energy = 0.25 * cube * speed * speed, elastic = limit * limit / (2 * stiffness);
    const double longer = (energy - elastic) / limit, duration = speed / (2 * limit / cube);
    State state = initial_state(model);
    set_velocity(model, state, 1, {speed, 0, 0});
    const RunReport report =
        run_quietly(model, {dynamic_stage(1.05 * duration, duration / 400, Vector3d::Zero())}, state);
    EXPECT_NEAR(report.energy.yielding, limit * longer, 2e-3 * limit * longer);
    EXPECT_NEAR(bars_now(model, state)[0].yielded, longer, 2e-3 * longer);
    EXPECT_NEAR(report.bars[0].tension, limit, 1e-9 * limit);
    ASSERT_TRUE(report.bars[0].yielded);
    EXPECT_LT(*report.bars[0].yielded, 0.05 * duration);
    EXPECT_LT(report.energy.relative_residual(), 1e-9);
}

// A pendulum of finite amplitude, and the tension at its lowest point.
TEST_P(Bars, AStoneSwingsFromARod)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "ceiling", {-0.5, -0.5, 3}, {0.5, 0.5, 4}));
    add_box(model, "stone", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    model.bars = {rod(model, 0, 1, 1e9, {0, 0, -0.5})};
    const double length = 3, angle = 40 * degrees;
    State state = initial_state(model);
    double* place = state.coordinates.data() + coordinates_per_block(model.kinematics);
    const double stretched = length + cube * gravity * std::cos(angle) / model.bars[0].axial;
    place[0] = stretched * std::sin(angle);
    place[is_planar(GetParam()) ? 1 : 2] = 3 - stretched * std::cos(angle);
    const double period = 4 * std::sqrt(length / gravity) * std::comp_ellint_1(std::sin(angle / 2));
    const RunReport report = run_quietly(model, {dynamic_stage(period, 2e-3)}, state);
    EXPECT_LT(
        (centroid(model, state, 1) - Vector3d(length * std::sin(angle), 0, 3 - length * std::cos(angle))).norm(),
        2e-3);
    EXPECT_NEAR(report.bars[0].tension, cube * gravity * (3 - 2 * std::cos(angle)), 0.01 * cube * gravity);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// Rods and dowels put no moment on the two stones together, and neither gives nor takes energy while they turn.
TEST_P(Bars, AngularMomentumAndEnergyStay)
{
    Model model = two_cubes(GetParam());
    model.bars = {rod(model, 0, 1, 1e7, {0.2, 0.1, 0.4}, {-0.1, -0.2, 0.3}),
                  dowel(model, 0, 1, {2, 0.1, -0.2}, Vector3d::UnitX(), 2e7)};
    const auto momentum = [&](const State& state) {
        Vector3d sum = Vector3d::Zero();
        for (const int b : {0, 1})
            sum += angular_momentum(model, state, b) +
                   cube * centroid(model, state, b).cross(velocity_of(model.kinematics, state, b));
        return sum;
    };
    std::vector<double> losses;
    for (const double h : {2e-3, 1e-3}) {
        State state = initial_state(model);
        set_velocity(model, state, 0, {0, 0, 2}, {0, -1, 0});
        set_velocity(model, state, 1, {0, 0, -1}, {0.3 * !is_planar(GetParam()), 0.5, 0});
        const Vector3d before = momentum(state);
        Stage stage = dynamic_stage(1, h, Vector3d::Zero());
        stage.control.dissipation = 0;
        stage.control.force_tolerance = 1e-10;
        const RunReport report = run_quietly(model, {stage}, state);
        EXPECT_LT((momentum(state) - before).norm(), 2e-3 * before.norm());
        EXPECT_LT(report.energy.relative_residual(), 1e-8);
        losses.push_back(std::abs(report.energy.algorithmic + report.energy.algorithmic_rotation) /
                         report.energy.start_kinetic);
    }
    EXPECT_LT(losses[1], 1e-3);
    EXPECT_LT(losses[1], 0.5 * losses[0]);
}

// A rod holds nothing together that comes together by itself.
TEST_P(Bars, ASlackRodDoesNotPush)
{
    Model model = two_cubes(GetParam());
    model.bars = {rod(model, 0, 1, 1e7)};
    State state = initial_state(model);
    set_velocity(model, state, 1, {-1, 0, 0});
    run_quietly(model, {dynamic_stage(1, 1e-2, Vector3d::Zero())}, state);
    EXPECT_NEAR(centroid(model, state, 1).x(), 3, 1e-9);
    EXPECT_NEAR(velocity_of(model.kinematics, state, 1).x(), -1, 1e-12);
    EXPECT_EQ(bars_now(model, state)[0].axial, 0);
}

// Two stones that a rod presses together, one of them held.
TEST_P(Bars, APrestressedRodPressesAJoint)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "left", {-1, -0.5, -0.5}, {0, 0.5, 0.5}));
    add_box(model, "right", {0, -0.5, -0.5}, {1, 0.5, 0.5});
    Bar bar = rod(model, 0, 1, 1e6, {-0.5, 0, 0}, {0.5, 0, 0});
    bar.prestress = 5e4;
    model.bars = {bar};
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(1e-2, Vector3d::Zero())}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    double pressing = 0;
    for (const ContactPoint& point : state.contacts.points) pressing += point.normal_force;
    for (const auto& point : state.planar_contacts.points) pressing += point.normal_force;
    const double axial = bars_now(model, state)[0].axial;
    EXPECT_NEAR(pressing, axial, 1e-6 * axial);
    EXPECT_LT(axial, bar.prestress);  // the joint has given way
    EXPECT_GT(axial, 0.99 * bar.prestress);
}

// Statics: a block on an incline with a dowel slides where its weight along the slope is friction and dowel.
TEST_P(Bars, ADowelHoldsASlope)
{
    const double friction = 20, shear = 3e3;
    Model model = block_on_plane(GetParam(), friction);
    Bar bar = dowel(model, 0, 1, {0, 0, 0}, Vector3d::UnitZ(), 1e8);
    bar.tension = bar.compression = 0;
    bar.shear = shear;
    model.bars = {bar};
    const double weight = model.mass(1) * gravity;
    const auto stays = [&](double angle) {
        State state = initial_state(model);
        const RunReport report = run_quietly(model, {static_stage(1e-2, inclined_gravity(angle))}, state);
        return report.outcome == Outcome::completed;
    };
    // sin(x) - tan(20 deg) cos(x) = V / W
    const double slope = std::asin(shear / weight * std::cos(friction * degrees)) / degrees + friction;
    EXPECT_TRUE(stays(slope - 0.05));
    EXPECT_FALSE(stays(slope + 0.05));
}

// A stone dowelled to ground that shakes: the balance closes, and half of what yielding takes is missed.
TEST_P(Bars, TheBalanceNeedsWhatYieldingTakes)
{
    Model model = block_on_plane(GetParam(), 20);
    Bar bar = dowel(model, 0, 1, {0.2, 0, 0}, Vector3d::UnitZ(), 1e8);
    bar.tension = 4e3;
    bar.shear = 2e3;
    model.bars = {bar};
    Stage stage = dynamic_stage(0.6, 1e-3);
    stage.control.force_tolerance = 1e-9;
    stage.motions = {{0, 0, std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(9, 4, 0, 0.5))}};
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(1e-2), stage}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_GT(report.energy.yielding, 10);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
    EnergyLedger falsified = report.energy;
    falsified.yielding *= 0.5;
    EXPECT_GT(falsified.relative_residual(), 1e-2);
}

// A stone thrown against a rod that is slack until it snaps taut, again and again, by steps from short to far
// longer than its period: energy is lost, by the integrator alone, and never gained.
TEST_P(Bars, ARodThatSnapsTautGivesNoEnergy)
{
    for (const double periods : {0.1, 1.5, 3.0, 20.0}) {  // omega h
        Model model = two_cubes(GetParam());
        hold(model, 0);
        constexpr double h = 2e-3;
        const double omega = periods / h;
        model.bars = {rod(model, 0, 1, cube * omega * omega)};
        model.bars[0].length += 0.013;
        State state = initial_state(model);
        set_velocity(model, state, 1, {1, 0, 0});
        RunObserver observer;
        double most = 0, last_loss = 0;
        observer.step = [&](const State&, const StepReport&, const RunReport& report) {
            most = std::max(most, report.energy.kinetic + report.energy.strain);
            EXPECT_GE(report.energy.algorithmic, last_loss - 1e-7 * report.energy.start_kinetic);
            last_loss = report.energy.algorithmic;
        };
        Stage stage = dynamic_stage(0.4, h, Vector3d::Zero());
        stage.control.force_tolerance = 1e-9;
        const RunReport report = run(model, {stage}, state, observer);
        EXPECT_LE(most, report.energy.start_kinetic * (1 + 1e-7)) << periods;
        EXPECT_LT(report.energy.relative_residual(), 1e-7) << periods;
        EXPECT_GT(report.bars[0].tension, 0);
    }
}

// A dowel across a joint that slides to and fro by far more than it stands: what it yields is all it takes.
TEST_P(Bars, ADowelThatYieldsToAndFroGivesNoEnergy)
{
    Model model = block_on_plane(GetParam(), 0);
    Bar bar = dowel(model, 0, 1, {0, 0, 0}, Vector3d::UnitZ(), 1e9);
    bar.tension = bar.compression = 0;
    bar.shear = 2e3;
    model.bars = {bar};
    Stage stage = dynamic_stage(1, 2e-3);
    stage.motions = {{0, 0, std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(9, 3, 0, 1))}};
    State state = initial_state(model);
    RunObserver observer;
    double loss = 0;
    observer.step = [&](const State&, const StepReport&, const RunReport& report) {
        EXPECT_GE(report.energy.algorithmic, loss - 1e-3);
        loss = report.energy.algorithmic;
    };
    const RunReport report = run(model, {static_stage(1e-2), stage}, state, observer);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_GT(report.energy.yielding, 100);
    EXPECT_LT(report.energy.algorithmic, 0.05 * report.energy.yielding);
}

// A foundation that moves along x and turns freely: the ground's work is all that goes in.
TEST_P(Bars, ABarOnAPartlyHeldFoundationKeepsTheBalance)
{
    Model model = two_cubes(GetParam());
    Foundation foundation;
    foundation.block = 0;
    foundation.rotation_held = false;
    model.foundations.push_back(foundation);
    model.bars = {rod(model, 0, 1, 1e7, {0.5, 0, 0.3}, {-0.5, 0, 0.1})};
    model.bars[0].compression = endless;
    Stage stage = dynamic_stage(1, 2e-3, Vector3d::Zero());
    stage.motions = {{0, 0, std::make_shared<GroundMotion>(GroundMotion::sine_acceleration(5, 3, 0.1, 1))}};
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {stage}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_GT(report.energy.foundation_work, 0);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// A stone hangs at rest, and does not count as fallen when it swings far below.
TEST_P(Bars, AStoneHangs)
{
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "ceiling", {-0.5, -0.5, 3}, {0.5, 0.5, 4}));
    add_box(model, "stone", {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5});
    model.bars = {rod(model, 0, 1, 1e8, {0, 0, -0.5}, {0, 0, 0.5})};
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {static_stage(1)}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_NEAR(bars_now(model, state)[0].axial, cube * gravity, 1e-6 * cube * gravity);

    model.bars[0].axial = 2e4;  // it stretches by more than the stone's size
    State swinging = initial_state(model);
    const RunReport moved = run_quietly(model, {dynamic_stage(1.2, 2e-3)}, swinging);
    EXPECT_LT(centroid(model, swinging, 1).z(), -1);
    EXPECT_EQ(moved.outcome, Outcome::completed);
    EXPECT_TRUE(moved.fallen.empty());
}

// A dowel holds as long as it sits in its hole, and never again.
TEST_P(Bars, ADowelLeavesItsHoleForGood)
{
    Model model = block_on_plane(GetParam(), 20);
    Bar bar = dowel(model, 0, 1, {0, 0, 0}, Vector3d::UnitZ(), 1e8);
    bar.tension = bar.compression = 0;
    bar.hold = 0.05;
    model.bars = {bar};
    State state = initial_state(model);
    set_velocity(model, state, 1, {0.5, 0, 2});
    RunObserver observer;
    double held_until = 0, after = 0;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const BarNow bar_now = bars_now(model, now)[0];
        if (bar_now.shear > 0)
            held_until = now.time;
        else
            after = std::max(after, now.time);
    };
    const RunReport report = run(model, {dynamic_stage(1, 1e-3)}, state, observer);
    ASSERT_TRUE(report.bars[0].out);
    EXPECT_NEAR(*report.bars[0].out, 0.025, 2e-3);
    EXPECT_LT(held_until, *report.bars[0].out);
    EXPECT_EQ(after, 1);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

}  // namespace voussoir::testing
