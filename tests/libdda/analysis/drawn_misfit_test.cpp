// How well stones fit as drawn, measured: joints count, wedges and mistakes do not.
#include "libdda/analysis/drawn_misfit.h"

#include <gtest/gtest.h>

#include "libdda/analysis/diagnosis.h"
#include "libdda/analysis/overlaps.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

using Eigen::Vector3d;

namespace
{

class Misfitting : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Misfitting, every_kinematics(), test_name);

/// A stone of 1 m on the ground and one on it, a joint's width [m] above.
Model two_stones(Kinematics kinematics, double joint)
{
    Model model = make_model(kinematics, stone(), dry(30));
    hold(model, add_box(model, "ground", {-2, -2, -1}, {2, 2, 0}));
    add_box(model, "lower", {-0.5, -0.5, 0}, {0.5, 0.5, 1});
    add_box(model, "upper", {-0.5, -0.5, 1 + joint}, {0.5, 0.5, 2 + joint});
    return model;
}

}  // namespace

TEST_P(Misfitting, IsTheLargestOverlapOrGapOfAJoint)
{
    for (const double joint : {-8.31e-3, -1e-4, 1e-4, 1.5e-3}) {
        const DrawnMisfit misfit = drawn_misfit(two_stones(GetParam(), joint));
        const Misfit& there = joint < 0 ? misfit.overlap : misfit.gap;
        const Misfit& other = joint < 0 ? misfit.gap : misfit.overlap;
        EXPECT_NEAR(there.depth, std::abs(joint), 1e-12);
        EXPECT_EQ(there.block_a, 1);
        EXPECT_EQ(there.block_b, 2);
        EXPECT_EQ(other.depth, 0);
        EXPECT_GE(misfit.tolerance(), there.depth);
        EXPECT_LE(misfit.tolerance(), 1.1 * there.depth);
    }
    EXPECT_NEAR(drawn_misfit(two_stones(GetParam(), -8.31e-3)).tolerance(), 8.4e-3, 1e-12);
}

TEST_P(Misfitting, IsNoneWhereJointsFitOrAreNone)
{
    for (const double joint : {0.0, 1e-7, -1e-7, 5e-3, -0.02}) {
        const DrawnMisfit misfit = drawn_misfit(two_stones(GetParam(), joint));
        EXPECT_EQ(misfit.tolerance(), 0) << joint;
        EXPECT_EQ(misfit.overlap.block_a, -1);
    }
}

// Two faces at an angle touch along an edge: how far they gape elsewhere is geometry.
TEST_P(Misfitting, IsNoWedge)
{
    Model model = two_stones(GetParam(), 0);
    State state = initial_state(model);
    const double angle = 0.05;
    Block& upper = model.blocks[2];
    for (ConvexPolyhedron& part : upper.parts)
        for (Vector3d& x : part.vertices) x = turned(angle, Vector3d::UnitY()) * x;
    for (ConvexPolygon& outline : upper.outlines)
        for (Eigen::Vector2d& x : outline.vertices)
            x = from_space<2>(Eigen::Matrix3d(turned(angle, Vector3d::UnitY()))) * x;
    upper.moments.centroid.z() += 0.5 * (std::cos(angle) - 1) + 0.5 * std::sin(angle);
    EXPECT_EQ(drawn_misfit(model).tolerance(), 0);
}

// A model is judged before its first step as it would be after it.
TEST_P(Misfitting, BeyondATenthOfTheWidthNoRunBegins)
{
    for (const double fit : {0.0, 0.01})
        for (const double overlap : {0.09, 0.105, 0.115}) {
            Model model = two_stones(GetParam(), -overlap);
            model.fit_tolerance = fit;
            const std::vector<DrawnOverlap> overlaps = drawn_overlaps(OverlapWatch(model));
            ASSERT_EQ(overlaps.size(), 1);
            EXPECT_NEAR(overlaps[0].depth, overlap - fit, 1e-12);
            EXPECT_NEAR(overlaps[0].share, overlap - fit, 1e-12);
            const std::optional<Diagnosis> wrong = start_diagnosis(overlaps);
            EXPECT_EQ(wrong.has_value(), overlap - fit > 0.1);
            State state = initial_state(model);
            const std::uint64_t before = hash_of(state);
            const RunReport report = run_quietly(model, {static_stage(0.01)}, state);
            EXPECT_EQ(report.outcome == Outcome::gave_up, wrong.has_value());
            if (!wrong) continue;
            ASSERT_TRUE(report.diagnosis);
            EXPECT_EQ(*report.diagnosis, *wrong);
            EXPECT_EQ(report.diagnosis->blocks, (std::vector{1, 2}));
            EXPECT_NEAR(value_of(*report.diagnosis, "drawn_m"), overlap - fit, 1e-12);
            EXPECT_EQ(report.steps, 0);
            EXPECT_EQ(hash_of(state), before);
        }
}

// 2500 g h / k is what a stone of the height h settles by under its own weight, and the lower of two by twice
// that.
TEST_P(Misfitting, SoftStonesAreToldBeforeTheySink)
{
    for (const FaceLaw face : {FaceLaw::corners, FaceLaw::points})
        for (const double k : {2e5, 1.5e6, 2.5e6, 1e7}) {
            Model model = two_stones(GetParam(), 0);
            model.joints[0].face = face;
            const double softest = face == FaceLaw::corners ? 0.025 : 0.025 / 3;
            model.joints[0].stiffness = {ContactStiffness::Kind::per_area, k};
            const std::vector<SoftStone> soft = too_soft_stones(model, {0, 0, -gravity});
            const double due = 2500 * gravity * 1 / k;
            ASSERT_EQ(soft.size(), due > softest ? 2 : (2 * due > softest ? 1 : 0)) << k;
            if (soft.empty()) continue;
            EXPECT_EQ(soft.back().block, 1);
            EXPECT_NEAR(soft.back().depth, 2 * due, 1e-9);
            EXPECT_NEAR(soft.back().share, 2 * due, 1e-9);
            EXPECT_NEAR(soft.back().factor, 2 * due / softest, 1e-8);
            State state = initial_state(model);
            const RunReport report = run_quietly(model, {static_stage(0.01)}, state);
            EXPECT_EQ(report.outcome == Outcome::gave_up, 2 * due > 0.1) << "as was told";
            model.joints[0].stiffness.factor = 1.01 * soft.back().factor;
            EXPECT_TRUE(too_soft_stones(model, {0, 0, -gravity}).empty()) << "and the remedy is one";
            EXPECT_EQ(run_quietly(model, {static_stage(0.01)}, state = initial_state(model)).outcome,
                      Outcome::completed);
        }
}

// How a stone was cut into parts is no property of it.
TEST(Widths, OfAGluedStoneAreThoseOfTheStone)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    ConvexPolyhedron sliver = make_box({0, 0, 0}, {0.001, 1, 0.8}), rest = make_box({0.001, 0, 0}, {0.6, 1, 0.8});
    for (ConvexPolyhedron* part : {&sliver, &rest}) {
        part->glued.assign(part->faces.size(), false);
        for (int face = 0; face < static_cast<int>(part->faces.size()); ++face)
            part->glued[face] = face_normal(*part, face).x() * (part == &sliver ? 1 : -1) > 0.5;
    }
    model.blocks.push_back(make_block("stone", 0, 0, {sliver, rest}));
    EXPECT_NEAR(least_widths(model)[0], 0.6, 1e-12);
}

}  // namespace voussoir::testing
