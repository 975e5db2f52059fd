// How the run begins: initial_state, its turned blocks and its moving ones.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "libdda/analysis/energies.h"
#include "libdda/model/state.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

std::string case_with(const std::string& initial_state, const std::string& kinematics = "spatial_rigid",
                      const std::string& more_blocks = "")
{
    return "kinematics: " + kinematics + R"(
materials: {stone: {density: 2000 kg/m3, young: 5 GPa, poisson: 0.2}}
joints: {dry: {friction: 30 deg}}
blocks:
  - {box: {name: floor, lower: [-5, 0, -1], upper: [5, 1, 0]}, group: ground}
  - {box: {name: pier_1, lower: [0, 0, 0], upper: [1, 1, 2]}}
  - {box: {name: pier_2, lower: [3, 0, 0], upper: [4, 1, 2]}}
)" + more_blocks +
           R"(foundation: {blocks: ground}
initial_state:
)" + initial_state +
           "stages: [{type: dynamic, duration: 1 s}]\n";
}

/// The block's points that it shows in a spatial scene, user's coordinates.
Vector3d lowest_point(const Model& model, int block)
{
    Vector3d lowest(0, 0, INFINITY);
    for (const ConvexPolyhedron& part : model.blocks[block].parts)
        for (const Vector3d& x : part.vertices)
            if (x.z() < lowest.z()) lowest = x;
    return lowest + model.blocks[block].moments.centroid + model.origin;
}

TEST(InitialStateKeys, VelocityAndSpinAreThoseOfTheState)
{
    const Vector3d velocity(1, 2, -3), spin(0.5, 0, 2);
    for (const char* kinematics : {"spatial_rigid", "spatial_deformable"}) {
        const Model model =
            read(case_with("  - {blocks: pier_*, velocity: [1, 2 m/s, -3], spin: [0.5 rad/s, 0, 2 rad/s]}\n",
                           kinematics))
                .model;
        const State state = initial_state(model);
        for (const int pier : {1, 2}) {
            EXPECT_LT((velocity_of(model.kinematics, state, pier) - velocity).norm(), 1e-12) << kinematics;
            EXPECT_LT((angular_velocity_of(model, state, pier) - spin).norm(), 1e-12) << kinematics;
        }
        EXPECT_EQ(velocity_of(model.kinematics, state, 0), Vector3d::Zero().eval());
        // 1/2 m v^2 + 1/2 w I w of two boxes of 1 x 1 x 2 m.
        const double m = 4000, energy = 0.5 * m * 14 + 0.5 * m / 12 * (5 * 0.25 + 2 * 4);
        EXPECT_NEAR(kinetic_energy(model, state), 2 * energy, 1e-9 * energy) << kinematics;
    }
}

TEST(InitialStateKeys, SpinAboutAPointMovesTheBlockRoundIt)
{
    const Model model =
        read(case_with(
                 "  - {blocks: pier_1, velocity: [0, 1, 0], spin: [0, 2 rad/s, 0], spin_about: [0, 0.5, 0]}\n"))
            .model;
    const State state = initial_state(model);
    // w x (c - p) = (0, 2, 0) x (0.5, 0, 1)
    EXPECT_LT((velocity_of(model.kinematics, state, 1) - Vector3d(2, 1, -1)).norm(), 1e-12);
    EXPECT_LT((angular_velocity_of(model, state, 1) - Vector3d(0, 2, 0)).norm(), 1e-12);
}

TEST(InitialStateKeys, PlanarScenesSpinFromXToZ)
{
    for (const char* kinematics : {"planar_rigid", "planar_deformable"})
        for (const char* spin : {"3 rad/s", "[0, -3 rad/s, 0]"}) {
            const Model model =
                read(case_with("  - {blocks: pier_1, velocity: [1, 2], spin: " + std::string(spin) +
                                   ", spin_about: [0.5, 0]}\n",
                               kinematics))
                    .model;
            const State state = initial_state(model);
            // The centre, 1 m above the point, goes towards -x.
            EXPECT_LT((velocity_of(model.kinematics, state, 1) - Vector3d(1 - 3, 0, 2)).norm(), 1e-12)
                << kinematics;
            EXPECT_LT((angular_velocity_of(model, state, 1) - Vector3d(0, -3, 0)).norm(), 1e-12) << kinematics;
        }
}

