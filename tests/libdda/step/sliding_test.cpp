// Blocks that slide and blocks that must not.
#include <gtest/gtest.h>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

class Sliding : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Sliding, every_kinematics(), test_name);

// s = g (sin a - cos a tan phi) t^2 / 2 from rest.
TEST_P(Sliding, InclineFollowsTheClosedForm)
{
    const Model model = block_on_plane(GetParam(), 20);
    State state = initial_state(model);
    const double x0 = centroid(model, state, 1).x();
    const RunReport report = run_quietly(model, {dynamic_stage(1, 1e-3, inclined_gravity(45))}, state);
    const double exact =
        0.5 * gravity * (std::sin(45 * degrees) - std::cos(45 * degrees) * std::tan(20 * degrees));
    const double error = std::abs(centroid(model, state, 1).x() - x0 - exact) / exact;
    std::printf(
        "incline 45/20, 1 ms, 1 s: relative error %.2e (%s), %lld iterations, %lld cuts, energy residual %.1e\n",
        error, std::string(name_of(GetParam())).c_str(), static_cast<long long>(report.open_close_iterations),
        static_cast<long long>(report.step_cuts), report.energy.relative_residual());
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_LT(error, 1e-5);
    EXPECT_NEAR(centroid(model, state, 1).y(), 0, 1e-9);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// Undamped, an elastic block that slides near the friction angle flutters at any step until it slides four times
// as far. What the integrator takes ends with the step: at 0.1 ms a block on its corners flutters again, and at
// 0.5 ms one that bends.
TEST_P(Sliding, AnElasticBlockNearTheFrictionAngleDoesNotFlutter)
{
    constexpr double friction = 29.9, angle = 30;  // degrees
    const double along = std::cos(angle * degrees) * std::tan(friction * degrees);
    const double drive = gravity * (std::sin(angle * degrees) - along);
    for (const auto& [face, h] :
         {std::pair(FaceLaw::points, 4e-3), {FaceLaw::points, 1e-3}, {FaceLaw::corners, 2.5e-4}}) {
        Model model = make_model(GetParam(), stone(), dry(friction));
        model.joints[0].face = face;
        hold(model, add_box(model, "base", {-3, -2, -1}, {6, 2, 0}));
        add_box(model, "block", {-1, -0.5, 0}, {1, 0.5, 1});
        State state = initial_state(model);
        // The plane is let go with its friction mobilised.
        const Eigen::Vector3d held(0.99999 * along * gravity, 0, -gravity * std::cos(angle * degrees));
        ASSERT_EQ(run_quietly(model, {static_stage(0.1, held)}, state).outcome, Outcome::completed);
        begin_stage(model, 0, state);
        const double x0 = centroid(model, state, 1).x();
        run_quietly(model, {dynamic_stage(2, h, inclined_gravity(angle))}, state);
        const double exact = 0.5 * drive * 4;
        const double error = std::abs(centroid(model, state, 1).x() - x0 - exact) / exact;
        std::printf("friction angle 29.9 of 30 degrees, %g ms: relative error %.1e\n", 1e3 * h, error);
        EXPECT_LT(error, 1e-4);
    }
}

// mu = m0 + c v gives v' = d - r v with d = g (sin a - m0 cos a), r = c g cos a:
// s = d / r (t - (1 - e^{-rt}) / r). It may weaken (c < 0) as well.
TEST_P(Sliding, FrictionFollowsTheSpeedOfSlipToSecondOrder)
{
    const double angle = 30 * degrees, at_rest = std::tan(20 * degrees);
    for (const double slope : {0.4, -0.1}) {  // s/m
        double last_error = 0;
        for (const double h : {4e-3, 2e-3}) {
            Model model = block_on_plane(GetParam(), 20);
            constexpr double fastest = 2;             // m/s, beyond what is reached
            model.joints[0].face = FaceLaw::corners;  // it does not tremble by bending
            model.joints[0].friction_at_speed = {{fastest, std::atan(at_rest + slope * fastest)}};
            State state = initial_state(model);
            // The plane is let go with its friction mobilised.
            const double along = 0.99999 * at_rest * gravity * std::cos(angle);
            Stage held = static_stage(0.1, {along, 0, -gravity * std::cos(angle)});
            ASSERT_EQ(run_quietly(model, {held}, state).outcome, Outcome::completed);
            const double x0 = centroid(model, state, 1).x(), duration = 0.4;
            begin_stage(model, 0, state);
            ASSERT_EQ(run_quietly(model, {dynamic_stage(duration, h, inclined_gravity(30))}, state).outcome,
                      Outcome::completed);
            const double drive = gravity * (std::sin(angle) - std::cos(angle) * at_rest);
            const double rate = slope * gravity * std::cos(angle);
            const double exact = drive / rate * (duration + std::expm1(-rate * duration) / rate);
            const double error = std::abs(centroid(model, state, 1).x() - x0 - exact) / exact;
            if (last_error > 0) {
                std::printf("friction m0 %+.1f v: error %.2e at 4 ms, %.2e at 2 ms\n", slope, last_error, error);
                EXPECT_LT(error, 0.3 * last_error);
                EXPECT_LT(error, 2e-5);
            }
            last_error = error;
        }
    }
}

// Static stages have pseudo steps and no speeds: friction is that at rest whatever the step.
TEST_P(Sliding, FrictionInStaticStagesIsThatAtRest)
{
    for (const double h : {1e-3, 1.0}) {
        Model model = block_on_plane(GetParam(), 30);
        model.joints[0].friction_at_speed = {{1e-3, 5 * degrees}};
        model.joints[0].stiffness = {ContactStiffness::Kind::per_area, 1e9};
        State state = initial_state(model);
        EXPECT_EQ(run_quietly(model, {static_stage(h, inclined_gravity(20))}, state).outcome, Outcome::completed)
            << h;
    }
}

TEST_P(Sliding, BlockThatMustStickDoesNotCreep)
{
    const Model model = block_on_plane(GetParam(), 50);
    State state = initial_state(model);
    Stage first = dynamic_stage(1, 1e-3, inclined_gravity(45)), rest = first;
    rest.duration = 9;
    run_quietly(model, {static_stage(0.1, inclined_gravity(45)), first}, state);
    const Eigen::Vector3d before = centroid(model, state, 1);
    State later = state;
    begin_stage(model, 0, later);
    run_quietly(model, {rest}, later);
    const double creep = (centroid(model, later, 1) - before).norm();
    std::printf("sticking block: %.2e m from 1 s to 10 s\n", creep);
    EXPECT_LT(creep, 1e-6);
    EXPECT_LT((centroid(model, later, 1) - Eigen::Vector3d(0, 0, 0.15)).norm(), 1e-6);
}

// x = v t - mu g t^2 / 2 over two floor blocks whose tops are flush.
TEST_P(Sliding, BoxPassesTheJointOfAFlushFloor)
{
    for (const double h : {1e-3, 5e-3}) {
        Model model = make_model(GetParam(), stone(), dry(std::atan(0.3) / degrees));
        hold(model, add_box(model, "floor 1", {-1, -1, -1}, {1, 1, 0}));
        hold(model, add_box(model, "floor 2", {1, -1, -1}, {3, 1, 0}));
        const int box = add_box(model, "box", {-0.5, -0.5, 0}, {0.5, 0.5, 0.3});
        State state = initial_state(model);
        ASSERT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
        set_velocity(model, state, box, {2, 0, 0});
        state.stage = 0;
        begin_stage(model, 0, state);
        double lift = 0;
        RunObserver observer;
        observer.step = [&](const State& now, const StepReport&, const RunReport&) {
            lift = std::max(lift, std::abs(velocity_of(model.kinematics, now, box).z()));
        };
        run(model, {dynamic_stage(0.6, h)}, state, observer);
        const double exact = 2 * 0.6 - 0.5 * 0.3 * gravity * 0.36;
        const double error = std::abs(centroid(model, state, box).x() - exact);
        std::printf("flush floor, h = %g s: error %.2e m, largest vertical speed %.1e m/s\n", h, error, lift);
        EXPECT_LT(error, 1e-4);
        EXPECT_LT(lift, 1e-3);
    }
}

// Thrown along a level floor a box stops after v^2 / (2 mu g), wherever in a step that is, and stays; one alone
// and one of many alike, and no step is divided.
TEST_P(Sliding, BoxStopsInsideAStep)
{
    for (const int count : {1, 12}) {
        Model model = make_model(GetParam(), stone(), dry(std::atan(0.3) / degrees));
        hold(model, add_box(model, "floor", {-1, -1, -1}, {30, 1, 0}));
        for (int i = 0; i < count; ++i)
            add_box(model, std::to_string(i), {2.0 * i, -0.5, 0}, {2.0 * i + 1, 0.5, 0.3});
        State state = initial_state(model);
        ASSERT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
        for (int i = 1; i <= count; ++i) set_velocity(model, state, i, {1, 0, 0});
        begin_stage(model, 0, state);
        const double x0 = centroid(model, state, 1).x();
        Stage motion = dynamic_stage(0.5, 1e-2);
        motion.control.force_tolerance = 1e-8;  // the energy is balanced to that
        const RunReport report = run_quietly(model, {motion}, state);
        const double exact = 1 / (2 * 0.3 * gravity);
        const double error = std::abs(centroid(model, state, 1).x() - x0 - exact) / exact;
        const double speed = velocity_of(model.kinematics, state, 1).norm();
        std::printf("stopping box, 1 of %d, 10 ms: relative error %.1e, speed left %.1e m/s\n", count, error,
                    speed);
        EXPECT_EQ(state.stage_time, 0.5);
        EXPECT_LT(report.energy.relative_residual(), 1e-6);
        EXPECT_EQ(report.divided_steps, 0);
        EXPECT_LT(error, 1e-3);
        EXPECT_LT(speed, 1e-3);
    }
}

// Drawn back and forth by its floor a box turns round inside steps. Against the same block of Coulomb's friction
// alone, its speed following the floor's by at most mu g dt. The error depends on where in the steps it turns
// round: means of six of them, whose ratio is 5.
TEST_P(Sliding, TurningRoundInsideAStepIsBetterThanFirstOrder)
{
    constexpr double friction = 0.3, interval = 0.05;
    const auto floor = std::make_shared<const GroundMotion>(GroundMotion::sine_acceleration(12, 2, 0.4, 10));
    std::vector<double> exact{0};
    constexpr double dt = 1e-6;
    constexpr int parts = 50000;  // of the interval
    double x = 0, v = 0;
    for (int i = 1; i <= 30 * parts; ++i) {
        const double lag = floor->velocity(i * dt) - v, change = friction * gravity * dt;
        const double next = v + std::clamp(lag, -change, change);
        x += 0.5 * dt * (v + next);
        v = next;
        if (i % parts == 0) exact.push_back(x);
    }
    const auto error = [&](double h) {
        const Model model = block_on_plane(GetParam(), std::atan(friction) / degrees);
        State state = initial_state(model);
        Stage stage = dynamic_stage(1.5, h);
        stage.motions = {{0, 0, floor}};
        const double start = centroid(model, state, 1).x();
        double worst = 0;
        RunObserver observer;
        observer.every = interval;
        observer.frame = [&](const State& now, const RunReport&) {
            const auto i = static_cast<std::size_t>(std::lround(now.stage_time / interval));
            if (now.stage == 1)
                worst = std::max(worst, std::abs(centroid(model, now, 1).x() - start - exact.at(i)));
        };
        run(model, {static_stage(0.1), stage}, state, observer);
        return worst;
    };
    double coarse = 0, fine = 0;
    for (const double part : {4, 5, 6, 7, 8, 9}) {
        coarse += error(interval / part) / 6;
        fine += error(interval / (5 * part)) / 6;
    }
    std::printf("turning round: %.2e m at 6 to 12 ms, %.2e m at 1 to 2.5 ms\n", coarse, fine);
    EXPECT_LT(coarse, 5e-4);
    EXPECT_LT(fine, coarse / 8);
}

}  // namespace voussoir::testing
