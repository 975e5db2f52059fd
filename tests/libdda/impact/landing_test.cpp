// Landing: the restitution of a joint, and nothing else, decides how stones leave one another.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>

#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

class Landing : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Landing, every_kinematics(), test_name);

/// Ground that moves at one speed [m/s].
std::shared_ptr<const GroundMotion> steady(double speed)
{
    return std::make_shared<GroundMotion>(GroundMotion::from_velocity({speed, speed}, 10, "steady"));
}

/// A box that falls flat on a floor. @returns its highest rise after the first impact [m]
double rebound(Kinematics kinematics, std::optional<double> restitution, double stiffness_factor, double h,
               RunReport& report)
{
    JointMaterial joint = dry(30);
    joint.restitution = restitution;
    joint.stiffness.factor = stiffness_factor;
    Model model = make_model(kinematics, stone(), joint);
    hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
    const int box = add_box(model, "box", {-0.3, -0.3, 0.2}, {0.3, 0.3, 0.7});
    State state = initial_state(model);
    double highest = 0;
    bool has_landed = false;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const double height = centroid(model, now, box).z() - 0.25;
        has_landed = has_landed || (now.time > 0.15 && velocity_of(model.kinematics, now, box).z() > -1e-3);
        if (has_landed) highest = std::max(highest, height);
    };
    report = run(model, {dynamic_stage(0.5, h)}, state, observer);
    return highest;
}

/// A block 1 m wide and 3 m high that begins to rock with a lean of 0.1. @returns by how much each of the first
/// four impacts reduces the angular speed
std::vector<double> rocking_ratios(Kinematics kinematics, double h)
{
    constexpr double width = 1, height = 3, lean = 0.1;
    Model model = make_model(kinematics, stone(), dry(60));
    model.joints[0].face = FaceLaw::corners;  // on points its edge is softer, and it trembles on it
    hold(model, add_box(model, "floor", {-3, -1, -1}, {3, 1, 0}));
    const int block = add_box(model, "block", {-width / 2, -0.5, 0}, {width / 2, 0.5, height});
    State state = initial_state(model);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(lean, Eigen::Vector3d::UnitY()).toRotationMatrix();
    const Eigen::Vector3d corner(width / 2, 0, 0), middle(0, 0, height / 2);
    set_pose(model, state, block, corner + turn * (middle - corner), turn);
    const double radius = std::hypot(width, height) / 2, alpha = std::atan2(width, height);
    const auto rise = [&](double angle) { return radius * (std::cos(alpha - angle) - std::cos(alpha)); };
    std::vector<double> swings{lean};
    bool to_right = true;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const Eigen::Matrix3d map = pose_of(model.kinematics, now, block).map;
        const double angle = std::atan2(map(0, 2), map(2, 2));
        if (std::abs(angle) > 1e-6 && (angle > 0) != to_right) {
            to_right = angle > 0;
            swings.push_back(0);
        }
        swings.back() = std::max(swings.back(), std::abs(angle));
    };
    observer.stop = [&] { return swings.size() > 5; };
    run(model, {dynamic_stage(6, h)}, state, observer);
    std::vector<double> ratios;
    for (std::size_t i = 0; i + 1 < swings.size() && i < 4; ++i)
        ratios.push_back(std::sqrt(rise(swings[i + 1]) / rise(swings[i])));
    return ratios;
}

}  // namespace

// The height goes with the square of the restitution, whatever the step and the stiffness.
TEST_P(Landing, ABoxRisesByTheSquareOfTheRestitution)
{
    for (const double e : {0.0, 0.5, 1.0})
        for (const double factor : {0.01, 1.0})
            for (const double h : {2e-3, 3e-4}) {
                RunReport report;
                const double height = rebound(GetParam(), e, factor, h, report);
                std::printf("restitution %g, stiffness x %g, %g ms: %.4f m of 0.2 m\n", e, factor, 1e3 * h,
                            height);
                EXPECT_NEAR(height, 0.2 * e * e, 2e-3) << e << " " << factor << " " << h;
                EXPECT_LT(report.energy.relative_residual(), 1e-6);
            }
}