TEST(InitialStateKeys, TurnsTheModelSoThatItsGeometryIsJudgedAsItBegins)
{
    const std::string tilt = "  - {blocks: pier_1, rotate: {axis: y, angle: -10 deg, about: [0, 0, 0]}}\n";
    for (const char* kinematics : {"spatial_rigid", "spatial_deformable"}) {
        const Model model = read(case_with(tilt, kinematics)).model;
        EXPECT_LT((lowest_point(model, 1) - Vector3d(0, lowest_point(model, 1).y(), 0)).norm(), 1e-12)
            << "it stands on its edge";
        const Vector3d centre(0.5 * std::cos(10 * degree) - std::sin(10 * degree), 0.5,
                              std::cos(10 * degree) + 0.5 * std::sin(10 * degree));
        EXPECT_LT((model.blocks[1].moments.centroid + model.origin - centre).norm(), 1e-12);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(-10 * degree, Vector3d::UnitY()).toRotationMatrix();
        const Eigen::Matrix3d second = Vector3d(1, 1, 4).asDiagonal();
        EXPECT_LT((model.blocks[1].moments.second - 2.0 / 12 * turn * second * turn.transpose()).norm(), 1e-12);
        EXPECT_EQ(pose_of(model.kinematics, initial_state(model), 1).map, Eigen::Matrix3d::Identity().eval());
    }
    EXPECT_NE(faults_of(case_with("  - {blocks: pier_1, rotate: {axis: y, angle: 10 deg, about: [0, 0, 0]}}\n"))
                  .find("floor and pier_1: overlap by 0.17"),
              std::string::npos);
    const std::string leaning_on = "  - {box: {name: wall, lower: [1, 0, 0], upper: [2, 1, 1]}}\n";
    EXPECT_NE(faults_of(case_with("  - {blocks: pier_1, rotate: {axis: y, angle: 10 deg, about: [1, 0, 0]}}\n",
                                  "spatial_rigid", leaning_on))
                  .find("pier_1 and wall: overlap"),
              std::string::npos);
}

TEST(InitialStateKeys, TurnsPlanarBlocksFromXToZ)
{
    for (const char* axis : {"", "axis: [0, -1, 0], "}) {
        const Model model = read(case_with("  - {blocks: pier_1, rotate: {" + std::string(axis) +
                                               "angle: 10 deg, about: [0, 0]}}\n",
                                           "planar_rigid"))
                                .model;
        EXPECT_NEAR(model.blocks[1].moments.centroid.x(), 0.5 * std::cos(10 * degree) - std::sin(10 * degree),
                    1e-12);
    }
}

// Without `about` each block of a group turns about itself, with it all of them as one.
TEST(InitialStateKeys, TurnsEachAboutItselfOrAllAboutAPoint)
{
    const auto centre = [](const std::string& about, int block) {
        const std::string turn = "  - {group: masonry, rotate: {axis: z, angle: 90 deg" + about + "}}\n";
        return read(case_with(turn)).model.blocks[block].moments.centroid;
    };
    EXPECT_LT((centre("", 1) - Vector3d(0.5, 0.5, 1)).norm(), 1e-12);
    EXPECT_LT((centre("", 2) - Vector3d(3.5, 0.5, 1)).norm(), 1e-12);
    EXPECT_LT((centre(", about: [0.5, 0.5, 0]", 1) - Vector3d(0.5, 0.5, 1)).norm(), 1e-12);
    EXPECT_LT((centre(", about: [0.5, 0.5, 0]", 2) - Vector3d(0.5, 3.5, 1)).norm(), 1e-12);
}

TEST(InitialStateKeys, TurnsFollowOneAnotherAndMotionIsThatOfTheTurnedBlock)
{
    const Model model =
        read(case_with("  - {blocks: pier_1, rotate: {axis: y, angle: -90 deg, about: [0, 0, 0]}}\n"
                       "  - {blocks: pier_1, rotate: {axis: z, angle: 180 deg, about: [0, 0, 0]},\n"
                       "     spin: [0, 0, 1 rad/s], spin_about: [0, 0, 0]}\n"))
            .model;
    const Vector3d centre(1, -0.5, 0.5);  // (0.5, 0.5, 1) to (-1, 0.5, 0.5) to (1, -0.5, 0.5)
    EXPECT_LT((model.blocks[1].moments.centroid - centre).norm(), 1e-12);
    EXPECT_LT((velocity_of(model.kinematics, initial_state(model), 1) - Vector3d(0.5, 1, 0)).norm(), 1e-12);
}

