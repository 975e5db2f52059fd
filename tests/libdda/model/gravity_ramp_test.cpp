// Gravity that grows or turns: its mean over a step, and what it does to a block.
#include "libdda/model/gravity_ramp.h"

#include <gtest/gtest.h>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

const Vector3d down{0, 0, -gravity};

}  // namespace

TEST(GravityRamp, MeanOfWhatGrowsIsExact)
{
    const GravityRamp ramp{2, {1, 0, 0}, false};
    EXPECT_TRUE(mean_gravity(ramp, down, 0, 0).isApprox(Vector3d(1, 0, 0)));
    EXPECT_TRUE(mean_gravity(ramp, down, 0.5, 1.5).isApprox(0.5 * (down + Vector3d(1, 0, 0)), 1e-15));
    // From 1 s to 3 s it is three quarters of the way in the mean of the first second, and there in the next.
    EXPECT_TRUE(mean_gravity(ramp, down, 1, 3).isApprox(0.125 * Vector3d(1, 0, 0) + 0.875 * down, 1e-15));
    EXPECT_EQ(mean_gravity(ramp, down, 2, 3), down);
    EXPECT_EQ(mean_gravity({}, down, 0, 1), down) << "no ramp";
}

TEST(GravityRamp, TurnsAtAConstantRateAndKeepsItsSize)
{
    const GravityRamp ramp{10, down, true};
    const Vector3d end = inclined_gravity(20);
    for (const double time : {0.0, 2.5, 5.0, 10.0, 11.0})
        EXPECT_TRUE(
            mean_gravity(ramp, end, time, time).isApprox(inclined_gravity(20 * std::min(time / 10, 1.0)), 1e-14));
}

// a = g t / T: after T a block in the air has fallen by g T^2 / 6, with the speed g T / 2.
TEST(GravityRamp, MakesABlockFallByTheCubeOfTime)
{
    for (const Kinematics kinematics : {Kinematics::spatial_deformable, Kinematics::planar_rigid}) {
        Model model = make_model(kinematics, stone(), dry(30));
        add_box(model, "block", {0, 0, 0}, {1, 1, 1});
        State state = initial_state(model);
        Stage stage = dynamic_stage(1, 1e-3);
        stage.gravity_ramp.duration = 1;
        const RunReport report = run_quietly(model, {stage}, state);
        EXPECT_NEAR(velocity_of(kinematics, state, 0).z(), -gravity / 2, 1e-10);
        EXPECT_NEAR(centroid(model, state, 0).z(), 0.5 - gravity / 6, 1e-5);
        EXPECT_NEAR(report.energy.gravity_work, model.mass(0) * gravity * gravity / 8,
                    1e-3 * report.energy.kinetic);
        EXPECT_LT(report.energy.relative_residual(), 1e-10);
    }
}

// On a table that tilts by 1 degree in a second a block begins to slide at the friction angle.
TEST(GravityRamp, TiltsABlockUntilItSlides)
{
    const Model model = block_on_plane(Kinematics::spatial_rigid, 20);
    State state = initial_state(model);
    Stage stage = dynamic_stage(22, 5e-3, inclined_gravity(22));
    stage.gravity_ramp = {22, down, true};
    double slid_at = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        if (slid_at == 0 && centroid(model, now, 1).x() > 1e-4) slid_at = now.time;
    };
    run(model, {static_stage(1, down), stage}, state, observer);
    EXPECT_NEAR(slid_at, 20, 0.2);
    EXPECT_GT(centroid(model, state, 1).x(), 0.1);
}

}  // namespace voussoir::testing
