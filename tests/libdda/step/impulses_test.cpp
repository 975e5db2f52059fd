// Impulses: how much of a blow is passed on through a pile.
#include <gtest/gtest.h>

#include <cstdio>

#include "libdda/contact/find_contacts.h"
#include "libdda/step/landing.h"
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

    FallingPile(Kinematics kinematics, int courses)
    {
        constexpr double side = 0.4, overlap = 1e-6, gap = 0.5 * h * speed;
        model = make_model(kinematics, stone(), dry(30));
        hold(model, add_box(model, "floor", {-1, -1, -1}, {1, 1, 0}));
        for (int i = 0; i < courses; ++i) {
            const double foot = gap + i * (side - overlap);
            add_box(model, std::to_string(i), {-side / 2, -side / 2, foot}, {side / 2, side / 2, foot + side});
        }
        state = initial_state(model);
        for (int i = 1; i <= courses; ++i) set_velocity(model, state, i, {0, 0, -speed});
    }

    /// The jumps of the step to come.
    template <class K>
    std::vector<step::Jump<K>> jumps() const
    {
        std::vector<contact::PlacedPartIn<K::dimension>> parts;
        ContactSetIn<K::dimension> contacts;
        contact::find_contacts(model, state, std::vector<double>(model.blocks.size(), 5e-3), 1, parts, contacts);
        const Stage stage = dynamic_stage(1, h);
        return step::Landings<K>(model, stage, state, contacts, h).find();
    }
};

/// Kinetic energy that jumps leave to a falling pile / what it had.
template <class K>
double left_after_landing(Kinematics kinematics, int courses)
{
    const FallingPile pile(kinematics, courses);
    double left = 0;
    int stopped = 0;
    for (const step::Jump<K>& jump : pile.jumps<K>()) {
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

}  // namespace

}  // namespace voussoir::testing
