// Meshes that a case scales, mirrors, turns, moves and copies: the helper program places them before it judges
// them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <set>
#include <sstream>

#include "libdda/contact/initial_contacts.h"
#include "libdda/model/state.h"
#include "libdda/run/run.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A tetrahedron that is no image of itself, "chiral", and an L of a beam, "beam", that has to be divided: in mm.
const std::string stones_obj = R"(o chiral
v 0 0 0
v 1000 0 0
v 300 700 0
v 100 200 500
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
o beam
v 3000 0 0
v 5000 0 0
v 5000 400 0
v 3500 400 0
v 3500 1000 0
v 3000 1000 0
v 3000 0 300
v 5000 0 300
v 5000 400 300
v 3500 400 300
v 3500 1000 300
v 3000 1000 300
f 10 9 8 7 6 5
f 11 12 13 14 15 16
f 5 6 12 11
f 6 7 13 12
f 7 8 14 13
f 8 9 15 14
f 9 10 16 15
f 10 5 11 16
)";

const std::string scene = R"(materials: {m: {density: 2000 kg/m3, young: 1 GPa, poisson: 0.2}}
joints: {j: {friction: 30 deg}}
stages: [{type: static}]
)";

/// The blocks of entries of `stones.obj`.
class PlacedMesh : public testing::Test
{
 protected:
    Model model_of(const std::string& entries, const std::string& mesh = stones_obj) const
    {
        folder_.write("stones.obj", mesh);
        return read_case(folder_.write("case.yaml", scene + "blocks:\n" + entries), {}).model;
    }
    std::vector<Block> blocks_of(const std::string& keys) const
    {
        return model_of("  - {mesh: stones.obj, unit: mm" + keys + "}\n").blocks;
    }
    std::string fault_of(const std::string& entries) const
    {
        try {
            model_of(entries);
        } catch (const InputError& error) {
            return error.what();
        }
        return "no fault";
    }

    const TemporaryFolder folder_;
};

void expect_image(const Block& image, const Block& original, const Matrix3d& linear, const Vector3d& offset)
{
    const double grown = std::abs(linear.determinant());
    const Moments &is = image.moments, &was = original.moments;
    EXPECT_NEAR(is.volume, grown * was.volume, 1e-11 * is.volume) << image.name;
    EXPECT_NEAR((is.centroid - linear * was.centroid - offset).norm(), 0, 1e-12) << image.name;
    EXPECT_TRUE(is.second.isApprox(grown * linear * was.second * linear.transpose(), 1e-10)) << image.name;
    EXPECT_NEAR(moments_of(image.parts).volume, is.volume, 1e-11 * is.volume) << "and so do its parts";
}

TEST_F(PlacedMesh, MirroredStonesHaveMirroredMoments)
{
    const std::vector<Block> drawn = blocks_of(""), image = blocks_of(", mirror: {plane: x, at: 1}");
    ASSERT_EQ(image.size(), 2U);
    EXPECT_NEAR(drawn[0].moments.volume, 0.7 * 0.5 / 6, 1e-14);
    EXPECT_NEAR(drawn[1].moments.volume, 0.3 * (2 * 0.4 + 0.5 * 0.6), 1e-14);
    ASSERT_GT(std::abs(drawn[0].moments.second(0, 1)), 1e-5) << "or its image would be itself";
    for (int b = 0; b < 2; ++b) {
        expect_image(image[b], drawn[b], Vector3d(-1, 1, 1).asDiagonal(), {2, 0, 0});
        EXPECT_EQ(image[b].name, drawn[b].name);
        EXPECT_EQ(image[b].parts.size(), drawn[b].parts.size());
    }
}

TEST_F(PlacedMesh, EveryCopyIsScaledTurnedAndMoved)
{
    const std::vector<Block> drawn = blocks_of("");
    const std::vector<Block> placed = blocks_of(
        ", scale: [2, 1, 3], rotate: {axis: [1, 1, 0], angle: 25 deg, about: [0, 1, 0]}, move: [0, 0, 5], "
        "copy: [{copies: 1, step: [20, 0, 0]}, {mirror: {plane: y, at: -10}}]");
    ASSERT_EQ(placed.size(), 8U);
    const Matrix3d turned =
        Eigen::AngleAxisd(25 * std::numbers::pi / 180, Vector3d(1, 1, 0).normalized()).toRotationMatrix();
    const Matrix3d linear = turned * Matrix3d(Vector3d(2, 1, 3).asDiagonal());
    const Vector3d offset = Vector3d(0, 1, 5) - turned * Vector3d(0, 1, 0);
    const Matrix3d mirror = Vector3d(1, -1, 1).asDiagonal();
    for (int b = 0; b < 2; ++b) {
        expect_image(placed[b], drawn[b], linear, offset);
        expect_image(placed[2 + b], drawn[b], linear, offset + Vector3d(20, 0, 0));
        expect_image(placed[6 + b], drawn[b], mirror * linear,
                     mirror * (offset + Vector3d(20, 10, 0)) - Vector3d(0, 10, 0));
    }
    EXPECT_EQ(placed[3].name, "beam_2");
    EXPECT_EQ(placed[6].name, "chiral_2_mirrored");
}

