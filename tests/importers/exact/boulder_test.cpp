// A scanned boulder of 28,666 triangles as a stone of a few parts: it stands and tilts like its scan. The scan is
// that of the shake table tests of boulder SP1 and is not ours to ship; without it the tests are skipped.
#include "tests/importers/boulder.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "importers/helper/import_meshes.h"
#include "importers/mesh/read_mesh.h"
#include "tests/importers/rough_stone.h"
#include "tests/libdda/poses.h"
#include "tests/libdda/scenes.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Vector3d;
using testing::degrees;

std::vector<Vector3d> vertices_of(const std::vector<ConvexPolyhedron>& parts)
{
    std::vector<Vector3d> all;
    for (const ConvexPolyhedron& part : parts) all.insert(all.end(), part.vertices.begin(), part.vertices.end());
    return all;
}

class Boulder : public ::testing::Test
{
 protected:
    void SetUp() override
    {
        const char* folder = std::getenv("VOUSSOIR_DATA");
        const std::filesystem::path data = folder != nullptr ? folder : VOUSSOIR_DEFAULT_DATA;
        const std::filesystem::path file = data / ".." / "experiments" / "boulder" / "SP1.obj";
        if (!std::filesystem::exists(file)) GTEST_SKIP() << "no scan of the boulder beside VOUSSOIR_DATA";
        scan = mesh::read_mesh(file, {}).surfaces.at(0).vertices;
        helper::MeshRequest request;
        request.file = file;
        request.simplify.parts = 12;
        request.simplify.volume_error = 0.02;
        mesh_ = helper::import_meshes({request}).meshes.at(0);
        ASSERT_TRUE(mesh_.accepted) << mesh_.reason;
    }
    const helper::Stone& stone() const { return mesh_.stones.at(0); }

    std::vector<Vector3d> scan;

 private:
    helper::ImportedMesh mesh_;
};

TEST_F(Boulder, BecomesTwelvePartsWithinTwoPercentOfItsVolume)
{
    EXPECT_LE(stone().parts.size(), 12U);
    EXPECT_LT(stone().volume_error, 0.02);
    EXPECT_NEAR(moments_of(stone().parts).volume / stone().moments.volume - 1, stone().volume_error, 1e-12);
    EXPECT_NEAR(stone().moments.volume, 0.1239, 5e-5);
    double lowest = 1e300;
    for (const Vector3d& x : scan) lowest = std::min(lowest, x.z());
    EXPECT_NEAR(stone().moments.centroid.z() - lowest, 0.294, 5e-4);
}

TEST_F(Boulder, StandsOnTheSamePointsAndTiltsAtTheSameAngleAsTheHullOfItsScan)
{
    const RollingBody whole(scan, stone().moments.centroid),
        parts(vertices_of(stone().parts), stone().moments.centroid);
    const int on_whole = whole.settle(), on_parts = parts.settle();
    ASSERT_GE(on_whole, 0);
    ASSERT_GE(on_parts, 0);
    EXPECT_EQ(whole.corners(on_whole), 3);
    EXPECT_EQ(parts.corners(on_parts), 3) << "it stands on three points";
    const double settled = std::acos(-whole.normal(on_whole).z()) / degrees;
    EXPECT_NEAR(settled, 0.4, 0.2);
    EXPECT_LT(std::acos(std::min(1.0, whole.normal(on_whole).dot(parts.normal(on_parts)))) / degrees, 0.02);
    const double expected = whole.tilting_angle(on_whole) / degrees;
    EXPECT_NEAR(expected, 12, 1.5);
    EXPECT_NEAR(parts.tilting_angle(on_parts) / degrees, expected, 0.5);
    RecordProperty("settled_degrees", std::to_string(settled));
    RecordProperty("tilting_degrees", std::to_string(expected));
}

TEST_F(Boulder, SettlesAndTiltsInTheEngineAsItsGeometrySays)
{
    const Vector3d centroid = stone().moments.centroid;
    const RollingBody whole(scan, centroid);
    const int face = whole.settle();
    const double tilting = whole.tilting_angle(face) / degrees;
    double lowest = 1e300;
    for (const Vector3d& x : scan) lowest = std::min(lowest, x.z());
    std::vector<ConvexPolyhedron> shapes;
    const Vector3d shift(-centroid.x(), -centroid.y(), -lowest);
    for (const ConvexPolyhedron& part : stone().parts) shapes.push_back(translated(part, shift));
    Moments moments = stone().moments;
    moments.centroid += shift;

    JointMaterial joint = testing::dry(45);
    joint.stiffness = {ContactStiffness::Kind::per_point, 1e8};
    joint.face = FaceLaw::corners;
    Model model = make_model(Kinematics::spatial_rigid, testing::stone(), joint);
    testing::hold(model, testing::add_box(model, "floor", {-2, -2, -0.5}, {2, 2, 0}));
    model.blocks.push_back(make_block("boulder", 0, 0, shapes, moments));
    State state = initial_state(model);
    const RunReport report = testing::run_quietly(model, {testing::static_stage(5e-3)}, state);
    EXPECT_EQ(report.outcome, Outcome::completed);
    const auto leaning = [&](const State& now) {
        return std::acos(std::min(1.0, -(pose_of(model.kinematics, now, 1).map * whole.normal(face)).z())) /
               degrees;
    };
    EXPECT_LT(leaning(state), 0.05) << "it rests on the face that geometry says";

    for (const double off : {-0.5, 0.5}) {
        const Vector3d down = whole.turned(face, (tilting + off) * degrees);
        const Eigen::Matrix3d turn =
            Eigen::Quaterniond::FromTwoVectors(down, -Vector3d::UnitZ()).toRotationMatrix();
        State tilted = initial_state(model);
        testing::set_pose(model, tilted, 1, {0, 0, down.dot(whole.lowest(down) - centroid)}, turn);
        const RunReport end = testing::run_quietly(model, {testing::dynamic_stage(3, 1e-3)}, tilted);
        if (off < 0)
            EXPECT_LT(leaning(tilted), 8) << "it rolls back";
        else
            EXPECT_GT(leaning(tilted), 30) << "it falls";
    }
}

TEST(RollingBody, ABoxTopplesAtTheAngleOfItsDiagonal)
{
    std::vector<Vector3d> corners = box({-0.1, -0.2, 0}, {0.1, 0.2, 0.5}).vertices;
    const RollingBody body(corners, {0, 0, 0.25});
    const int face = body.settle();
    EXPECT_NEAR(body.normal(face).z(), -1, 1e-12);
    EXPECT_NEAR(body.tilting_angle(face), std::atan(0.1 / 0.25), 1e-3);
    corners.emplace_back(0.02, 0, -0.01);  // a bump: it rolls onto a face beside it
    const RollingBody bumpy(corners, {0, 0, 0.25});
    EXPECT_LT(std::abs(bumpy.normal(bumpy.settle()).z()), 0.9999);
}

}  // namespace
}  // namespace voussoir::importers
