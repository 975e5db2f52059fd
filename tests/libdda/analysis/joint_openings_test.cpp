// Which blocks make a joint, and how far it has opened and slid since the start.
#include <gtest/gtest.h>

#include "libdda/analysis/joint_openings.h"
#include "libdda/analysis/joints_now.h"
#include "libdda/contact/initial_contacts.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// From x to z.
Matrix3d tilted(double angle)
{
    return turned(angle, {0, -1, 0});
}

/// A stone 1 m wide and 0.4 m high on a floor, and both put elsewhere.
class JointOpenings : public ::testing::TestWithParam<Kinematics>
{
 protected:
    JointOpenings()
    {
        model_ = make_model(GetParam(), stone(), dry(30));
        hold(model_, add_box(model_, "floor", {-2, -2, -1}, {2, 2, 0}));
        add_box(model_, "stone", {-0.5, -0.5, 0}, {0.5, 0.5, 0.4});
        start_ = initial_state(model_);
    }

    /// The stone's centre moved, tilted about it, and the whole tilted about the origin.
    State placed(const Vector3d& move, double angle, double angle_of_all = 0) const
    {
        State now = initial_state(model_);
        const Matrix3d all = tilted(angle_of_all);
        set_pose(model_, now, 0, all * Vector3d(0, 0, -0.5), all);
        set_pose(model_, now, 1, all * (Vector3d(0, 0, 0.2) + move), all * tilted(angle));
        return now;
    }
    /// Turned about the edge at x = 0.5, z = 0, which slides by as much.
    State rocked(double angle, double slide = 0, double angle_of_all = 0) const
    {
        const Vector3d hinge(0.5, 0, 0), arm(-0.5, 0, 0.2);
        return placed(hinge + Vector3d(slide, 0, 0) + tilted(-angle) * arm - Vector3d(0, 0, 0.2), -angle,
                      angle_of_all);
    }
    JointMotion motion(const State& now) const
    {
        return motion_of(joints_at_start(model_, start_).at(0), placed_blocks(model_, now));
    }
    double width() const { return is_planar(GetParam()) ? model_.thickness : 1; }

    Model model_;
    State start_;
};
INSTANTIATE_TEST_SUITE_P(Kinematics, JointOpenings, every_kinematics(), test_name);

}  // namespace

TEST_P(JointOpenings, AJointIsThePairThatTouches)
{
    const std::vector<WatchedJoint> joints = joints_at_start(model_, start_);
    ASSERT_EQ(joints.size(), 1u);
    EXPECT_EQ(joints[0].block_a, 0);
    EXPECT_EQ(joints[0].block_b, 1);
    EXPECT_NEAR(joints[0].area, width(), 1e-12);
    EXPECT_NEAR(joints[0].facing_area, width(), 1e-12);
    EXPECT_NEAR((joints[0].centre - Vector3d::Zero()).norm(), 0, 1e-12);
    EXPECT_NEAR(joints[0].normal.z(), -1, 1e-12);
    EXPECT_FALSE(joints[0].bonded);
    EXPECT_NEAR(motion(start_).opening, 0, 1e-12);
    EXPECT_NEAR(motion(start_).largest_slip, 0, 1e-12);
}

TEST_P(JointOpenings, LiftingOpensAndSlidingSlips)
{
    for (const double lift : {0.003, 1.0}) {
        EXPECT_NEAR(motion(placed({0, 0, lift}, 0)).opening, lift, 1e-12);
        EXPECT_NEAR(motion(placed({0, 0, lift}, 0)).mean_opening, lift, 1e-12);
        EXPECT_NEAR(motion(placed({0, 0, lift}, 0)).slip, 0, 1e-12);
    }
    const JointMotion slid = motion(placed({0.2, 0, 0}, 0));
    EXPECT_NEAR(slid.opening, 0, 1e-12);
    EXPECT_NEAR(slid.slip, 0.2, 1e-12);
    EXPECT_NEAR(slid.largest_slip, 0.2, 1e-12);
    const JointMotion pressed = motion(placed({0, 0, -0.001}, 0));
    EXPECT_EQ(pressed.opening, 0);
    EXPECT_NEAR(pressed.mean_opening, -0.001, 1e-12);
}

// A chord of the arc that the far corner describes, half of it in the mean; nothing slides at a hinge.
TEST_P(JointOpenings, RockingAboutAnEdgeOpensByTheChordAndDoesNotSlip)
{
    for (const double angle : {1e-3, 0.3, 1.2}) {
        const JointMotion rocking = motion(rocked(angle));
        EXPECT_NEAR(rocking.opening, 2 * std::sin(angle / 2), 1e-12);
        EXPECT_NEAR(rocking.mean_opening, std::sin(angle / 2), 1e-12);
        EXPECT_NEAR(rocking.largest_slip, 0, 1e-12);
    }
}

TEST_P(JointOpenings, RockingAndSlidingDoNotMix)
{
    const double angle = 0.2,
                 slide = 0.01;  // along the floor: off the bisector of the two faces by half the angle
    const JointMotion both = motion(rocked(angle, slide));
    EXPECT_NEAR(both.slip, slide * std::cos(angle / 2), 1e-12);
    EXPECT_NEAR(both.opening, 2 * std::sin(angle / 2) + slide * std::sin(angle / 2), 1e-12);
}

