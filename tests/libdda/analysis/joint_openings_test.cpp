// How far joints are open, also those whose blocks no longer touch.
#include <gtest/gtest.h>

#include "libdda/analysis/joint_openings.h"
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
        state_ = initial_state(model_);
        find_initial_contacts(model_, state_);
        joints_ = joints_of(model_, state_);
    }

    /// Moves and tilts the stone, then tilts the whole about the origin.
    double opening_after(const Vector3d& move, double angle, double angle_of_all = 0) const
    {
        State now = initial_state(model_);
        const Matrix3d all = tilted(angle_of_all);
        set_pose(model_, now, 0, all * centroid(model_, state_, 0), all);
        set_pose(model_, now, 1, all * (centroid(model_, state_, 1) + move), all * tilted(angle));
        return opening_of(joints_.front(), model_, now);
    }

    Model model_;
    State state_;
    std::vector<WatchedJoint> joints_;
};
INSTANTIATE_TEST_SUITE_P(Kinematics, JointOpenings, every_kinematics(), test_name);

}  // namespace

TEST_P(JointOpenings, AClosedJointIsOpenByNothing)
{
    ASSERT_EQ(joints_.size(), 1u);
    EXPECT_EQ(joints_[0].block_a, 0);
    EXPECT_EQ(joints_[0].block_b, 1);
    EXPECT_NEAR(opening_of(joints_[0], model_, state_), 0, 1e-12);
}

TEST_P(JointOpenings, LiftingOpensAndSlidingDoesNot)
{
    EXPECT_NEAR(opening_after({0, 0, 0.003}, 0), 0.003, 1e-12);
    EXPECT_NEAR(opening_after({0, 0, 1}, 0), 1, 1e-12);
    EXPECT_NEAR(opening_after({0.2, 0, 0}, 0), 0, 1e-12);
    EXPECT_NEAR(opening_after({0, 0, -0.001}, 0), -0.001, 1e-12);
}

// About its centroid, 0.2 m above the joint, the far corner rises by b sin a + h (1 - cos a) along the floor's
// normal; along the stone's by the same but for a^2 b.
TEST_P(JointOpenings, RockingOpensByTheRiseOfTheCorner)
{
    const double angle = 0.01;
    const double rise = 0.5 * std::sin(angle) + 0.2 * (1 - std::cos(angle));
    EXPECT_NEAR(opening_after({0, 0, 0}, angle), rise, 0.5 * angle * angle);
    EXPECT_NEAR(opening_after({0, 0, 0}, -angle), rise, 0.5 * angle * angle);
}

TEST_P(JointOpenings, DoNotDependOnWhereTheWholeStands)
{
    const double apart = opening_after({0.01, 0, 0.02}, 0.1);
    EXPECT_GT(apart, 0.05);
    EXPECT_NEAR(opening_after({0.01, 0, 0.02}, 0.1, 1), apart, 1e-12);
}

}  // namespace voussoir::testing
