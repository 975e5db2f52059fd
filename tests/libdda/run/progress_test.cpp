// A step after which to go on would be nonsense is not kept.
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

}  // namespace voussoir::testing
