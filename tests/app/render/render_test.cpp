// The parts of the renderer that can be judged without looking: frames, scale, camera, joints.
#include "app/render/render_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "app/drawing/color_map.h"
#include "app/render/camera.h"
#include "app/render/extrusion.h"
#include "app/render/joint_faces.h"
#include "app/render/scene.h"
#include "app/results/results_writer.h"
#include "tests/app/results/synthetic.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::render
{
namespace
{

using Eigen::Vector3d;

/// Frames at 0 (end of the static stage), 0.1, 0.2, ..., 2 s.
results::ResultsReader run_of(const Case& the_case, const std::filesystem::path& folder)
{
    results::ResultsWriter writer(the_case, folder);
    for (int i = 0; i <= 20; ++i) writer.frame(synthetic::swaying(the_case, 0.1 * i), {});
    writer.finish(synthetic::swaying(the_case, 2), {}, {0, 0});
    return results::ResultsReader(writer.results_file());
}

TEST(ChooseFrames, NearestToEachTimeAndEachOnce)
{
    const TemporaryFolder folder;
    const results::ResultsReader results = run_of(synthetic::tower(Kinematics::spatial_rigid), folder.path());
    SnapshotOptions options;
    options.times = {1.52, 0.31, 0.29, 99};
    EXPECT_EQ(choose_frames(results, options), (std::vector<std::size_t>{3, 15, 20}));
}

TEST(ChooseFrames, SpreadOverTheMotionWithTheLast)
{
    const TemporaryFolder folder;
    const results::ResultsReader results = run_of(synthetic::tower(Kinematics::spatial_rigid), folder.path());
    SnapshotOptions options;
    options.count = 4;
    EXPECT_EQ(choose_frames(results, options), (std::vector<std::size_t>{5, 10, 15, 20}));
    options.count = 1;
    EXPECT_EQ(choose_frames(results, options), (std::vector<std::size_t>{20}));
    options.count = 1000;
    EXPECT_EQ(choose_frames(results, options).size(), 20U) << "no frame twice, none of the static stage";
}

TEST(ColorScale, TicksAreRoundAndInside)
{
    const drawing::ColorScale scale = drawing::make_scale(0, 0.0404, "displacement", drawing::length_units);
    EXPECT_EQ(scale.caption, "displacement [mm]");
    EXPECT_EQ(scale.labels, (std::vector<std::string>{"0", "10", "20", "30", "40"}));
    EXPECT_NEAR(scale.ticks.back(), 0.04, 1e-12);
    EXPECT_NEAR(scale.share(0.0202), 0.5, 1e-6);
    const drawing::ColorScale fine = drawing::make_scale(-0.3e-6, 1.2e-6, "displacement", drawing::length_units);
    EXPECT_EQ(fine.labels, (std::vector<std::string>{"0.0", "0.5", "1.0"}));
    const drawing::ColorScale still = drawing::make_scale(0, 0, "displacement", drawing::length_units);
    EXPECT_LT(still.lowest, still.highest) << "a run in which nothing moves has a scale, too";
}

TEST(ColorScale, EveryLabelTimesItsUnitIsItsTick)
{
    const std::map<std::string, double> pascals = {{"[Pa]", 1}, {"[kPa]", 1e3}, {"[MPa]", 1e6}};
    for (const double highest : {3.0, 40e3, 0.7e6, 1.16e6, 95e6}) {
        const drawing::ColorScale scale =
            drawing::make_scale(-0.1 * highest, highest, "stress", drawing::stress_units);
        const double unit = pascals.at(scale.caption.substr(7));
        ASSERT_GE(scale.ticks.size(), 3U);
        for (std::size_t i = 0; i < scale.ticks.size(); ++i) {
            EXPECT_NEAR(std::stod(scale.labels[i]) * unit, scale.ticks[i], 1e-9 * highest);
            EXPECT_GE(scale.share(scale.ticks[i]), -1e-6F);
            EXPECT_LE(scale.share(scale.ticks[i]), 1 + 1e-6F);
        }
    }
}

/// Lightness L* of a colour given in sRGB. Source: [CIE15-2004], [IEC61966-2-1-1999].
double lightness(const drawing::Rgb& color)
{
    double luminance = 0;
    const double weights[] = {0.2126, 0.7152, 0.0722};
    for (int i = 0; i < 3; ++i) {
        const double c = color[i];
        luminance += weights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
    }
    return 116 * std::cbrt(luminance) - 16;
}

TEST(Viridis, LightnessRisesEvenly)
{
    double before = lightness(drawing::viridis(0));
    EXPECT_LT(before, 20);
    for (int i = 1; i <= 10; ++i) {
        const double now = lightness(drawing::viridis(static_cast<float>(i) / 10));
        EXPECT_NEAR(now - before, 7.6, 1.6) << i;
        before = now;
    }
    EXPECT_GT(before, 85);
}

TEST(Camera, AllPointsFillTheAreaAndNoneLeavesIt)
{
    const PictureArea area{-0.9, 0.7, -0.8, 0.75};
    const std::vector<Vector3d> sizes = {{45, 4, 6}, {3, 3, 40}, {2, 60, 5}, {1, 1, 1}};
    for (int i = 0; i < 8; ++i) {
        const Vector3d size = sizes[i / 2];
        const View view = i % 2 == 0 ? View::from_aside : View::straight_on;
        std::vector<Vector3d> points;
        points.reserve(8);
        for (int corner = 0; corner < 8; ++corner) {
            points.push_back(Vector3d(corner & 1, corner >> 1 & 1, corner >> 2).cwiseProduct(size));
        }
        const Camera camera = camera_for(points, area, 16.0 / 9, view);
        Eigen::Vector2d low(9, 9), high(-9, -9);
        for (const Vector3d& point : points) {
            const Eigen::Vector4d clip = camera.view_projection * point.homogeneous();
            const Eigen::Vector3d place = clip.head<3>() / clip.w();
            EXPECT_LT(std::abs(place.z()), 1) << "between the near and the far plane";
            low = low.cwiseMin(place.head<2>());
            high = high.cwiseMax(place.head<2>());
        }
        EXPECT_GE(low.x(), area.left - 1e-3);
        EXPECT_LE(high.x(), area.right + 1e-3);
        EXPECT_GE(low.y(), area.bottom - 1e-3);
        EXPECT_LE(high.y(), area.top + 1e-3);
        const double filled = std::max((high.x() - low.x()) / 1.6, (high.y() - low.y()) / 1.55);
        EXPECT_NEAR(filled, 1, 1e-3) << size.transpose();
        EXPECT_NEAR((low.x() + high.x()) / 2, -0.1, 1e-3) << "in the middle of the area";
    }
}

TEST(Camera, TheLongAxisLiesAcrossThePicture)
{
    const std::vector<Vector3d> wall = {{0, 0, 0}, {0, 60, 0}, {1, 60, 5}, {1, 0, 5}};
    const Camera camera = camera_for(wall, {}, 1.6, View::from_aside);
    EXPECT_GT(std::abs(camera.right.y()), 0.8);
    EXPECT_EQ(camera.right.z(), 0);
    EXPECT_GT(camera.back.z(), 0.1) << "from above";
    EXPECT_EQ(camera_for(wall, {}, 1.6, View::straight_on).right, Vector3d::UnitX()) << "whatever its extents";
}

TEST(JointFaces, AreTheTwoThatFaceEachOther)
{
    const Case the_case = synthetic::arch(Kinematics::spatial_rigid, 9);
    const Model& model = the_case.model;
    const State state = initial_state(model);
    const results::SurfaceMesh mesh = results::surface_mesh_of(model);
    const std::vector<double> positions = results::positions_of(mesh, model.kinematics, state);
    std::vector<Vector3d> places;
    for (std::size_t i = 0; i < positions.size(); i += 3) places.emplace_back(positions.data() + i);
    const std::vector<WatchedJoint> joints = joints_at_start(model, state);
    ASSERT_EQ(joints.size(), 10U);
    for (const WatchedJoint& joint : joints) {
        const bool on_ground = model.blocks[joint.block_a].group == 1 || model.blocks[joint.block_b].group == 1;
        const std::vector<int> faces = faces_of_joint(mesh, places, joint);
        if (on_ground) continue;  // checked by the tower below
        ASSERT_EQ(faces.size(), 2U);
        EXPECT_EQ(mesh.face_block[faces[0]], joint.block_a);
        EXPECT_EQ(mesh.face_block[faces[1]], joint.block_b);
        for (const int face : faces) {  // the joint is the face of 1 m x 2 m that both blocks have
            for (int i = mesh.face_first[face]; i < mesh.face_first[face + 1]; ++i) {
                EXPECT_LT((places[mesh.face_vertices[i]] - joint.centre).norm(), 1.3);
            }
        }
    }
}

TEST(JointFaces, AFloorIsNotOutlinedUnderAPillar)
{
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid, 1);
    const results::SurfaceMesh mesh = results::surface_mesh_of(the_case.model);
    const State state = initial_state(the_case.model);
    const std::vector<double> positions = results::positions_of(mesh, the_case.model.kinematics, state);
    std::vector<Vector3d> places;
    for (std::size_t i = 0; i < positions.size(); i += 3) places.emplace_back(positions.data() + i);
    WatchedJoint joint;  // the floor, block 0, lies under the pillar, block 1
    joint.block_b = 1;
    joint.normal = {0, 0, -1};
    const std::vector<int> faces = faces_of_joint(mesh, places, joint);
    ASSERT_EQ(faces.size(), 1U);
    EXPECT_EQ(mesh.face_block[faces[0]], 1);
}

/// A frame of an arch at the start, in which only what a test says of its joints has happened.
results::RecordedFrame still_frame(const results::ResultsReader& results)
{
    results::RecordedFrame frame = results.frame(0);
    EXPECT_EQ(frame.joints.size(), 10U);
    EXPECT_EQ(frame.contacts.size(), 10U);
    return frame;
}

TEST(Scene, MarksJointsBeyondTheThresholdOnly)
{
    const TemporaryFolder folder;
    const results::ResultsReader results =
        run_of(synthetic::arch(Kinematics::spatial_deformable, 9), folder.path());
    results::RecordedFrame frame = still_frame(results);
    EXPECT_EQ(make_scene(results.model, frame, {}).opened_joints, 0) << "the first frame has its joints closed";
    EXPECT_EQ(make_scene(results.model, frame, {}).slid_joints, 0);
    for (const std::size_t joint : {2U, 7U}) frame.joints[joint].motion.opening = 2e-3;
    for (const std::size_t joint : {3U, 5U, 7U}) frame.joints[joint].motion.largest_slip = 2e-3;
    frame.joints[8].motion = {0.9e-4, 0, 0, 0.9e-4};
    SceneOptions options;  // 0.1 mm
    const Scene scene = make_scene(results.model, frame, options);
    EXPECT_EQ(scene.opened_joints, 2);
    EXPECT_EQ(scene.slid_joints, 2) << "what has opened too is marked as open";
    EXPECT_EQ(scene.opened.size(), 2U * 2U * 4U) << "the outlines of both faces";
    options.joint_threshold = 3e-3;
    EXPECT_EQ(make_scene(results.model, frame, options).opened_joints, 0);
    EXPECT_EQ(make_scene(results.model, frame, options).slid_joints, 0);
}

TEST(Scene, AJointThatHasSlidApartIsOpen)
{
    const TemporaryFolder folder;
    const results::ResultsReader results =
        run_of(synthetic::arch(Kinematics::spatial_deformable, 9), folder.path());
    results::RecordedFrame apart = still_frame(results);
    apart.contacts.pop_back();
    EXPECT_EQ(make_scene(results.model, apart, {}).opened_joints, 0) << "it has not moved";
    apart.joints.back().motion.largest_slip = 1;
    EXPECT_EQ(make_scene(results.model, apart, {}).opened_joints, 1);
    EXPECT_EQ(make_scene(results.model, apart, {}).slid_joints, 0);
}

TEST(Scene, IsSeenFromTheGround)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::tower(Kinematics::spatial_rigid);
    const results::ResultsReader results = run_of(the_case, folder.path());
    SceneOptions options;
    options.deformation_scale = 10;
    const Scene scene = make_scene(results.model, results.frame(20), options);
    EXPECT_NEAR(scene.ground.x(), 0.1, 1e-12);
    double top = 0;
    for (const Triangle& triangle : scene.triangles) {
        for (int k = 0; k < 3; ++k) {
            if (triangle.foundation) {
                EXPECT_LE(std::abs(triangle.corners[k].x()), 3 + 1e-12) << "stands still";
            } else {
                top = std::max(top, triangle.values[k]);
            }
        }
    }
    // the uppermost drum, at 7.5 m, moves 4 mm x 2 x 7.5 sideways and half of that down
    EXPECT_NEAR(top, std::hypot(0.06, 0.03), 1e-12);
}

