// Walls and houses in a case file: what they become, in space and in the plane, and what is said about bad ones.
#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "libdda/run/run.h"
#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

/// `two_boxes` with a wall and its openings instead of the boxes. Line numbers matter.
const std::string a_wall = R"(title: A wall
materials:
  granite: {density: 2400 kg/m3, young: 4.5 GPa, poisson: 0.25}
joints:
  dry: {friction: 30 deg}
blocks:
  - wall:
      length: 4 m
      height: 2.5 m
      thickness: 40 cm
      block: [50 cm, 25 cm]
      openings:
        - {at: 1 m, width: 75 cm, height: 1.75 m}
      base: {height: 30 cm, projection: 10 cm}
    groups: {foundation: "*_base", lintels: "*_lintel_*"}
foundation: {blocks: foundation}
stages:
  - {name: self-weight, type: static}
)";

const std::string a_house = with(
    with(with(with(a_wall, "- wall:", "- house:"), "thickness: 40 cm", "wall_thickness: 40 cm\n      width: 3 m"),
         "{at:", "{wall: east, at:"),
    "base: {height: 30 cm, projection: 10 cm}", "lintel: {height: 25 cm, bearing: 25 cm}");

double volume_of(const Model& model)
{
    double volume = 0;
    for (const Block& block : model.blocks) volume += block.moments.volume;
    return volume;
}

TEST(WallCase, BecomesBlocksInGroups)
{
    const Case the_case = read(a_wall);
    const Model& model = the_case.model;
    EXPECT_NEAR(volume_of(model), (4 * 2.5 - 0.75 * 1.75) * 0.4 + 4.2 * 0.6 * 0.3, 1e-12);
    EXPECT_EQ(model.blocks[0].name, "wall_base");
    EXPECT_EQ(model.groups[model.blocks[0].group], "foundation");
    ASSERT_EQ(model.foundations.size(), 1U);
    EXPECT_EQ(model.groups[model.blocks[1].group], "masonry");
    const auto lintels = std::count_if(model.blocks.begin(), model.blocks.end(),
                                       [&](const Block& block) { return model.groups[block.group] == "lintels"; });
    EXPECT_EQ(lintels, 1);
    EXPECT_TRUE(the_case.mesh_files.empty()) << "no helper is started";
    EXPECT_TRUE(has_default(the_case, "lintel = {height: 0.25 m, bearing: 0.25 m}"));
    EXPECT_TRUE(has_default(the_case, "openings[0]: sill = 0 m"));
    EXPECT_TRUE(has_default(the_case, "bond = running"));
}

TEST(WallCase, StandsWhereTheCaseSaysAndTurned)
{
    const Model model =
        read(a_wall, {"blocks[0].wall.origin=[10, 20 m, 3]", "blocks[0].wall.direction=90 deg"}).model;
    // The base, 4.2 m x 0.6 m, now lies along y, and the wall's thickness towards -x.
    EXPECT_TRUE(model.blocks[0].moments.centroid.isApprox(Eigen::Vector3d(9.8, 22, 2.85), 1e-14));
}

TEST(WallCase, HandsOnTheFrictionOfEachBlock)
{
    const std::vector<std::string> uneven = {"blocks[0].wall.imperfection={seed: 4, friction: 10 %}"};
    std::set<double> factors;
    for (const Block& block : read(a_wall, uneven).model.blocks) {
        EXPECT_NEAR(block.friction_factor, 1, 0.1);
        factors.insert(block.friction_factor);
    }
    EXPECT_EQ(factors.size(), read(a_wall).model.blocks.size());
    EXPECT_EQ(read(a_wall, uneven).model.blocks[0].friction_factor, 1) << "the base keeps 1";
    for (const Block& block : read(a_wall).model.blocks) EXPECT_EQ(block.friction_factor, 1);
}

TEST(WallCase, IsAPlanarSceneToo)
{
    const std::string text =
        with(a_wall, "      base: {", "      imperfection: {size: 1 %, joint: 2 mm}\n      base: {");
    const Model model = read(text, {"kinematics=planar_rigid"}).model;
    EXPECT_DOUBLE_EQ(model.thickness, 0.4);
    EXPECT_EQ(model.blocks.size(), read(text).model.blocks.size());
    EXPECT_NEAR(model.mass(0), 4.2 * 0.3 * 0.4 * 2400, 1e-9);
    EXPECT_EQ(faults_of(a_wall, {"kinematics=planar_rigid", "blocks[0].wall.leaves=2"}),
              "--set blocks[0].wall.leaves: 2; a planar scene has one leaf");
    EXPECT_EQ(faults_of(a_wall, {"kinematics=planar_rigid", "blocks[0].wall.direction=0.1"}),
              "--set blocks[0].wall.direction: has no meaning here; a wall of a planar scene runs along x");
    EXPECT_EQ(
        faults_of(a_house, {"kinematics=planar_rigid", "foundation=null"}),
        "case.yaml:8: blocks[0].house: a house in a planar scene; use a wall, or set kinematics to a spatial one");
}

TEST(WallCase, HouseStandsOnASlabByDefault)
{
    const std::string text = with(a_house, "\"*_lintel_*\"", "\"*_east_lintel_1\"");
    const Case the_case = read(text);
    EXPECT_TRUE(has_default(the_case, "base = {height: 0.25 m}"));
    EXPECT_NEAR(volume_of(the_case.model), 2 * 0.4 * (4 + 3 - 0.8) * 2.5 - 0.75 * 1.75 * 0.4 + 4 * 3 * 0.25,
                1e-11);
    EXPECT_EQ(the_case.model.foundations.size(), 1U);
}

