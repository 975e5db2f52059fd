// A stone that slides over the joints of a pavement: its contacts end, begin and turn to other faces all the time.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

class FlushJoints : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, FlushJoints, every_kinematics(), test_name);

struct Slide {
    Eigen::Vector3d end;     // m, centroid
    double mean_height = 0;  // m, of the centroid over the last 0.2 s, when it has come to rest
    RunReport report;
};

/// A stone with 2 m/s on a floor of `paving` stones 2 m long in all, until it has come to rest.
Slide slide_over(Kinematics kinematics, int paving, double stiffness)
{
    JointMaterial joint = dry(20);
    joint.stiffness = {ContactStiffness::Kind::per_area, stiffness};
    Model model = make_model(kinematics, stone(), joint);
    model.thickness = 0.7;  // of planar scenes: areas are lengths times this
    const int block = add_box(model, "stone", {0.013, -0.35, 0}, {0.513, 0.35, 0.3});
    const double length = 2.0 / paving;
    for (int i = 0; i < paving; ++i)
        hold(model, add_box(model, "floor", {i * length, -1, -0.3}, {(i + 1) * length, 1, 0}));
    State state = initial_state(model);
    run_quietly(model, {static_stage(1e-2)}, state);
    set_velocity(model, state, block, {2, 0, 0});
    state.stage_time = 0;
    state.grid = 0;
    const double start = state.time;
    Slide result;
    double from = 0, meant = 0;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport&, const RunReport&) {
        const double length = now.time - std::max(from, start + 0.6);
        from = now.time;
        if (length <= 0) return;
        // By how long a step is, and so that a part of a period at either end does not count.
        const double weight = length * std::pow(std::sin(std::numbers::pi * (now.time - start - 0.6) / 0.2), 2);
        meant += weight;
        result.mean_height += weight * centroid(model, now, block).z();
    };
    result.report = run(model, {dynamic_stage(0.8, 1e-3)}, state, observer);
    result.mean_height /= meant;
    result.end = centroid(model, state, block);
    return result;
}

}  // namespace

// 0.56 m, so that either end of the stone crosses eleven joints, 2 mm a step.
TEST_P(FlushJoints, OfAPavementNeitherHoldAStoneNorLetItSink)
{
    for (const double stiffness : {1e8, 1e10}) {
        const Slide smooth = slide_over(GetParam(), 1, stiffness), paved = slide_over(GetParam(), 40, stiffness);
        const double way = smooth.end.x() - 0.263, energy = smooth.report.energy.start_kinetic;
        EXPECT_NEAR(way, 2 * 2 / (2 * gravity * std::tan(20 * degrees)), 2e-3 * way) << stiffness;
        EXPECT_NEAR(paved.end.x(), smooth.end.x(), 5e-4 * way) << stiffness;
        // At rest it trembles on its springs, which almost nothing damps. Of its weight they yield by 2.5 t/m3 x
        // 0.3 m.
        const double yielding = 2500 * gravity * 0.3 / stiffness;
        EXPECT_NEAR(paved.mean_height, smooth.mean_height, 0.02 * yielding) << stiffness;
        EXPECT_NEAR(paved.report.energy.redetection, 0, 1e-3 * energy) << stiffness;
        EXPECT_GE(paved.report.energy.peak_given, -paved.report.energy.redetection) << stiffness;
        EXPECT_GT(paved.report.energy.peak_given, 0) << "contacts gave a little, and took it again";
        // On a strip of a side, which it finds first, it is 2 mm deep for a step, and is not said to be.
        EXPECT_LT(paved.report.deepest.depth, 4 * smooth.report.deepest.depth) << stiffness;
        EXPECT_EQ(paved.report.max_penetration, paved.report.deepest.depth) << stiffness;
        EXPECT_TRUE(paved.report.warnings.empty()) << stiffness << ::testing::PrintToString(paved.report.warnings);
    }
}

}  // namespace voussoir::testing