TEST(Extrusion, IsClosedAndAsThickAsTheScene)
{
    const Case the_case = synthetic::arch(Kinematics::planar_rigid, 9);
    const results::SurfaceMesh mesh = extruded(results::surface_mesh_of(the_case.model), the_case.model.thickness);
    ASSERT_EQ(mesh.face_block.size(), 11U * 6U);
    std::vector<double> volume(11, 0);  // by the divergence theorem: outward faces alone give it, and positive
    for (std::size_t face = 0; face < mesh.face_block.size(); ++face) {
        const auto corner = [&](int i) {
            return Vector3d(mesh.levers.data() + 3 * mesh.face_vertices[mesh.face_first[face] + i]);
        };
        for (int i = 1; i + 1 < mesh.face_first[face + 1] - mesh.face_first[face]; ++i)
            volume[mesh.face_block[face]] += corner(0).dot(corner(i).cross(corner(i + 1))) / 6;
    }
    for (int b = 0; b < 11; ++b) EXPECT_NEAR(volume[b], the_case.model.blocks[b].moments.volume, 1e-12) << b;
    for (int v = mesh.block_first_vertex[4]; v < mesh.block_first_vertex[5]; ++v) {
        EXPECT_EQ(mesh.vertex_block[v], 4);
        EXPECT_EQ(std::abs(mesh.levers[3 * v + 1]), 1);
    }
}