// What the impulses take is the kinetic energy of the fall, times 1 - e^2, and a term of its own.
TEST_P(Landing, TakesTheEnergyOfTheApproach)
{
    RunReport report;
    rebound(GetParam(), 0.0, 1, 1e-3, report);
    EXPECT_NEAR(report.energy.impact, report.energy.gravity_work, 0.02 * report.energy.gravity_work);
    rebound(GetParam(), std::nullopt, 1, 1e-3, report);
    EXPECT_EQ(report.energy.impact, 0);
}

// A base that moves pushes at its own speed: the blow takes what it takes in the base's own frame, and the ledger
// knows who gave it.
TEST_P(Landing, TakesOnAMovingBaseWhatItTakesInTheFrameOfTheBase)
{
    const Eigen::Vector3d along =
        is_planar(GetParam()) ? Eigen::Vector3d(0.4, 0, 0.6) : Eigen::Vector3d(0.4, -0.2, 0.6);
    double taken[2], work[2], mass = 0;
    for (const bool moves : {false, true}) {
        JointMaterial joint = dry(30);
        joint.restitution = 0.3;
        Model model = make_model(GetParam(), stone(), joint);
        hold(model, add_box(model, "base", {-2, -2, -1}, {2, 2, 0}));
        const int box = add_box(model, "box", {-0.3, -0.3, 0.1}, {0.3, 0.3, 0.6});
        const Eigen::Vector3d base = moves ? along : Eigen::Vector3d::Zero();
        Stage stage = dynamic_stage(0.2, 1e-3);
        for (int k = 0; k < 3; ++k)
            if (base[k] != 0) stage.motions.push_back({0, k, steady(base[k])});
        State state = initial_state(model);
        set_velocity(model, state, 0, base);
        set_velocity(model, state, box, base + Eigen::Vector3d(0.5, 0, -1));
        const RunReport report = run_quietly(model, {stage}, state);
        EXPECT_EQ(report.outcome, Outcome::completed);
        EXPECT_LT(report.energy.relative_residual(), 1e-6);
        taken[moves] = report.energy.impact;
        work[moves] = report.energy.foundation_work;
        mass = model.mass(box);
    }
    std::printf("impact %.4f and %.4f J, work of the base %.4f and %.4f J\n", taken[0], taken[1], work[0],
                work[1]);
    EXPECT_GT(taken[0], 0.3 * mass);
    EXPECT_NEAR(taken[1], taken[0], 1e-4 * taken[0]);
    EXPECT_EQ(work[0], 0);
    EXPECT_GT(work[1], 0.5 * mass * 0.6);
}

// A rocking block's edge lands without bouncing: Housner's ratio of angular speeds, 1 - 1.5 sin^2(alpha).
TEST_P(Landing, ARockingBlockFollowsHousner)
{
    const double exact = 1 - 1.5 * std::pow(std::sin(std::atan2(1, 3)), 2);
    for (const double h : {2e-3, 2e-4}) {
        const std::vector<double> ratios = rocking_ratios(GetParam(), h);
        ASSERT_EQ(ratios.size(), 4U);
        for (const double ratio : ratios) EXPECT_NEAR(ratio, exact, 0.01) << "at " << h << " s";
    }
}

// Bodies that meet head on in free flight exchange their momentum, spin or not, and lose none of it.
TEST_P(Landing, KeepsMomentumOfStonesInFlight)
{
    JointMaterial joint = dry(30);
    joint.restitution = 0.5;
    Model model = make_model(GetParam(), stone(), joint);
    add_box(model, "left", {-0.6, -0.25, 0}, {-0.1, 0.25, 0.5});
    add_box(model, "right", {0.1, -0.25, 0.1}, {0.7, 0.25, 0.7});
    State state = initial_state(model);
    set_velocity(model, state, 0, {2, 0, 0});
    set_velocity(model, state, 1, {-1, 0, 0.1});
    const auto momentum = [&](const State& now) {
        Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = Eigen::Vector3d::Zero();
        for (int b = 0; b < 2; ++b) {
            const Eigen::Vector3d p = model.mass(b) * velocity_of(model.kinematics, now, b);
            linear += p;
            angular += centroid(model, now, b).cross(p) + angular_momentum(model, now, b);
        }
        return std::make_pair(linear, angular);
    };
    const auto before = momentum(state);
    const RunReport report = run_quietly(model, {dynamic_stage(0.2, 1e-3, {0, 0, 0})}, state);
    const auto after = momentum(state);
    EXPECT_GT(report.energy.impact, 0);
    EXPECT_LT((after.first - before.first).norm(), 1e-9 * before.first.norm() + 1e-6);
    EXPECT_LT((after.second - before.second).norm(), 1e-6 * before.first.norm());
}

