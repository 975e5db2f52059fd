// A bonded wall that is held at its foot and at one end, tilted across its plane: its free part comes down as its
// beds twist. What it bears must not depend on how its beds are cut.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/libdda/scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

/// A brick of glued parts, so many along x and y: its bed is as many contacts.
Block cut_brick(const Vector3d& lower, const Vector3d& upper, int cuts)
{
    std::vector<ConvexPolyhedron> parts;
    const Vector3d size = upper - lower, step(size.x() / cuts, size.y() / cuts, size.z());
    for (int i = 0; i < cuts; ++i)
        for (int j = 0; j < cuts; ++j) {
            const Vector3d from = lower + Vector3d(i * step.x(), j * step.y(), 0);
            ConvexPolyhedron part = make_box(from, from + step);
            part.glued.assign(part.faces.size(), false);
            for (std::size_t face = 0; face < part.faces.size(); ++face) {
                Vector3d middle = Vector3d::Zero();
                for (const int vertex : part.faces[face])
                    middle += part.vertices[vertex] / part.faces[face].size();
                for (const int axis : {0, 1}) {
                    const bool at_side =
                        std::abs(middle[axis] - lower[axis]) < 1e-9 || std::abs(middle[axis] - upper[axis]) < 1e-9;
                    const bool across =
                        std::abs(std::abs(middle[axis] - from[axis] - 0.5 * step[axis]) - 0.5 * step[axis]) < 1e-9;
                    if (across && !at_side) part.glued[face] = true;
                }
            }
            parts.push_back(std::move(part));
        }
    return make_block("brick", 0, 0, std::move(parts));
}

/// 1.6 x 1.6 x 0.2 m, bricks of 40 x 20 x 20 cm; the first of each course is held.
Model bonded_wall(FaceLaw face, int cuts)
{
    constexpr double length = 1.6, brick = 0.4, side = 0.2;
    JointMaterial joint = dry(31);
    joint.face = face;
    joint.stiffness = {ContactStiffness::Kind::from_modulus, 300};
    Model model = make_model(Kinematics::spatial_rigid, {"brick", 2000, 1e10, 0.2}, joint);
    hold(model, add_box(model, "table", {-0.4, -0.6, -0.3}, {2, 0.8, 0}));
    for (int course = 0; course < 8; ++course)
        for (int i = 0; i < 5; ++i) {
            const double x = (i - 0.5 * (course % 2)) * brick;
            const double left = std::max(x, 0.0), right = std::min(x + brick, length);
            if (right - left < 1e-9) continue;
            model.blocks.push_back(cut_brick({left, 0, course * side}, {right, side, (course + 1) * side}, cuts));
            if (left == 0) hold(model, static_cast<int>(model.blocks.size()) - 1);
        }
    return model;
}

bool stands(FaceLaw face, int cuts, double tilt)
{
    const Model model = bonded_wall(face, cuts);
    State state = initial_state(model);
    const Vector3d tilted = gravity * Vector3d(0, std::sin(tilt * degrees), -std::cos(tilt * degrees));
    return run_quietly(model, {static_stage(1), static_stage(1, tilted)}, state).outcome == Outcome::completed;
}

}  // namespace

// Nine pads a bed, of which each has its own law, stand for a bed that is pressed as evenly as it can be: 0.250 g.
// A bed that has springs at its corners alone bears 0.314 g, 17.4 degrees.
TEST(TwistingWall, OfLinearFacesFallsAtOneTiltHoweverItsBedsAreCut)
{
    for (const int cuts : {1, 3}) {
        EXPECT_TRUE(stands(FaceLaw::linear, cuts, 13.8)) << cuts;
        EXPECT_FALSE(stands(FaceLaw::linear, cuts, 14.3)) << cuts;
    }
}

TEST(TwistingWall, OfPointsFallsWithinEightPerCentOfThat)
{
    EXPECT_TRUE(stands(FaceLaw::points, 1, 14.05));
    EXPECT_FALSE(stands(FaceLaw::points, 1, 15.2));
    EXPECT_TRUE(stands(FaceLaw::points, 3, 14.05));
    EXPECT_FALSE(stands(FaceLaw::points, 3, 14.9));
}

}  // namespace voussoir::testing