TEST(Extrusion, APlanarSceneIsMarkedAsTheSpatialOne)
{
    const auto marks = [](Kinematics kinematics, std::vector<JointNow>& joints) {
        const TemporaryFolder folder;
        const results::ResultsReader results = run_of(synthetic::arch(kinematics, 9), folder.path());
        results::RecordedFrame frame = results.frame(10);
        joints = frame.joints;
        for (JointNow& joint : frame.joints) joint.motion = {};
        frame.joints[3].motion.opening = frame.joints[5].motion.largest_slip = 1e-3;
        return make_scene(in_space(results.model), frame, {});
    };
    std::vector<JointNow> of_plane, of_space;
    const Scene plane = marks(Kinematics::planar_rigid, of_plane),
                space = marks(Kinematics::spatial_rigid, of_space);
    EXPECT_EQ(plane.opened_joints, 1);
    EXPECT_EQ(plane.slid_joints, 1);
    EXPECT_EQ(plane.opened.size(), space.opened.size());
    EXPECT_EQ(plane.slid.size(), space.slid.size());
    EXPECT_EQ(plane.triangles.size(), space.triangles.size());
    EXPECT_NEAR(plane.triangles.back().values[0], space.triangles.back().values[0], 1e-12);
    ASSERT_EQ(of_plane.size(), of_space.size());
    double largest = 0;
    for (std::size_t i = 0; i < of_plane.size(); ++i) {
        EXPECT_NEAR(of_plane[i].motion.opening, of_space[i].motion.opening, 1e-9);
        EXPECT_NEAR(of_plane[i].motion.mean_opening, of_space[i].motion.mean_opening, 1e-9);
        EXPECT_NEAR(of_plane[i].motion.slip, of_space[i].motion.slip, 1e-9);
        largest = std::max(largest, of_plane[i].motion.opening);
    }
    EXPECT_GT(largest, 1e-3) << "the stones sway apart";
}

}  // namespace
}  // namespace voussoir::app::render