TEST(WallCase, BadWallsAreRefusedWithTheirLine)
{
    const auto fault = [](const std::string& old_part, const std::string& new_part) {
        return faults_of(with(a_wall, old_part, new_part));
    };
    EXPECT_EQ(
        fault("{at: 1 m,", "{at: 3.5 m,"),
        "case.yaml:13: blocks[0].wall.openings[0]: from 3.5 m to 4.25 m along wall; it must lie between 0 m and "
        "4 m");
    EXPECT_EQ(fault("[50 cm, 25 cm]", "[5 m, 25 cm]"),
              "case.yaml:11: blocks[0].wall.block: a block 5 m long in a wall of 4 m; the block must fit into the "
              "wall");
    EXPECT_EQ(fault("40 cm", "0 m"), "case.yaml:10: blocks[0].wall.thickness: 0 m; must be > 0");
    EXPECT_EQ(
        fault("height: 1.75 m}", "height: 1.75 m}\n        - {at: 1.5 m, width: 1 m, height: 2.5 m}"),
        "case.yaml:14: blocks[0].wall.openings[1]: the lintel over openings[0] and openings[1] overlap; leave "
        "some wall between them");
    EXPECT_EQ(fault("{at: 1 m,", "{at: 20 cm,"),
              "case.yaml:13: blocks[0].wall.openings[0]: its lintel would reach from -0.05 m to 1.2 m along wall; "
              "both bearings must lie between 0 m and 4 m");
    EXPECT_EQ(
        fault("block: [50 cm, 25 cm]", "block: 50 cm"),
        "case.yaml:11: blocks[0].wall.block: \"50 cm\"; expected length and height of a block, [60 cm, 30 cm]");
    EXPECT_EQ(fault("thickness:", "thicknes:"),
              "case.yaml:8: blocks[0].wall.thickness: missing; give a length such as 1.5 m\n"
              "case.yaml:10: blocks[0].wall.thicknes: unknown key; did you mean thickness?");
    EXPECT_EQ(fault("lintels: \"*_lintel_*\"", "lintels: \"*_lintel_2\""),
              "case.yaml:15: blocks[0].groups.lintels: \"*_lintel_2\" matches no stone left over from earlier "
              "patterns; blocks are named wall_base, ..., wall_c10_b09");
    EXPECT_EQ(
        faults_of(a_wall, {"blocks[1]={wall: {length: 1, height: 1, thickness: 1, block: [1, 1]}}"}),
        "--set blocks[1]: blocks[1].wall: a second block named wall_c01_b01; the first one is at case.yaml:8: "
        "blocks[0].wall: give one of them another name");
}

std::filesystem::path shipped(const std::string& name)
{
    return std::filesystem::path(VOUSSOIR_CASES) / name;
}

TEST(WallCase, ShippedCasesHaveTheBlocksTheyNeed)
{
    EXPECT_EQ(read_case(shipped("wall.yaml"), {}).model.blocks.size(), 73U);
    EXPECT_EQ(read_case(shipped("wall.yaml"), {"kinematics=planar_rigid"}).model.blocks.size(), 73U);
    EXPECT_EQ(read_case(shipped("house.yaml"), {}).model.blocks.size(), 201U);
    EXPECT_EQ(read_case(shipped("house_large.yaml"), {}).model.blocks.size(), 985U);
}

/// Force of the base on all that stands on it [N].
Eigen::Vector3d reaction_of_base(const State& state)
{
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    for (const ContactPatch& patch : state.contacts.patches) {
        if (patch.block_a != 0 && patch.block_b != 0) continue;
        const double sign = patch.block_b == 0 ? 1 : -1;  // forces act on block a
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i) {
            const ContactPoint& point = state.contacts.points[i];
            force += sign * (point.normal_force * patch.normal - point.shear_force);
        }
    }
    return force;
}

/// Joints that slide a little as the house settles are at their friction bound; they must not keep it from rest.
TEST(WallCase, TheShippedHouseStandsUnderItsOwnWeight)
{
    const Case the_case = read_case(shipped("house.yaml"), {"foundation.motion=null", "stages[1]=null"});
    State state = initial_state(the_case.model);
    const RunReport report = run(the_case.model, the_case.stages, state, {});
    EXPECT_EQ(report.outcome, Outcome::completed) << ::testing::PrintToString(report.diagnosis);
    EXPECT_LT(report.steps, 20);
    double weight = 0;
    for (int block = 1; block < static_cast<int>(the_case.model.blocks.size()); ++block)
        weight += the_case.model.mass(block) * the_case.stages[0].gravity.norm();
    const Eigen::Vector3d reaction = reaction_of_base(state);
    EXPECT_NEAR(reaction.z(), weight, 1e-7 * weight);
    EXPECT_LT(reaction.head<2>().norm(), 1e-7 * weight);
}

TEST(WallCase, OfTenThousandBlocksIsReadInSeconds)
{
    const auto begin = std::chrono::steady_clock::now();
    const Case the_case = read(a_wall, {"blocks[0].wall.length=100 m", "blocks[0].wall.height=12.5 m"});
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    EXPECT_GT(the_case.model.blocks.size(), 10000U);
    EXPECT_LT(seconds.count(), 10) << "on a busy machine";
}

}  // namespace
}  // namespace voussoir::app::reader
