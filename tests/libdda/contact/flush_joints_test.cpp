// A stone that slides over the joints of a pavement: its contacts end, begin and turn to other faces all the time.
#include <gtest/gtest.h>

#include <cmath>

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
    Eigen::Vector3d end;  // m, centroid
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
    Slide result;
    result.report = run_quietly(model, {dynamic_stage(0.8, 1e-3)}, state);
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
        EXPECT_NEAR(paved.end.z(), smooth.end.z(), 1e-8) << stiffness;
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