TEST_F(PlacedMesh, OneFileMayStandTwice)
{
    const std::string twice = "  - {mesh: stones.obj, unit: mm}\n  - {mesh: stones.obj, unit: mm, move: [0, 9, 0]";
    const Model model = model_of(twice + ", suffix: _north, group: north}\n");
    ASSERT_EQ(model.blocks.size(), 4U);
    EXPECT_EQ(model.blocks[3].name, "beam_north");
    EXPECT_EQ(model.groups[model.blocks[3].group], "north");
    expect_image(model.blocks[3], model.blocks[1], Matrix3d::Identity(), {0, 9, 0});
    EXPECT_NE(fault_of(twice + "}\n").find("a second block named chiral"), std::string::npos);
}

TEST_F(PlacedMesh, FarCopiesGetAnOriginOfTheirOwn)
{
    const Model model = model_of("  - {mesh: stones.obj, unit: mm, move: [5e6, 0, 0]}\n");
    EXPECT_GT(model.origin.x(), 4e6);
    EXPECT_NEAR(model.blocks[0].moments.volume, 0.7 * 0.5 / 6, 1e-9);
}

TEST_F(PlacedMesh, BadPlacesAreRefusedInASentence)
{
    const auto fault = [&](const std::string& keys) {
        const std::string all = fault_of("  - {mesh: stones.obj, " + keys + "}\n");
        return all.substr(std::min(all.find("case.yaml"), all.size()));
    };
    const std::string place = "case.yaml:5: blocks[0].mesh: stones.obj: ";
    EXPECT_NE(fault("scale: 1e200").find("chiral: it is too large or too far away; check scale"),
              std::string::npos);
    EXPECT_NE(fault("move: [0, 1e300, 0]").find("too far away"), std::string::npos);
    EXPECT_NE(fault("scale: 1e-150").find("nothing is left of its size"), std::string::npos);
    EXPECT_EQ(fault("move: [1e15, 0, 0]").find(place + "chiral: it is so far away that its shape is rounded"), 0U);
    for (const char* keys : {"scale: 1e90", "scale: 1e-90"})
        EXPECT_TRUE(fault(keys) == "no fault" || fault(keys).find(place) == 0) << fault(keys);
    EXPECT_EQ(fault("suffix: ''"), "case.yaml:5: blocks[0].suffix: an empty text; expected a text");
}

/// One voussoir of a ring of 24, between the radii 4 and 5 m, 1 m high, drawn along x.
std::string sector()
{
    std::ostringstream text;
    text.precision(17);
    text << "o stone\n";
    for (const double z : {0., 1.})
        for (const auto& [radius, side] : {std::pair{4., -1}, {5., -1}, {5., 1}, {4., 1}})
            text << "v " << radius * std::cos(std::numbers::pi / 24) << " "
                 << side * radius * std::sin(std::numbers::pi / 24) << " " << z << "\n";
    text << "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    return text.str();
}

TEST_F(PlacedMesh, AClosedRingOfCopiesTouchesAllAround)
{
    const Model model = model_of(
        "  - {mesh: stones.obj, groups: {two: {touching: one}, one: stone_12}, copy: {copies: 23, rotate: {axis: "
        "z, "
        "angle: 15 deg}}}\n",
        sector());
    ASSERT_EQ(model.blocks.size(), 24U);
    State state = initial_state(model);
    find_initial_contacts(model, state);
    double area = 0;
    for (const ContactPatch& patch : state.contacts.patches)
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            area += state.contacts.points[i].area;
            EXPECT_NEAR(state.contacts.points[i].gap, 0, 1e-14);
        }
    EXPECT_EQ(state.contacts.patches.size(), 24U);
    EXPECT_NEAR(area, 24 * 1, 1e-10);
    double volume = 0;
    Vector3d first = Vector3d::Zero();
    for (const Block& block : model.blocks) {
        volume += block.moments.volume;
        first += block.moments.volume * block.moments.centroid;
    }
    EXPECT_NEAR(volume, 24 * (25 - 16) * std::sin(std::numbers::pi / 12) / 2, 1e-11);
    EXPECT_NEAR((first / volume - Vector3d(0, 0, 0.5)).norm(), 0, 1e-13);
    for (int b = 0; b < 24; ++b)
        EXPECT_EQ(model.groups[model.blocks[b].group], b == 11 ? "one" : b == 10 || b == 12 ? "two" : "masonry");
    EXPECT_NE(fault_of("  - {mesh: stones.obj, copy: {copies: 2, step: [1 mm, 0, 0]}}\n").find("overlap by"),
              std::string::npos);
}

