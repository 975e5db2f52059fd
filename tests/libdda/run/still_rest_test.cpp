// What stands still stays where it is, at the price of finding its contacts: no force or motion of rounding level
// sets it in motion.
#include <gtest/gtest.h>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

/// Ten courses of three bricks each, crossed: 7.5 x 2.5 x 1.5 cm, light and stiff, so that a gap of 1e-16 m is
/// worth as much as a step tolerates.
Model crossed_bricks(Kinematics kinematics)
{
    constexpr double width = 0.025, height = 0.015;
    JointMaterial joint = dry(17);
    Model model = make_model(kinematics, {"stone", 600, 1e10, 0.2}, joint);
    hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
    for (int course = 0; course < 10; ++course)
        for (int i = -1; i <= 1; ++i) {
            const double low = (i - 0.5) * width, high = (i + 0.5) * width;
            const double bed = course * height, top = bed + height;
            if (course % 2 == 0)
                add_box(model, "brick", {low, -1.5 * width, bed}, {high, 1.5 * width, top});
            else
                add_box(model, "brick", {-1.5 * width, low, bed}, {1.5 * width, high, top});
        }
    return model;
}

/// Two columns and a beam.
Model portal(Kinematics kinematics)
{
    Model model = make_model(kinematics, {"stone", 2400, 2e10, 0.2}, dry(30));
    hold(model, add_box(model, "floor", {-3, -1, -1}, {5, 2, 0}));
    for (const double left : {0.0, 2.0})
        for (int i = 0; i < 4; ++i) add_box(model, "drum", {left, 0, 0.5 * i}, {left + 0.5, 0.5, 0.5 * (i + 1)});
    add_box(model, "beam", {0, 0, 2}, {2.5, 0.5, 2.6});
    return model;
}

}  // namespace

// A step that finds a state and leaves it bit for bit leaves it so a million times.
TEST(StillRest, StaysBitForBit)
{
    for (const bool tower : {true, false})
        for (const Kinematics kinematics : {Kinematics::spatial_rigid, Kinematics::spatial_deformable}) {
            const Model model = tower ? crossed_bricks(kinematics) : portal(kinematics);
            State state = initial_state(model);
            std::vector<double> coordinates, velocities, forces;
            std::int64_t before = 0;
            RunObserver observer;
            const RunReport report = [&] {
                const std::vector<Stage> stages{static_stage(1, {0, 0, -gravity}),
                                                dynamic_stage(1, 0.02, {0, 0, -gravity})};
                observer.step = [&](const State& now, const StepReport& step, const RunReport&) {
                    if (now.stage == 0) return;
                    EXPECT_EQ(step.cuts, 0);
                    std::vector<double> pressing;
                    for (const ContactPoint& point : now.contacts.points) pressing.push_back(point.normal_force);
                    if (before++ > 0) {
                        EXPECT_EQ(now.coordinates, coordinates);
                        EXPECT_EQ(now.velocities, velocities);
                        EXPECT_EQ(pressing, forces);
                    }
                    coordinates = now.coordinates;
                    velocities = now.velocities;
                    forces = pressing;
                };
                return run(model, stages, state, observer);
            }();
            EXPECT_EQ(report.outcome, Outcome::completed);
            EXPECT_EQ(before, 50) << "steps of motion";
        }
}

// It is a shortcut of what rests, not of what is in the air with no velocity, nor of what loses its balance.
TEST(StillRest, IsNoneWithoutBalance)
{
    Model model = make_model(Kinematics::spatial_rigid, {"stone", 2000, 1e10, 0.2}, dry(30));
    hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
    const int box = add_box(model, "box", {0, 0, 0.5}, {0.2, 0.2, 0.7});
    State state = initial_state(model);
    run(model, {dynamic_stage(0.1, 1e-3, {0, 0, -gravity})}, state, {});
    const double fallen =
        model.blocks[box].moments.centroid.z() - pose_of(model.kinematics, state, box).centroid.z();
    EXPECT_NEAR(fallen, 0.5 * gravity * 0.1 * 0.1, 1e-9);
}

}  // namespace voussoir::testing