// A corner that meets a floor askew leaves it with the restitution of its approach, and rubs with all its
// friction: what friction turns is what presses, and one impulse must not be taken for both.
TEST_P(Landing, ACornerThatRubsLeavesWithTheRestitutionOfItsApproach)
{
    constexpr double e = 0.5;
    JointMaterial joint = dry(15);
    joint.restitution = e;
    Model model = make_model(GetParam(), stone(), joint);
    hold(model, add_box(model, "floor", {-2, -1, -1}, {2, 1, 0}));
    const int box = add_box(model, "box", {-0.2, -0.2, -0.2}, {0.2, 0.2, 0.2});
    for (const double side : {-1.0, 1.0}) {
        State state = initial_state(model);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.35, Eigen::Vector3d::UnitY()).toRotationMatrix();
        const Eigen::Vector3d lever = turn * Eigen::Vector3d(0.2, 0, -0.2), before(2 * side, 0, -1);
        set_pose(model, state, box, {0, 0, 0.01 - lever.z()}, turn);
        set_velocity(model, state, box, before);
        ASSERT_EQ(run_quietly(model, {dynamic_stage(0.03, 1e-3, {0, 0, 0})}, state).outcome, Outcome::completed);
        const Eigen::Vector3d after = velocity_of(model.kinematics, state, box), change = after - before;
        EXPECT_NEAR(change.x(), -side * std::tan(15 * degrees) * change.z(), 1e-4 * change.z());
        const Eigen::Vector3d spin =
            angular_momentum(model, state, box) / (model.mass(box) * 0.4 * 0.4 / 6);  // of a cube
        EXPECT_NEAR((after + spin.cross(lever)).z(), e, 1e-3);
    }
}

// Three quarters of what gravity makes in a step are fast enough for a landing: springs would return them.
TEST_P(Landing, MayBeSlowerThanGravityMakesAStoneInAStep)
{
    constexpr double h = 1e-3, speed = 0.75 * gravity * h;
    Model model = make_model(GetParam(), stone(), dry(30));
    hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
    const double gap = 0.2 * h * speed;
    const int box = add_box(model, "box", {-0.3, -0.3, gap}, {0.3, 0.3, gap + 0.5});
    State state = initial_state(model);
    set_velocity(model, state, box, {0, 0, -speed});
    double fastest = 0;  // upwards
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        fastest = std::max(fastest, velocity_of(model.kinematics, now, box).z());
    };
    const RunReport report = run(model, {dynamic_stage(0.01, h)}, state, observer);
    std::printf("rebounds with %.3f of %.3f mm/s\n", 1e3 * fastest, 1e3 * speed);
    EXPECT_LT(fastest, 0.25 * speed);  // a deformable stone goes on trembling
    EXPECT_GT(report.energy.impact, 0);
}

