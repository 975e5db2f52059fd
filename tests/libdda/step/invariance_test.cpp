// The same physics told in another frame, place, unit or order has the same outcome.
#include <gtest/gtest.h>

#include "tests/libdda/whole_scenes.h"

namespace voussoir::testing
{

namespace
{

using Eigen::Vector3d;

constexpr double step_length = 1e-3;
constexpr int steps = 150;

struct Ending {
    std::vector<Vector3d> moved;             // m, told in the plain frame and unit
    std::vector<Eigen::Matrix3d> attitudes;  // in the plain frame
    double friction = 0;                     // J
    int touching = 0;
};

enum class Impacts { land, are_sprung };

Ending end_of(Kinematics kinematics, const Telling& telling, LinearSolverKind solver = LinearSolverKind::cholmod,
              Impacts impacts = Impacts::land)
{
    FewBlocks scene(kinematics, telling);
    const bool sprung = impacts == Impacts::are_sprung;
    if (sprung) scene.model.joints[0].restitution.reset();
    std::vector<Vector3d> start;
    for (int b = 0; b < 5; ++b) start.push_back(centroid(scene.model, scene.state, scene.place[b]));
    Stage stage = dynamic_stage(steps * step_length, step_length,
                                telling.scale * telling.rotation * Vector3d(0, 0, -gravity));
    stage.control.force_tolerance = 1e-11;
    stage.control.linear_solver = solver;
    if (sprung) stage.control.integrator = Integrator::newmark;
    const RunReport report = run_quietly(scene.model, {stage}, scene.state);
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    Ending end;
    for (int b = 0; b < 5; ++b) {
        const Pose pose = pose_of(kinematics, scene.state, scene.place[b]);
        end.moved.push_back(telling.rotation.transpose() * (pose.centroid - start[b]) / telling.scale);
        end.attitudes.push_back(telling.rotation.transpose() * pose.map);
    }
    // Energy is told in kg (unit of length)^2 / s2, mass in kg.
    end.friction = report.energy.friction / (telling.scale * telling.scale);
    // Closed, or open while the stones tremble.
    for (const ContactPoint& p : scene.state.contacts.points) end.touching += p.gap < 1e-5 * telling.scale;
    return end;
}

void expect_same(const Ending& a, const Ending& b, double tolerance, const char* what)
{
    double worst = 0;
    for (int k = 0; k < 5; ++k) {
        worst = std::max(worst, (a.moved[k] - b.moved[k]).norm());
        worst = std::max(worst, (a.attitudes[k] - b.attitudes[k]).norm());
    }
    std::printf("%s: largest difference %.1e m, friction %.6f and %.6f J\n", what, worst, a.friction, b.friction);
    EXPECT_LT(worst, tolerance) << what;
    EXPECT_NEAR(a.friction, b.friction, 10 * tolerance * a.friction) << what;
}

class Invariance : public ::testing::TestWithParam<Kinematics>
{
};
INSTANTIATE_TEST_SUITE_P(Kinematics, Invariance, spatial_kinematics(), test_name);

}  // namespace

TEST_P(Invariance, TheSceneIsWorthComparing)
{
    const Ending plain = end_of(GetParam(), {});
    EXPECT_GT(plain.friction, 100);
    EXPECT_GE(plain.touching, 8);
    EXPECT_GT(plain.moved[3].norm(), 0.1);
    EXPECT_GT(plain.moved[1].norm(), 1e-3);
    EXPECT_GT((plain.attitudes[4] - Eigen::Matrix3d::Identity()).norm(), 1e-2);
}

TEST_P(Invariance, OfTheFrame)
{
    Telling turned_scene;
    turned_scene.rotation = turned(0.7, {1, 2, -0.5});
    expect_same(end_of(GetParam(), {}), end_of(GetParam(), turned_scene), 1e-8, "turned by 0.7 rad");
}

TEST_P(Invariance, OfThePlace)
{
    Telling moved;
    moved.offset = {1000, -700, 300};
    // Coordinates of 1e3 m leave 1e-13 m of rounding in every gap, times what impacts amplify.
    expect_same(end_of(GetParam(), {}), end_of(GetParam(), moved), 1e-7, "moved by 1 km");
}

TEST_P(Invariance, OfTheUnitOfLength)
{
    Telling millimetres;
    millimetres.scale = 1000;
    expect_same(end_of(GetParam(), {}), end_of(GetParam(), millimetres), 1e-8, "in millimetres");
}

// While the first of two touching blocks stays the first, order is only where a number is stored.
TEST_P(Invariance, OfTheOrderOfTheBlocks)
{
    Telling shuffled;
    shuffled.order = {0, 1, 2, 4, 3};
    expect_same(end_of(GetParam(), {}), end_of(GetParam(), shuffled), 1e-8, "blocks in another order");
}

// Of two touching blocks that claim the reference face with equal right the first has it: another first block is
// another, equally good discretisation. The difference is one of method, not of rounding. Impacts are left to
// damped springs here: which corners of a stone that falls nearly flat land in one blow, and which after one
// another, may change with any small difference, and what they leave of its motion with it.
TEST_P(Invariance, OfTheOrderOfTheBlocksUpToTheChoiceOfReferenceFaces)
{
    Telling shuffled;
    shuffled.order = {3, 1, 4, 0, 2};
    const auto told = [](const Telling& telling) {
        return end_of(GetParam(), telling, LinearSolverKind::cholmod, Impacts::are_sprung);
    };
    expect_same(told({}), told(shuffled), 1e-3, "blocks in an order that swaps faces");
}

TEST_P(Invariance, OfTheLinearSolver)
{
    expect_same(end_of(GetParam(), {}), end_of(GetParam(), {}, LinearSolverKind::conjugate_gradients), 1e-8,
                "conjugate gradients instead of Cholesky");
}

}  // namespace voussoir::testing