TEST_P(JointOpenings, DoNotDependOnWhereTheWholeStands)
{
    const JointMotion here = motion(rocked(0.1, 0.02)), there = motion(rocked(0.1, 0.02, 1));
    EXPECT_GT(here.opening, 0.05);
    EXPECT_NEAR(there.opening, here.opening, 1e-12);
    EXPECT_NEAR(there.mean_opening, here.mean_opening, 1e-12);
    EXPECT_NEAR(there.largest_slip, here.largest_slip, 1e-12);
}

// What is drawn apart or into one another at the start is the zero, flat or as a wedge.
TEST_P(JointOpenings, AreRelativeToTheStart)
{
    for (const double gap : {5e-4, -5e-4})
        for (const double wedge : {0.0, 3e-4}) {
            start_ = placed({0, 0, gap}, wedge);
            EXPECT_NEAR(motion(start_).opening, 0, 1e-12);
            EXPECT_NEAR(motion(start_).mean_opening, 0, 1e-12);
            EXPECT_NEAR(motion(start_).largest_slip, 0, 1e-12);
            EXPECT_NEAR(motion(placed({0, 0, gap + 2e-3}, wedge)).opening, 2e-3, 1e-9);
            EXPECT_NEAR(motion(placed({1e-3, 0, gap}, wedge)).slip, 1e-3, 1e-9);
        }
}

// A stone drawn on its edge touches as far as the wedge under it is thinner than the touching distance. Its far
// corner is 7 cm above the floor and no part of the joint.
TEST_P(JointOpenings, FacesThatGapeTouchNearTheirEdgeOnly)
{
    const double angle = 0.07;
    start_ = rocked(angle);
    const std::vector<WatchedJoint> joints = joints_at_start(model_, start_);
    ASSERT_EQ(joints.size(), 1u);
    const double touching = touching_distance(model_, 0, 1) / std::sin(angle);
    const double seen = is_planar(GetParam()) ? 1 : std::cos(angle);  // polygons are measured on the floor
    EXPECT_NEAR(joints[0].area, seen * width(), 1e-9);
    EXPECT_NEAR(joints[0].facing_area, seen * touching * width(), 1e-9);
    EXPECT_NEAR(motion(start_).opening, 0, 1e-12);
    const JointMotion further = motion(rocked(angle + 1e-3));
    EXPECT_NEAR(further.opening, 1e-3 * touching, 1e-6 * touching);
    EXPECT_NEAR(further.mean_opening, further.opening / 2, 1e-9);
}

TEST_P(JointOpenings, ACornerOnAFaceIsNoJoint)
{
    start_ = rocked(45 * degrees);
    State touching = start_;
    find_initial_contacts(model_, touching);
    EXPECT_EQ(touching.contacts.patches.size() + touching.planar_contacts.patches.size(), 1u);
    EXPECT_TRUE(joints_at_start(model_, start_).empty());
}

// A part of the stone that rises from the edge of its bed at 45 degrees meets the floor in that edge: its face
// gapes by 0.4 m from the start, and is no part of the joint.
TEST(JointOpeningsOfParts, AFaceThatLeansAwayIsNoPartOfTheJoint)
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    hold(model, add_box(model, "floor", {-2, -2, -1}, {2, 2, 0}));
    const ConvexPolyhedron flare = make_convex_polyhedron(
        {{0.5, -0.5, 0}, {0.5, -0.5, 0.4}, {0.9, -0.5, 0.4}, {0.5, 0.5, 0}, {0.5, 0.5, 0.4}, {0.9, 0.5, 0.4}},
        {{0, 2, 1}, {3, 4, 5}, {0, 3, 5, 2}, {1, 2, 5, 4}, {0, 1, 4, 3}});
    model.blocks.push_back(make_block("stone", 0, 0, {make_box({-0.5, -0.5, 0}, {0.5, 0.5, 0.4}), flare}));
    State state = initial_state(model);
    find_initial_contacts(model, state);
    ASSERT_EQ(state.contacts.patches.size(), 2u) << "both parts touch the floor";
    EXPECT_NEAR(joint_resultants(model, state).at(0).widest_gap, 0.4, 1e-9);
    const WatchedJoint joint = joints_at_start(model, state).at(0);
    EXPECT_NEAR(joint.area, 1, 1e-9);
    EXPECT_NEAR(joint.facing_area, 1, 1e-9);
    EXPECT_NEAR(motion_of(joint, placed_blocks(model, state)).opening, 0, 1e-12);
}

TEST_P(JointOpenings, StonesApartAndStonesHeldHaveNoJoint)
{
    EXPECT_TRUE(joints_at_start(model_, placed({0, 0, 0.01}, 0)).empty());
    hold(model_, 1);
    EXPECT_TRUE(joints_at_start(model_, start_).empty());
    model_.foundations.back().translation_held[0] = false;
    EXPECT_EQ(joints_at_start(model_, start_).size(), 1u) << "it may slide";
}

