// The ground's own frame: a stone on ground that moves with a(t), and the same stone under the body acceleration
// -a(t) on ground that stays, move alike relative to the ground.
//
// The two differ by how a step takes the ground in. A moved foundation gives the exact change of velocity of the
// step, h (a0 + a1) / 2 for a straight a(t); a body acceleration is a force, which Newmark's integrator takes at
// the end of the step, h a1: the same motion h / 2 early, so that the paths differ by at most about what the
// ground moves in that time. The energy-decaying one takes its mean over the step, the same change of velocity;
// what is left is where in the step it acts, less than h^2 a.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tests/libdda/scenes.h"

namespace voussoir::verification
{

namespace
{

using Eigen::Vector3d;

enum class Frame { inertial, ground };

constexpr double duration = 2;    // s
constexpr double spacing = 4e-3;  // s between the times at which paths are compared

/// Strong enough to make the stone slide to and fro, and press it down and lift it.
std::array<GroundMotion, 3> shaking()
{
    return {GroundMotion::sine_acceleration(6, 2, 0, 10), GroundMotion::sine_acceleration(4, 1.4, 0, 10),
            GroundMotion::sine_acceleration(2, 3, 0, 10)};
}

/// Largest of a quantity of the ground motion, in space.
double peak(double (GroundMotion::*quantity)(double) const)
{
    const std::array<GroundMotion, 3> motions = shaking();
    double largest = 0;
    for (double t = 0; t <= duration; t += 1e-3) {
        const auto along = [&](int axis) { return (motions[axis].*quantity)(t); };
        largest = std::max(largest, Vector3d(along(0), along(1), along(2)).norm());
    }
    return largest;
}

/// Moves the foundation, or the stone the other way.
void shake(Frame frame, const Model& model, Stage& stage)
{
    const std::array<GroundMotion, 3> motions = shaking();
    for (int axis = 0; axis < 3; ++axis) {
        if (is_planar(model.kinematics) && axis == 1) continue;
        if (frame == Frame::inertial)
            stage.motions.push_back({0, axis, std::make_shared<GroundMotion>(motions[axis])});
        else
            stage.body_accelerations.push_back(
                {1, axis, std::make_shared<GroundMotion>(motions[axis].scaled(-1))});
    }
}

/// Where the stone is relative to the ground, every `spacing`. @param steps time steps in that time
std::vector<Vector3d> path(Frame frame, Kinematics kinematics, Integrator integrator, int steps)
{
    Model model = make_model(kinematics, testing::stone(), testing::dry(20));
    testing::hold(model, testing::add_box(model, "foundation", {-3, -3, -1}, {3, 3, 0}));
    testing::add_box(model, "stone", {-0.5, -0.4, 0}, {0.5, 0.4, 0.5});
    JointMaterial& joint = model.joints[0];  // stiff: what yields under the stone is no matter of the frame
    joint.face = FaceLaw::corners;           // nor that it bends
    joint.stiffness.value = 100;
    Stage stage = testing::dynamic_stage(duration, spacing / steps);
    stage.control.integrator = integrator;
    stage.control.force_tolerance = 1e-9;
    shake(frame, model, stage);
    std::vector<Vector3d> places;
    RunObserver observer;
    observer.every = spacing;
    observer.frame = [&](const State& now, const RunReport&) {
        if (now.stage == 1) places.push_back(testing::centroid(model, now, 1) - testing::centroid(model, now, 0));
    };
    State state = initial_state(model);
    const RunReport report = run(model, {testing::static_stage(0.1), stage}, state, observer);
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    return places;
}

struct Comparison {
    double apart = 0, moved = 0;  // m, the largest of each
};

Comparison compare(Kinematics kinematics, Integrator integrator, int steps)
{
    const std::vector<Vector3d> moved_ground = path(Frame::inertial, kinematics, integrator, steps),
                                own_frame = path(Frame::ground, kinematics, integrator, steps);
    EXPECT_EQ(moved_ground.size(), 500);
    EXPECT_EQ(moved_ground.size(), own_frame.size());
    Comparison result;
    for (std::size_t i = 0; i < std::min(moved_ground.size(), own_frame.size()); ++i) {
        result.apart = std::max(result.apart, (moved_ground[i] - own_frame[i]).norm());
        result.moved = std::max(result.moved, (own_frame[i] - own_frame[0]).norm());
    }
    return result;
}

class GroundFrame : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, GroundFrame, testing::every_kinematics(), testing::test_name);

}  // namespace

TEST_P(GroundFrame, BodyAccelerationMovesAStoneAsMovingGroundDoes)
{
    for (const Integrator integrator : {Integrator::newmark, Integrator::energy_decaying}) {
        const bool newmark = integrator == Integrator::newmark;
        Comparison coarse;
        for (const int steps : {1, 2, 4, 8}) {
            const double h = spacing / steps;
            const Comparison result = compare(GetParam(), integrator, steps);
            std::printf("%s, %s, steps of %.1f ms: the stone slides %.2f mm, the two frames differ by %.4f mm\n",
                        std::string(name_of(GetParam())).c_str(), newmark ? "Newmark" : "energy-decaying", 1e3 * h,
                        1e3 * result.moved, 1e3 * result.apart);
            EXPECT_GT(result.moved, 0.03);
            EXPECT_LT(result.apart, newmark ? 0.5 * h * peak(&GroundMotion::velocity)
                                            : 2 * h * h * peak(&GroundMotion::acceleration));
            if (steps == 1) coarse = result;
            if (steps == 8) {
                EXPECT_GT(coarse.apart / result.apart, newmark ? 6 : 30) << "eight times as many steps";
            }
        }
    }
}

}  // namespace voussoir::verification
