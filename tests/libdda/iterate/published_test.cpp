// The published open-close iteration, kept for comparison with the papers.
#include <gtest/gtest.h>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

Stage published(Stage stage)
{
    stage.control.open_close = OpenClose::published;
    return stage;
}

/// Acceleration down a plane of 45 degrees with friction of 20.
constexpr double slope_acceleration()
{
    return gravity * 0.70710678118654752 * (1 - 0.36397023426620234);
}

class Published : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Published, spatial_kinematics(), test_name);

}  // namespace

TEST_P(Published, InclineIsWithinAFewPercent)
{
    const Model model = block_on_plane(GetParam(), 20);
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {published(dynamic_stage(1, 1e-3, inclined_gravity(45)))}, state);
    const double exact = 0.5 * slope_acceleration(), error = std::abs(centroid(model, state, 1).x() / exact - 1);
    std::printf("published, incline: relative error %.1e, %lld cuts\n", error,
                static_cast<long long>(report.step_cuts));
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_LT(error, 0.03);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// From rest under its own weight: dropped onto its contacts a deformable block slips by millimetres in this
// scheme.
TEST_P(Published, BlockThatMustStickSticks)
{
    for (const Integrator integrator : {Integrator::newmark, Integrator::energy_decaying}) {
        Model model = block_on_plane(GetParam(), 50);
        model.joints[0].face = FaceLaw::corners;  // it knows no stones that bend
        State state = initial_state(model);
        Stage stage = published(dynamic_stage(1, 1e-3, inclined_gravity(45)));
        stage.control.integrator = integrator;
        ASSERT_EQ(run_quietly(model, {static_stage(0.1, inclined_gravity(45))}, state).outcome,
                  Outcome::completed);
        begin_stage(model, 0, state);
        const Vector3d start = centroid(model, state, 1);
        EXPECT_EQ(run_quietly(model, {stage}, state).outcome, Outcome::completed);
        EXPECT_LT((centroid(model, state, 1) - start).norm(), 1e-6);
        EXPECT_LT(velocity_of(model.kinematics, state, 1).norm(), 1e-5);
    }
}

// Friction follows the normal force one pass behind, also while no state switches: gravity doubles on the way.
TEST_P(Published, FrictionFollowsTheNormalForce)
{
    const Model model = block_on_plane(GetParam(), 20);
    State state = initial_state(model);
    const RunReport report = run_quietly(model,
                                         {published(dynamic_stage(0.5, 1e-3, inclined_gravity(45))),
                                          published(dynamic_stage(0.5, 1e-3, 2 * inclined_gravity(45)))},
                                         state);
    const double a = slope_acceleration(), exact = a * (0.5 * 0.25 + 0.25 + 0.25);
    EXPECT_EQ(report.outcome, Outcome::completed);
    EXPECT_NEAR(centroid(model, state, 1).x(), exact, 0.03 * exact);
    EXPECT_LT(report.energy.relative_residual(), 1e-6);
}

// And it turns with the sliding: a block pushed sideways while it slides curves on.
TEST_P(Published, FrictionFollowsTheDirectionOfSliding)
{
    Vector3d place[2];
    for (const OpenClose scheme : {OpenClose::newton, OpenClose::published}) {
        const Model model = block_on_plane(GetParam(), 20);
        State state = initial_state(model);
        Stage first = dynamic_stage(0.3, 1e-3, inclined_gravity(45)), second = first;
        second.gravity = {0, gravity / std::numbers::sqrt2, -gravity / std::numbers::sqrt2};
        first.control.open_close = second.control.open_close = scheme;
        EXPECT_EQ(run_quietly(model, {first, second}, state).outcome, Outcome::completed);
        place[scheme == OpenClose::published] = centroid(model, state, 1);
    }
    EXPECT_GT(place[0].y(), 0.1);
    EXPECT_LT((place[1] - place[0]).norm(), 0.03 * place[0].norm());
}

}  // namespace voussoir::testing