TEST(InitialStateKeys, FaultsNameTheirLine)
{
    const auto fault = [](const std::string& entry, const std::string& kinematics = "spatial_rigid") {
        return faults_of(case_with("  - " + entry + "\n", kinematics));
    };
    const auto expect = [](const std::string& text, const std::string& part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    expect(fault("{blocks: peer_*, velocity: [1, 0, 0]}"), "case.yaml:10: initial_state[0].blocks: \"peer_*\"");
    expect(fault("{group: masonery, velocity: [1, 0, 0]}"), "did you mean masonry?");
    expect(fault("{blocks: pier_1, group: masonry, velocity: [1, 0, 0]}"), "both blocks and group");
    expect(fault("{velocity: [1, 0, 0]}"), "neither blocks nor group");
    expect(fault("{blocks: pier_1}"), "neither rotate nor velocity nor spin");
    expect(fault("{blocks: pier_1, velocity: [1, 0, 0], spin_about: [0, 0, 0]}"), "a point without spin");
    expect(fault("{blocks: pier_1, velocity: [1 m, 0, 0]}"), "velocity");
    expect(fault("{blocks: pier_1, velocity: [1, 0]}"), "velocity");
    expect(fault("{blocks: pier_1, velocity: 1 m/s}"), "velocity");
    expect(fault("{blocks: pier_1, velocity: [.nan, 0, 0]}"), "velocity");
    expect(fault("{blocks: pier_1, velocity: [1e30, 0, 0]}"), "at most 10000 m/s");
    expect(fault("{blocks: pier_1, spin: [1 m/s, 0, 0]}"), "spin");
    expect(fault("{blocks: pier_1, spin: [0, 1e5 rad/s, 0]}"), "at most 10000 rad/s");
    expect(fault("{blocks: pier_1, spin: 1 rad/s}"), "spin");
    expect(fault("{blocks: pier_1, rotate: {axis: y, angle: 30 m}}"), "angle");
    expect(fault("{blocks: pier_1, rotate: 30 deg}"), "a rotation {axis: z, angle: 45 deg}");
    expect(fault("{blocks: pier_1, turn: 30 deg}"), "turn");
    expect(fault("3 m/s"), "initial_state[0]");
    expect(fault("{blocks: pier_1, spin: [1 rad/s, 0, 0]}", "planar_rigid"), "in its plane");
    expect(fault("{blocks: pier_1, velocity: [1, 1, 0]}", "planar_rigid"), "along y");
    expect(fault("{blocks: pier_1, rotate: {axis: x, angle: 3 deg}}", "planar_rigid"), "out of the plane");
    expect(fault("{blocks: pier_*, velocity: [1, 0, 0]}\n  - {blocks: pier_2, spin: [0, 1 rad/s, 0]}"),
           "a second velocity or spin of block pier_2");
    expect(faults_of("materials: {}\n" + case_with("").substr(case_with("").find("joints"))), "initial_state");
}

TEST(InitialStateKeys, HeldBlocksHaveNoMotionOfTheirOwn)
{
    const auto fault = [](const std::string& entry, const std::vector<std::string>& overrides = {}) {
        return faults_of(case_with("  - " + entry + "\n"), overrides);
    };
    EXPECT_NE(fault("{group: ground, velocity: [1, 0, 0]}")
                  .find("a velocity along x of block floor, which the foundation holds"),
              std::string::npos);
    EXPECT_NE(fault("{blocks: floor, spin: [0, 0, 1 rad/s]}").find("a spin of block floor"), std::string::npos);
    EXPECT_EQ(fault("{blocks: floor, velocity: [1, 0, 0]}", {"foundation.x=free"}), "no fault");
    EXPECT_NE(fault("{blocks: floor, velocity: [1, 0, 1]}", {"foundation.x=free"}).find("along z"),
              std::string::npos);
}

// One case for all kinematics: the tilted pillar stands on its edge, and the tossed stone flies alike.
TEST(InitialStateKeys, AreReadAlikeInTheCaseOfATossedStone)
{
    for (const char* kinematics : {"spatial_rigid", "spatial_deformable", "planar_rigid", "planar_deformable"}) {
        const Model model =
            read_case(VOUSSOIR_CASES "/tossed_stone.yaml", {"kinematics=" + std::string(kinematics)}).model;
        const State state = initial_state(model);
        EXPECT_LT((velocity_of(model.kinematics, state, 2) - Vector3d(3.5, 0, 4)).norm(), 1e-12) << kinematics;
        EXPECT_LT((angular_velocity_of(model, state, 2) - Vector3d(0, 6, 0)).norm(), 1e-12) << kinematics;
        const Vector3d lever = model.blocks[1].moments.centroid + model.origin - Vector3d(1.4, 0.2, 0);
        EXPECT_NEAR(std::atan2(-lever.x(), lever.z()), std::atan2(0.2, 0.8) - 8 * degree, 1e-12) << kinematics;
    }
}

}  // namespace
}  // namespace voussoir::app::reader
