// Impulses: how much of a blow is passed on through a pile.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "libdda/contact/find_contacts.h"
#include "libdda/impact/landing.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

constexpr double speed = 0.5, h = 1e-3;  // m/s, s

/// A pile of cubes that comes down flat on a floor, closed joints between them.
struct FallingPile {
    Model model;
    State state;

    /// @param gap to the floor / way of a step; @param sideways speed [m/s]
    FallingPile(Kinematics kinematics, int courses, double ways = 0.5, double sideways = 0)
    {
        constexpr double side = 0.4, overlap = 1e-6;
        const double gap = ways * h * speed;
        model = make_model(kinematics, stone(), dry(30));
        hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
        for (int i = 0; i < courses; ++i) {
            const double foot = gap + i * (side - overlap);
            add_box(model, std::to_string(i), {-side / 2, -side / 2, foot}, {side / 2, side / 2, foot + side});
        }
        state = initial_state(model);
        for (int i = 1; i <= courses; ++i) set_velocity(model, state, i, {sideways, 0, -speed});
    }

    /// The jumps of the step to come. @param missed whether what touches the floor lands though it does not reach
    /// it
    template <class K>
    std::vector<step::Jump<K>> jumps(bool missed = false) const
    {
        contact::SearchMemory<K::dimension> search;
        ContactSetIn<K::dimension> contacts;
        contact::find_contacts(model, state, std::vector<double>(model.blocks.size(), 5e-3), 1, search, contacts);
        const Stage stage = dynamic_stage(1, h);
        step::Landings<K> landings(model, stage, state, contacts, h);
        std::vector<step::Jump<K>> found = landings.find();
        if (!missed) return found;
        EXPECT_TRUE(found.empty());
        std::vector<step::ClosingPoint> closing;
        for (std::size_t k = 0; k < contacts.patches.size(); ++k)
            for (int i = contacts.patches[k].first_point; i < end_of_corners(contacts, contacts.patches[k]); ++i)
                if (contacts.points[i].gap > 0) closing.push_back({i, static_cast<int>(k)});
        return landings.find_also(closing);
    }
};

/// Kinetic energy that jumps leave to a pile that fell flat / what it had.
template <class K>
double left_after_landing(Kinematics kinematics, int courses, double ways = 0.5)
{
    const FallingPile pile(kinematics, courses, ways);
    double left = 0;
    int stopped = 0;
    for (const step::Jump<K>& jump : pile.jumps<K>(ways > 1)) {
        typename K::Vector after = jump.velocity;
        after[K::dimension - 1] -= speed;
        left += after.squaredNorm() / (speed * speed * courses);
        ++stopped;
    }
    return left + static_cast<double>(courses - stopped) / courses;
}

// Sweeps pass the blow on course by course, and n courses need some n^2 of them: alone they would leave 0.57.
TEST(Impulses, NearlyStopAPileOfManyCourses)
{
    const double left = left_after_landing<step::SpatialRigid>(Kinematics::spatial_rigid, 26);
    std::printf("of 26 courses %.4f is left\n", left);
    EXPECT_LT(left, 0.15);
}

TEST(Impulses, StopAPileOfFewCourses)
{
    EXPECT_LT(left_after_landing<step::SpatialRigid>(Kinematics::spatial_rigid, 8), 5e-4);
    EXPECT_LT(left_after_landing<step::PlanarRigid>(Kinematics::planar_rigid, 8), 5e-4);
}

// Straight flight takes it half the way to the floor.
TEST(Impulses, StopWhatOnlyTheStepBringsDown)
{
    EXPECT_LT(left_after_landing<step::SpatialRigid>(Kinematics::spatial_rigid, 8, 2), 5e-4);
    EXPECT_LT(left_after_landing<step::PlanarRigid>(Kinematics::planar_rigid, 8, 2), 5e-4);
}

// A pile that comes down askew: no more is rubbed than is pressed times the friction, and no energy comes of it.
TEST(Impulses, RubWithinTheConeOfFriction)
{
    constexpr int courses = 26;
    constexpr double sideways = 5;  // m/s, too fast for it to stick
    const FallingPile pile(Kinematics::spatial_rigid, courses, 0.5, sideways);
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
    double gained = 0;  // J
    for (const step::Jump<step::SpatialRigid>& jump : pile.jumps<step::SpatialRigid>()) {
        const Eigen::Vector3d before(sideways, 0, -speed), after = before + jump.velocity;
        impulse += pile.model.mass(jump.block) * jump.velocity;
        gained += 0.5 * pile.model.mass(jump.block) * (after.squaredNorm() - before.squaredNorm());
    }
    EXPECT_GT(impulse.z(), 0.3 * pile.model.mass(1) * courses * speed);
    EXPECT_LT(impulse.x(), -0.9 * std::tan(30 * degrees) * impulse.z());
    EXPECT_GT(impulse.x(), -1.0001 * std::tan(30 * degrees) * impulse.z());
    EXPECT_LT(gained, 0);
}

}  // namespace

}  // namespace voussoir::testing