struct Joints {
    std::size_t pairs = 0;
    double area = 0, volume = 0;  // m2, m3 of all stones
};

Joints joints_of(const Model& model)
{
    State state = initial_state(model);
    find_initial_contacts(model, state);
    Joints joints;
    std::set<std::pair<int, int>> pairs;
    for (const ContactPatch& patch : state.contacts.patches) {
        if (patch.edge_edge) continue;
        pairs.insert(std::minmax(patch.block_a, patch.block_b));
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            joints.area += state.contacts.points[i].area;
    }
    joints.pairs = pairs.size();
    for (const Block& block : model.blocks) joints.volume += block.moments.volume;
    return joints;
}

/// A structure that is mirrored, turned obliquely and moved away is the same structure: stones, joints and all.
void expect_same_structure(const std::filesystem::path& mesh)
{
    SCOPED_TRACE(mesh);
    const TemporaryFolder folder;
    const std::string text = scene + "blocks: [{mesh: " + mesh.string() + "}]\n";
    const auto joints_with = [&](const std::vector<std::string>& overrides) {
        return joints_of(read_case(folder.write("case.yaml", text), overrides).model);
    };
    const Joints drawn = joints_with({});
    const Joints placed =
        joints_with({"blocks[0].mirror={plane: y, at: 3}", "blocks[0].rotate={axis: [1, 2, 3], angle: 40 deg}",
                     "blocks[0].move=[100, -20, 3]"});
    EXPECT_EQ(placed.pairs, drawn.pairs);
    EXPECT_NEAR(placed.area, drawn.area, 1e-5 * drawn.area);
    EXPECT_NEAR(placed.volume, drawn.volume, 1e-5 * drawn.volume);
    EXPECT_GT(drawn.pairs, 5U);
}

TEST(PlacedStructures, KeepTheirJoints)
{
    expect_same_structure(VOUSSOIR_CASES "/meshes/mosca_bridge.obj");
    expect_same_structure(VOUSSOIR_CASES "/meshes/dome_slice.obj");
}

TEST(PlacedStructures, OfSurveysKeepTheirJointsToo)
{
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    if (!std::filesystem::exists(data / "meshes/masonry")) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    for (const char* name : {"bridge.json", "arch_assembly.json", "wall.obj", "wall_assembly.json"})
        expect_same_structure(data / "meshes/masonry" / name);
}

/// Volume of a solid whose section at every height is a regular polygon of n corners at the distance r(z) from its
/// axis, between the corners (r, z) of a profile: each piece is the frustum of a pyramid.
double volume_around(int n, const std::vector<Eigen::Vector2d>& profile)
{
    double sum = 0;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const Eigen::Vector2d &a = profile[i], &b = profile[(i + 1) % profile.size()];
        sum += (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) / 3;
    }
    return sum * n / 2 * std::sin(2 * std::numbers::pi / n);
}

TEST(DomeCase, IsADomeOnItsLowestCourse)
{
    const Model model = read_case(VOUSSOIR_CASES "/dome.yaml", {"output=null"}).model;
    ASSERT_EQ(model.blocks.size(), 168U);
    std::vector<Eigen::Vector2d> profile;
    for (int i = 0; i < 16; ++i) {
        const double latitude = (i < 8 ? i : 15 - i) * 11 * std::numbers::pi / 180;
        profile.push_back((i < 8 ? 4.4 : 4) * Eigen::Vector2d(std::cos(latitude), std::sin(latitude)));
    }
    double volume = 0;
    for (const Block& block : model.blocks) volume += block.moments.volume;
    EXPECT_NEAR(volume, volume_around(24, profile), 1e-6 * volume);
    ASSERT_EQ(model.foundations.size(), 24U);
    for (const Foundation& foundation : model.foundations) {
        EXPECT_EQ(model.blocks[foundation.block].name.substr(0, 8), "course_1");
        EXPECT_EQ(model.materials[model.blocks[foundation.block].material].name, "granite");
    }
}

TEST(DomeCase, SinksAlikeAllAround)
{
    const Case the_case = read_case(VOUSSOIR_CASES "/dome.yaml",
                                    {"output=null", "foundation.motion=null", "stages=[{type: static}]"});
    const Model& model = the_case.model;
    State state = initial_state(model);
    const RunReport report = run(model, the_case.stages, state, {});
    ASSERT_EQ(report.outcome, Outcome::completed) << testing::PrintToString(report.diagnosis);
    const auto sinking = [&](int block) {
        return model.blocks[block].moments.centroid.z() - pose_of(model.kinematics, state, block).centroid.z();
    };
    for (int course = 1; course < 7; ++course)
        for (int slice = 1; slice < 24; ++slice)
            EXPECT_NEAR(sinking(course + 7 * slice), sinking(course), 5e-3 * sinking(6));
    EXPECT_GT(sinking(6), 1e-6);
    EXPECT_LT(sinking(6), 1e-3);
}

}  // namespace
}  // namespace voussoir::app::reader
