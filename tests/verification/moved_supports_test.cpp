// Supports that move differently open and close an arch of two halves as the closed form of its span change says:
// all the way, whichever support moves, and as closely as its joints give.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tests/libdda/scenes.h"
#include "tests/verification/three_hinged_arch.h"

namespace voussoir::verification
{

namespace
{

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double depth = 1;  // m, along y

/// A prism of this outline in (x, z), in the sense from x to z; in a planar scene the outline itself.
int add_prism(Model& model, const std::string& name, const std::vector<Vector2d>& outline)
{
    const int block = static_cast<int>(model.blocks.size());
    if (is_planar(model.kinematics)) {
        model.blocks.push_back(make_planar_block(name, 0, 0, {make_convex_polygon(outline)}, model.thickness));
        return block;
    }
    const int n = static_cast<int>(outline.size());
    std::vector<Vector3d> vertices;
    for (const double y : {-depth / 2, depth / 2})
        for (const Vector2d& corner : outline) vertices.emplace_back(corner.x(), y, corner.y());
    std::vector<std::vector<int>> faces(2);  // the one that looks along -y, the other, then the sides
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        faces[0].push_back(i);
        faces[1].push_back(2 * n - 1 - i);
        faces.push_back({next, i, i + n, next + n});
    }
    model.blocks.push_back(make_block(name, 0, 0, {make_convex_polyhedron(vertices, faces, name)}));
    return block;
}

/// Blocks 0 and 1 the supports, 2 and 3 the halves; left and right.
Model arch_on_two_supports(Kinematics kinematics, double young)
{
    const ThreeHingedArch arch;
    JointMaterial joint = testing::dry(60);
    joint.face = FaceLaw::corners;  // hinges give what half a bed's springs do
    joint.stiffness.factor = 0.1;   // soft enough that what they give is all there is to measure
    Model model = make_model(kinematics, testing::stone(young), joint);
    testing::hold(model, testing::add_box(model, "left support", {-3.5, -depth / 2, -0.5}, {-1.2, depth / 2, 0}));
    testing::hold(model, testing::add_box(model, "right support", {1.2, -depth / 2, -0.5}, {3.5, depth / 2, 0}));
    add_prism(model, "left half", {{-arch.outer, 0}, {-arch.inner, 0}, {0, arch.lower}, {0, arch.upper}});
    add_prism(model, "right half", {{arch.inner, 0}, {arch.outer, 0}, {0, arch.upper}, {0, arch.lower}});
    return model;
}

/// Where the two corners that meet at the crown are, in the mean. @param height of the corners at the start [m]
Vector3d crown_of(const Model& model, const State& state, double height)
{
    Vector3d sum = Vector3d::Zero();
    for (const int half : {2, 3}) {
        const Pose pose = pose_of(model.kinematics, state, half);
        sum += pose.centroid + pose.map * (Vector3d(0, 0, height) - model.blocks[half].moments.centroid);
    }
    return sum / 2;
}

struct Opened {
    double up = 0;                                  // m, of the crown, at the end
    double farthest_up = 0, farthest_sideways = 0;  // m, from the closed form, at any step
    double penetration = 0;                         // m, at any step
};

/// Moves the supports by `left` and `right` [m] along x, slowly, and compares the crown at every step.
Opened move_supports(Kinematics kinematics, double young, double left, double right)
{
    const ThreeHingedArch arch;
    const Model model = arch_on_two_supports(kinematics, young);
    const auto motion = [](double end) {
        return std::make_shared<GroundMotion>(
            GroundMotion::from_displacement(slow_ramp(end), ramp_step, "slow ramp"));
    };
    Stage stage = testing::dynamic_stage(5, 2e-3);
    stage.damping.rate = 5;
    stage.motions = {{0, 0, motion(left)}, {1, 0, motion(right)}};
    const double height = arch.hinge_height(right > left);
    Opened result;
    RunObserver observer;
    observer.step = [&](const State& now, const StepReport& step, const RunReport&) {
        if (now.stage == 0) return;
        const double t = now.stage_time;
        const auto exact =
            arch.crown(stage.motions[0].motion->displacement(t), stage.motions[1].motion->displacement(t));
        const Vector3d crown = crown_of(model, now, height);
        result.up = crown.z() - height;
        result.farthest_up = std::max(result.farthest_up, std::abs(result.up - exact.up));
        result.farthest_sideways = std::max(result.farthest_sideways, std::abs(crown.x() - exact.sideways));
        result.penetration = std::max(result.penetration, step.max_penetration);
    };
    State state = initial_state(model);
    const RunReport report = run(model, {testing::static_stage(0.1), stage}, state, observer);
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_EQ(state.stage_time, 5);
    return result;
}

class MovedSupports : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, MovedSupports,
                         ::testing::Values(Kinematics::planar_rigid, Kinematics::spatial_rigid),
                         testing::test_name);

}  // namespace

TEST_P(MovedSupports, OpenAndCloseAnArchAsItsSpanSays)
{
    const ThreeHingedArch arch;
    constexpr double soft = 1e10, stiff = 1e11;  // Pa
    const Vector2d ends[] = {{-0.1, 0.1}, {0.1, -0.1}, {0, 0.2}, {0, -0.2}, {0.15, 0.2}, {-0.02, -0.12}};
    for (const Vector2d& end : ends) {
        const bool spreads = end.y() > end.x();
        const double way = arch.crown(end.x(), end.y()).up;
        double off_when_soft = 0;
        for (const double young : {soft, stiff}) {
            const Opened result = move_supports(GetParam(), young, end.x(), end.y());
            std::printf(
                "supports %+.0f and %+.0f mm, %.0e Pa: crown %+.3f mm, off by at most %.4f mm, %.4f mm sideways; "
                "hinges give %.4f mm\n",
                1e3 * end.x(), 1e3 * end.y(), young, 1e3 * result.up, 1e3 * result.farthest_up,
                1e3 * result.farthest_sideways, 1e3 * result.penetration);
            EXPECT_LT(result.farthest_up, arch.give(result.penetration, spreads));
            EXPECT_LT(result.farthest_sideways, 0.2 * result.penetration);
            EXPECT_LT(result.farthest_up, 5e-3 * std::abs(way));
            if (young == soft) off_when_soft = result.farthest_up;
            if (young == stiff) {
                EXPECT_NEAR(off_when_soft / result.farthest_up, stiff / soft, 1);
            }
        }
    }
}

}  // namespace voussoir::verification
