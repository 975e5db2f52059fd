// A step after which to go on would be nonsense is not kept: it is made again, shorter, before a run gives up.
#include "libdda/run/progress.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

using Eigen::Vector3d;

namespace
{

/// With its corners on the axes.
ConvexPolyhedron octahedron(const Vector3d& centre, double radius)
{
    std::vector<Vector3d> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {radius, -radius}) corners.emplace_back(centre + side * Vector3d::Unit(axis));
    std::vector<std::vector<int>> faces;
    for (const int x : {0, 1})
        for (const int y : {2, 3})
            for (const int z : {4, 5})
                faces.push_back((x + y + z) % 2 == 0 ? std::vector{x, y, z} : std::vector{x, z, y});
    return make_convex_polyhedron(std::move(corners), std::move(faces), "octahedron");
}

/// One corner dropped exactly on another: contacts that have no area yet grow under compression.
Model corner_on_corner()
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(26));
    model.blocks.push_back(make_block("below", 0, 0, {octahedron({0, 0, 0.3}, 0.3)}));
    model.blocks.push_back(make_block("above", 0, 0, {octahedron({0, 0, 1.3}, 0.5)}));
    hold(model, 0);
    return model;
}

/// A long bar that falls on the ground and spins so fast that it sweeps through it in a step.
Model spinning_bar()
{
    Model model = make_model(Kinematics::spatial_rigid, stone(), dry(30));
    hold(model, add_box(model, "ground", {-5, -5, -1}, {5, 5, 0}));
    add_box(model, "bar", {-1, -0.05, 0.95}, {1, 0.05, 1.05});
    return model;
}

}  // namespace

TEST(Progress, UnsoundStepIsToldAndNotKept)
{
    const Model model = corner_on_corner();
    State state = initial_state(model);
    const RunReport report = run_quietly(model, {dynamic_stage(0.5, 1e-3)}, state);
    ASSERT_EQ(report.outcome, Outcome::gave_up);
    ASSERT_TRUE(report.diagnosis);
    EXPECT_EQ(report.diagnosis->kind, DiagnosisKind::energy_from_contacts);
    // What it keeps is sound, and what it tells is of the step that it took back.
    EXPECT_LT(report.energy.peak_given / report.energy.scale(), 0.1);
    EXPECT_GT(report.diagnosis->values.back(), 0.1);
}

TEST(Progress, UnsoundStepIsMadeAgainShorter)
{
    const Model model = spinning_bar();
    for (const double spin : {100.0, 200.0, 400.0})
        for (const double h : {2e-3, 5e-3, 1e-2}) {
            State state = initial_state(model);
            set_velocity(model, state, 1, {0, 0, -5}, {0, spin, 0.1 * spin});
            const RunReport report = run_quietly(model, {dynamic_stage(0.3, h)}, state);
            EXPECT_NE(report.outcome, Outcome::gave_up) << spin << " rad/s, " << h << " s";
        }
}

}  // namespace voussoir::testing