TEST_P(JointOpenings, HalfOnIsHalfAJoint)
{
    start_ = placed({2, 0, 0}, 0);  // from 1.5 to 2.5 on a floor that ends at 2
    const WatchedJoint joint = joints_at_start(model_, start_).at(0);
    EXPECT_NEAR(joint.facing_area, 0.5 * width(), 1e-12);
    EXPECT_NEAR(joint.centre.x(), 1.75, 1e-12);
    State now = placed({2, 0, 0}, 0.01);  // about its middle, 0.2 m over the edge of the floor
    const JointMotion moved = motion(now);
    EXPECT_NEAR(moved.mean_opening, -0.25 * std::sin(0.01), 2e-5) << "the half that lies on goes down";
    EXPECT_LT(moved.opening, 2e-5);
}

TEST_P(JointOpenings, PeaksAndTheirFirstTimesAreKept)
{
    const std::vector<WatchedJoint> joints = joints_at_start(model_, start_);
    RunReport report;
    report.joints = no_peaks(joints);
    const auto look = [&](State state, double time) {
        state.time = time;
        note_joints(model_, joints, state, report);
    };
    look(start_, 0);
    look(placed({0, 0, 0.9e-4}, 0), 1);
    EXPECT_FALSE(report.joints[0].opened);
    look(placed({0.5e-4, 0, 2e-4}, 0), 2);
    look(placed({3e-4, 0, 0}, 0), 3);
    look(placed({2e-4, 0, 1.5e-4}, 0), 4);
    EXPECT_EQ(report.joints[0].opened, 2);
    EXPECT_EQ(report.joints[0].slid, 3);
    EXPECT_NEAR(report.joints[0].opening, 2e-4, 1e-12);
    EXPECT_NEAR(report.joints[0].slip, 3e-4, 1e-12);
}

// Let go upwards it rises by g t^2 / 2: 0.1 mm after 4.5 ms, so that it has opened at the end of the fifth step.
TEST_P(JointOpenings, ARunTellsWhenAJointFirstOpened)
{
    State state = start_;
    const RunReport report = run_quietly(model_, {dynamic_stage(0.02, 1e-3, {0, 0, gravity})}, state);
    ASSERT_EQ(report.joints.size(), 1u);
    ASSERT_TRUE(report.joints[0].opened);
    EXPECT_NEAR(*report.joints[0].opened, 5e-3, 1e-9);
    EXPECT_FALSE(report.joints[0].slid);
    EXPECT_NEAR(report.joints[0].opening, 0.5 * gravity * 0.02 * 0.02, 1e-9);
    EXPECT_EQ(report.joints[0].opening, motion(state).opening) << "it is still rising";
}

TEST_P(JointOpenings, AJointAtRestHasNotOpened)
{
    State state = start_;
    const RunReport report = run_quietly(model_, {static_stage(0.1)}, state);
    ASSERT_EQ(report.joints.size(), 1u);
    EXPECT_FALSE(report.joints[0].opened);
    EXPECT_EQ(report.joints[0].opening, 0);
}

// On a floor that slopes by 6 degrees: the weight meets it downhill of the middle by half the height times the
// slope.
TEST_P(JointOpenings, ForcesAreThoseOfTheWholeJoint)
{
    const double slope = 0.1;
    ASSERT_EQ(run_quietly(model_, {static_stage(0.1, {gravity * std::sin(slope), 0, -gravity * std::cos(slope)})},
                          start_)
                  .outcome,
              Outcome::completed);
    const std::vector<WatchedJoint> joints = joints_at_start(model_, initial_state(model_));
    const JointNow now = joints_now(model_, joints, start_, joint_resultants(model_, start_)).at(0);
    const double weight = model_.mass(1) * gravity;
    EXPECT_NEAR(now.normal_force, weight * std::cos(slope), 1e-4 * weight);
    EXPECT_NEAR(now.shear_force, weight * std::sin(slope), 1e-4 * weight);
    EXPECT_NEAR(now.eccentricity, 0.2 * std::tan(slope), 1e-4);
    EXPECT_NEAR(now.area_in_use, width(), 1e-6);
    EXPECT_LT(now.motion.opening, 1e-7) << "within the kern: by the bending of the stone, which is drawn straight";
    EXPECT_FALSE(now.broken);
}

TEST_P(JointOpenings, ABondThatIsLostIsBroken)
{
    for (const double strength : {1e3, 1e6}) {
        model_.joints[0].tensile_strength = strength;
        model_.joints[0].cohesion = 1e6;
        State state = initial_state(model_);
        const std::vector<WatchedJoint> joints = joints_at_start(model_, state);
        EXPECT_TRUE(joints.at(0).bonded);
        const auto broken = [&] {
            return joints_now(model_, joints, state, joint_resultants(model_, state)).at(0).broken;
        };
        EXPECT_FALSE(broken());
        Stage up = dynamic_stage(0.02, 1e-3, {0, 0, 3 * gravity});  // 29 kPa on the bed of 1 m2
        run_quietly(model_, {up}, state);
        EXPECT_EQ(broken(), strength < 1e4);
    }
}

}  // namespace voussoir::testing
