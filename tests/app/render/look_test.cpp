// What pictures show beside the stones, and from where.
#include "app/render/look.h"

#include <gtest/gtest.h>

#include <numbers>

#include "app/render/framing.h"
#include "app/results/results_writer.h"
#include "libdda/errors.h"
#include "tests/app/command_test.h"
#include "tests/app/results/synthetic.h"
#include "tests/app/test_files.h"
#include "tests/temporary_folder.h"

namespace voussoir::app::render
{
namespace
{

using Eigen::Vector3d;

/// The results of an arch that has swayed for a second.
std::filesystem::path arch_in(const std::filesystem::path& folder)
{
    const Case the_case = synthetic::arch(Kinematics::spatial_rigid);
    results::ResultsWriter writer(the_case, folder);
    writer.frame(synthetic::swaying(the_case, 1), {});
    writer.finish(synthetic::swaying(the_case, 1), {}, {0, 0});
    return writer.results_file();
}

Scene scene_with(const Look& look)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = arch_in(folder.path());
    const results::ResultsReader results(file);
    return make_scene(results.model, results.frame(0),
                      {SnapshotColor::displacement, 1, noteworthy_opening, look_of(look, file, results)});
}

std::string refusal_of(const Look& look)
{
    try {
        scene_with(look);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

Eigen::Vector2d seen(const Camera& camera, const Vector3d& point)
{
    const Eigen::Vector4d clip = camera.view_projection * point.homogeneous();
    return clip.head<2>() / clip.w();
}

const std::vector<Vector3d> corners = {{0, 0, 0}, {4, 0, 0}, {0, 8, 0}, {4, 8, 0},
                                       {0, 0, 2}, {4, 0, 2}, {0, 8, 2}, {4, 8, 2}};
const PictureArea area{-0.8, 0.6, -0.7, 0.9};

TEST(Look, HidesStonesByNameByGroupAndByPlace)
{
    const std::size_t all = scene_with({}).triangles.size();
    Look look;
    look.hidden = {"foundation"};
    EXPECT_EQ(scene_with(look).triangles.size(), all - 2 * 12) << "a group of two boxes of twelve triangles";
    look.hidden = {"voussoir_?"};
    EXPECT_EQ(scene_with(look).triangles.size(), all - 9 * 12);
    look.hidden.clear();
    look.cuts = {"z>4"};
    const Scene cut = scene_with(look);
    EXPECT_LT(cut.triangles.size(), all);
    for (const Triangle& triangle : cut.triangles) EXPECT_LT(triangle.corners[0].z(), 5.1);
    const auto marks = [](const Scene& scene) { return scene.opened.size() + scene.slid.size(); };
    EXPECT_LT(marks(cut), marks(scene_with({}))) << "joints between stones that are left out are not marked";
}

TEST(Look, NamesStonesWhereTheyAre)
{
    Look look;
    look.labels = {"voussoir_1", "voussoir_1?"};
    const Scene scene = scene_with(look);
    ASSERT_EQ(scene.labels.size(), 7U) << "1, 10, 11, ..., 15";
    EXPECT_EQ(scene.labels[0].text, "voussoir_1");
    Framing framing(SnapshotColor::displacement);
    framing.add(scene);
    const std::vector<PlacedWord> words = placed_labels(scene, framing.camera(800, 500, true));
    EXPECT_LT(words[0].x, words[6].x) << "the first stone is on the left";
    EXPECT_NEAR(words[0].y, words[6].y, 0.05);
    EXPECT_LT(words[1].y, words[0].y) << "the tenth is higher, and y grows downwards";
}

TEST(Look, RefusalsNameWhatIsWrong)
{
    Look look;
    look.hidden = {"tower_*"};
    EXPECT_NE(refusal_of(look).find("\"tower_*\" is the name of no stone and of no group"), std::string::npos);
    look.hidden = {"*"};
    EXPECT_NE(refusal_of(look).find("no stone is left"), std::string::npos);
    look.hidden.clear();
    for (const char* cut : {"w>1", "x=1", "x>1m", "x>"}) {
        look.cuts = {cut};
        EXPECT_NE(refusal_of(look).find("give an axis, < or >"), std::string::npos) << cut;
    }
    for (const char* view : {"above", "1,2,3", "0,91", "400,0", "nan,0"})
        EXPECT_THROW(set_view(view, look), InputError);
}

TEST(Look, ViewsAreThoseOfADraughtsman)
{
    const auto from = [](const char* view) {
        Look look;
        set_view(view, look);
        return look_at(corners, area, 1.6, View::from_aside, look, 0);
    };
    EXPECT_LT((from("front").right - Vector3d::UnitX()).norm(), 1e-9);
    EXPECT_LT((from("right").right - Vector3d::UnitY()).norm(), 1e-9);
    EXPECT_LT((from("back").right + Vector3d::UnitX()).norm(), 1e-9);
    EXPECT_LT((from("left").right + Vector3d::UnitY()).norm(), 1e-9);
    EXPECT_LT((from("top").back - Vector3d::UnitZ()).norm(), 2e-3);
    EXPECT_LT((from("top").right - Vector3d::UnitX()).norm(), 1e-9);
    EXPECT_NEAR(from("30,20").back.z(), std::sin(20 * std::numbers::pi / 180), 1e-9);
}

TEST(Look, WithoutPerspectiveEqualLengthsAreEqualAndTheAreaIsFilled)
{
    Look look;
    look.orthographic = true;
    const Camera camera = look_at(corners, area, 1.6, View::from_aside, look, 0);
    const auto edge = [&](std::size_t a, std::size_t b) {
        return (seen(camera, corners[b]) - seen(camera, corners[a])).eval();
    };
    EXPECT_LT((edge(0, 1) - edge(6, 7)).norm(), 1e-12);
    EXPECT_LT((edge(0, 4) - edge(3, 7)).norm(), 1e-12);
    Eigen::Vector2d low(9, 9), high(-9, -9);
    for (const Vector3d& corner : corners) {
        low = low.cwiseMin(seen(camera, corner));
        high = high.cwiseMax(seen(camera, corner));
        const Eigen::Vector4d clip = camera.view_projection * corner.homogeneous();
        EXPECT_LT(std::abs(clip.z() / clip.w()), 1) << "between the near and the far plane";
    }
    EXPECT_NEAR(std::max((high.x() - low.x()) / 1.4, (high.y() - low.y()) / 1.6), 1, 1e-9);
    EXPECT_NEAR((low.x() + high.x()) / 2, -0.1, 1e-9);
    look.orthographic = false;
    const Camera with = look_at(corners, area, 1.6, View::from_aside, look, 0);
    EXPECT_GT(
        (seen(with, corners[1]) - seen(with, corners[0]) - seen(with, corners[7]) + seen(with, corners[6])).norm(),
        0.01)
        << "with perspective they differ";
}

TEST(Look, AnOrbitKeepsItsDistance)
{
    Look look;
    look.orbit = 2 * std::numbers::pi;
    double first = 0;
    for (int i = 0; i < 8; ++i) {
        const Camera camera = look_at(corners, area, 1.6, View::from_aside, look, i * look.orbit / 8);
        const double size = (seen(camera, {2, 4, 2}) - seen(camera, {2, 4, 0})).norm();
        if (i == 0) first = size;
        EXPECT_NEAR(size, first, 0.01 * first) << i;
        for (const Vector3d& corner : corners) EXPECT_LT(seen(camera, corner).cwiseAbs().maxCoeff(), 0.95);
    }
}

TEST(Look, ACameraThatFollowsKeepsItsStoneWhereItIs)
{
    const TemporaryFolder folder;
    const Case the_case = synthetic::arch(Kinematics::spatial_rigid);
    results::ResultsWriter writer(the_case, folder.path());
    for (const double time : {0.0, 5.0}) writer.frame(synthetic::swaying(the_case, time), {});
    writer.finish(synthetic::swaying(the_case, 5), {}, {0, 0});
    const results::ResultsReader results(writer.results_file());
    for (const char* followed : {"voussoir_3", "structure"}) {
        Look look;
        look.follow = followed;
        const SceneOptions options{SnapshotColor::displacement, 20, noteworthy_opening,
                                   look_of(look, writer.results_file(), results)};
        const Scene start = make_scene(results.model, results.frame(0), options),
                    later = make_scene(results.model, results.frame(1), options);
        Framing framing(SnapshotColor::displacement);
        framing.add(start);
        const Camera camera = framing.camera(800, 500, false);
        ASSERT_TRUE(start.followed && later.followed);
        EXPECT_GT((seen(camera, *later.followed) - seen(camera, *start.followed)).norm(), 0.05)
            << "a camera that stands still sees it go";
        const Camera moved = moved_with(camera, later, start.followed);
        EXPECT_LT((seen(moved, *later.followed) - seen(camera, *start.followed)).norm(), 1e-12) << followed;
        EXPECT_EQ(moved_with(camera, start, start.followed).view_projection, camera.view_projection);
    }
    Look look;
    look.follow = "nobody";
    EXPECT_NE(refusal_of(look).find("\"nobody\" is the name of no stone"), std::string::npos);
}

TEST(Look, TheStructureIsFollowedByItsCentreOfMass)
{
    Look look;
    look.follow = "structure";
    const Scene scene = scene_with(look);
    ASSERT_TRUE(scene.followed);
    // Half a ring of radii 4 and 5 m: its centroid is 4 (R^3 - r^3) / (3 pi (R^2 - r^2)) high, less what straight
    // chords cut off; after a second it leans 0.004 z and has sunk by 0.002 z.
    const double height = 4 * (125 - 64) / (3 * std::numbers::pi * (25 - 16));
    EXPECT_NEAR(scene.followed->z(), height, 0.02 * height);
    EXPECT_NEAR(scene.followed->x(), 0.004 * scene.followed->z(), 1e-3);
}

class LookOfARun : public CommandTest
{
};

TEST_F(LookOfARun, ForcesCarryTheWeightAndThrustGoesThroughTheStone)
{
    const std::string second = "  - {box: {name: stone, lower: [-0.5, -0.5, 0], upper: [50 cm, 0.5, 1]}}\n";
    folder_.write("case.yaml",
                  with(two_boxes, second,
                       second + "  - {box: {name: top, lower: [-0.5, -0.5, 1], upper: [0.5, 0.5, 2]}}\n"));
    ASSERT_EQ(voussoir("run case.yaml -o results -q --set stages[1]=null"), 0) << output_;
    const std::filesystem::path file = folder_.path() / "results/results.h5";
    const results::ResultsReader results(file);
    Look look;
    look.forces = true;
    const LookOfRun of_run = look_of(look, file, results);
    EXPECT_NEAR(of_run.largest_force, 2 * 2400 * 9.80665, 100) << "of two stones on the floor";
    const Scene scene = make_scene(results.model, results.frame(results.times.size() - 1),
                                   {SnapshotColor::displacement, 1, noteworthy_opening, of_run});
    ASSERT_EQ(scene.forces.size(), 2U);
    const Vector3d lower = scene.forces[0].to - scene.forces[0].from,
                   upper = scene.forces[1].to - scene.forces[1].from;
    EXPECT_NEAR(lower.norm() / upper.norm(), 2, 0.01) << "as long as they are large";
    EXPECT_LT(lower.head<2>().norm(), 0.01 * lower.norm());
    ASSERT_EQ(scene.thrust.size(), 1U) << "through the stone between";
    EXPECT_NEAR(std::abs(scene.thrust[0].to.z() - scene.thrust[0].from.z()), 1, 0.01);
    EXPECT_TRUE(make_scene(results.model, results.frame(0), {}).forces.empty()) << "unless asked for";
}

TEST_F(LookOfARun, IsAskedForOnTheCommandLine)
{
    folder_.write("case.yaml", two_boxes);
    ASSERT_EQ(voussoir("run case.yaml -o results -q"), 0) << output_;
    EXPECT_EQ(
        voussoir("render results/results.h5 --count 1 --size 400 300 --hide foundation --label 'st*' --view front "
                 "--orthographic --forces --color group"),
        0)
        << output_;
    EXPECT_NE(output_.find("snapshot_0001"), std::string::npos);
    EXPECT_NE(voussoir("render results/results.h5 --hide nobody"), 0);
    EXPECT_NE(output_.find("\"nobody\" is the name of no stone"), std::string::npos) << output_;
    EXPECT_EQ(
        voussoir(
            "render results/results.h5 --video film.mp4 --size 320 240 --orbit 90 --cut 'z>0.9' --follow stone"),
        0)
        << output_;
}

}  // namespace
}  // namespace voussoir::app::render