// A joint that stays closed loses nothing: a stack that trembles under its own weight has no impacts.
TEST_P(Landing, AJointThatStaysClosedLosesNothing)
{
    Model model = make_model(GetParam(), stone(), dry(40));
    hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
    for (int i = 0; i < 4; ++i)
        add_box(model, std::to_string(i), {-0.3, -0.3, 0.4 * i}, {0.3, 0.3, 0.4 * (i + 1)});
    State state = initial_state(model);
    ASSERT_EQ(run_quietly(model, {static_stage(0.1)}, state).outcome, Outcome::completed);
    for (int i = 1; i <= 4; ++i) set_velocity(model, state, i, {0, 0, -1e-5 * i});
    begin_stage(model, 0, state);
    const RunReport report = run_quietly(model, {dynamic_stage(0.2, 1e-3)}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_EQ(report.energy.impact, 0);
}

// A step in a pavement stops a stone if it is higher than what the stone's own bed yields; a lower one is none.
TEST_P(Landing, AStoneThatSlidesLandsOnAStepOfItsPavement)
{
    JointMaterial joint = dry(20);
    joint.stiffness = {ContactStiffness::Kind::per_area, 3e8};  // of its weight it yields by 0.02 mm
    // Of a rigid stone that goes on about its toe: the angular momentum about that stays.
    const double tipping = 0.75 * 0.15 * 0.15 / (0.2 * 0.2 + 0.15 * 0.15);
    for (const double step : {0.0, 1e-3}) {
        Model model = make_model(GetParam(), stone(), joint);
        const int block = add_box(model, "stone", {-0.5, -0.35, 0}, {-0.1, 0.35, 0.3});
        hold(model, add_box(model, "before", {-2, -1, -0.3}, {0, 1, 0}));
        hold(model, add_box(model, "behind", {0, -1, -0.3}, {2, 1, step}));
        State state = initial_state(model);
        run_quietly(model, {static_stage(1e-2)}, state);
        set_velocity(model, state, block, {2, 0, 0});
        begin_stage(model, 0, state);
        run_quietly(model, {dynamic_stage(0.06, 1e-3)}, state);
        const double speed = velocity_of(model.kinematics, state, block).x();
        if (step == 0)
            EXPECT_NEAR(speed, 2 - gravity * std::tan(20 * degrees) * 0.06, 2e-3);
        else
            EXPECT_NEAR(speed, tipping * std::sqrt(4 - 2 * gravity * std::tan(20 * degrees) * 0.1), 0.03);
    }
}

// A blow rubs with the coefficient of the speed at which it slides, which a step would use as well.
TEST_P(Landing, RubsWithTheFrictionOfItsSpeed)
{
    constexpr double fall = 0.05, speed = 2, slippery = 0.1 * degrees;
    JointMaterial joint = dry(30);
    joint.friction_at_speed = {{1e-3, slippery}};
    Model model = make_model(GetParam(), stone(), joint);
    hold(model, add_box(model, "floor", {-2, -2, -0.5}, {8, 2, 0}));
    const int box = add_box(model, "box", {-0.5, -0.5, fall}, {0.5, 0.5, fall + 0.2});
    model.initial_motions = {{box, {speed, 0, 0}, {0, 0, 0}}};
    State state = initial_state(model);
    const RunReport report = run(model, {dynamic_stage(0.15, 1e-3)}, state, {});
    const double mu = std::tan(slippery), landing = std::sqrt(2 * gravity * fall);
    const double weight_rubs = mu * gravity * (0.15 - landing / gravity);
    EXPECT_NEAR(velocity_of(GetParam(), state, box).x(), speed - mu * landing - weight_rubs, 1e-4);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// Ground that goes on for ever sideways does not turn, whatever lands on it and where.
TEST(LandingOnTiedSides, TurnsNothing)
{
    Model model = make_model(Kinematics::planar_deformable, stone(4.5e8), dry(30));
    hold(model, add_box(model, "rock", {0, 0, -4}, {4, 0, 0}));
    for (int layer = 0; layer < 3; ++layer)
        model.tied_sides.push_back(add_box(model, "soil", {0, 0, layer + 0.0}, {4, 0, layer + 1.0}));
    const int top = model.tied_sides.back();
    add_box(model, "stone", {2.9, 0, 3.2}, {3.9, 0, 4.2});
    State state = initial_state(model);
    double most_turned = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const Eigen::Matrix3d map = pose_of(model.kinematics, now, top).map;
        most_turned = std::max({most_turned, std::abs(map(2, 0)), std::abs(map(0, 0) - 1)});
    };
    const RunReport report = run(model, {dynamic_stage(0.3, 1e-3)}, state, observer);
    EXPECT_GT(report.energy.impact, 0);
    EXPECT_LT(most_turned, 1e-14);
    EXPECT_LT(report.energy.relative_residual(), 1e-5);
}

}  // namespace voussoir::testing
