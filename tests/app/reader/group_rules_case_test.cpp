// Groups by name and by place, and materials by group.
#include <gtest/gtest.h>

#include <map>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

/// A tower of six cubes of 1 m from z = 0, "cube" to "cube_6"; line 6 is the entry's.
const std::string tower = R"(materials: {stone: {density: 2000 kg/m3, young: 1 GPa, poisson: 0.2}}
joints: {j: {friction: 30 deg}}
stages: [{type: static}]
foundation: {blocks: foundation}
blocks:
  - {box: {name: cube, lower: [0, 0, 0], upper: [1, 1, 1]}, copy: {copies: 5, step: [0, 0, 1]}, groups: {foundation: cube}}
)";

/// The groups of a case's blocks, one letter of each: "fmmmmm".
std::string groups_in(const std::string& text, const std::vector<std::string>& overrides = {})
{
    const Model model = read(text, overrides).model;
    std::string letters;
    for (const Block& block : model.blocks) letters += model.groups[block.group][0];
    return letters;
}

std::string groups_of(const std::string& groups, const std::vector<std::string>& more = {})
{
    std::vector<std::string> overrides = {"blocks[0].groups=" + groups};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return groups_in(tower, overrides);
}

std::string fault_of(const std::string& groups)
{
    return faults_of(tower, {"blocks[0].groups=" + groups});
}

TEST(GroupRules, TakeTheLowestAndTheHighestStones)
{
    EXPECT_EQ(groups_of("{foundation: {lowest: 0 %}}"), "fmmmmm");
    EXPECT_EQ(groups_of("{foundation: {lowest: 16 %}}"), "fmmmmm") << "the second one stands at 16.7 %";
    EXPECT_EQ(groups_of("{foundation: {lowest: 17 %}}"), "ffmmmm");
    EXPECT_EQ(groups_of("{foundation: {lowest: 99 cm}}"), "fmmmmm");
    EXPECT_EQ(groups_of("{foundation: {lowest: 2 m}}"), "fffmmm");
    EXPECT_EQ(groups_of("{foundation: {lowest: 0 %}, top: {highest: 40 %}}"), "fmmttt");
    EXPECT_EQ(groups_of("{foundation: {highest: 100 %}}"), "ffffff");
    EXPECT_EQ(groups_of("{foundation: {lowest: 17 %}}", {"blocks[0].move=[0, 0, -100]"}), "ffmmmm")
        << "of the stones' own height, wherever they stand";
}

TEST(GroupRules, TakeStonesWhoseCentroidIsInABox)
{
    EXPECT_EQ(groups_of("{foundation: {inside: {lower: [0, 0, 0.4], upper: [1, 1, 2.5]}}}"), "fffmmm");
    EXPECT_EQ(groups_of("{foundation: {inside: {lower: [0, 0, 0.4], upper: [1, 1, 2.5]}}}",
                        {"blocks[0].move=[0, 0, -2]"}),
              "mmfffm");
    EXPECT_EQ(groups_of("{foundation: [cube, {inside: {lower: [0, 0, 5], upper: [1, 1, 6]}}]}"), "fmmmmf")
        << "several rules for one group";
}

TEST(GroupRules, TakeStonesThatTouchAGroup)
{
    EXPECT_EQ(groups_of("{foundation: {lowest: 0 %}, second: {touching: foundation}}"), "fsmmmm");
    EXPECT_EQ(groups_of("{foundation: cube_3, near: {touching: foundation}}"), "mnfnmm");
    EXPECT_EQ(
        fault_of("{foundation: cube, third: {touching: second}, second: {touching: foundation}}"),
        "--set blocks[0].groups: blocks[0].groups.third.touching: no block is in group \"second\" yet; rules by "
        "touch act in the order of writing: write that of the group first");
}

TEST(GroupRules, TouchAcrossEntriesAndInOrder)
{
    const std::string text =
        tower +
        "  - {box: {name: slab, lower: [1, 0, 0], upper: [2, 1, 2]}, groups: {near: {touching: "
        "foundation}}}\n"
        "  - {box: {name: edge, lower: [1, 1, 2], upper: [2, 2, 3]}, group: other}\n";
    EXPECT_EQ(groups_in(text), "fmmmmmno") << "the slab leans on the lowest cube; the last one meets edges only";
    EXPECT_NE(faults_of(text, {"blocks[2].groups={near: {touching: foundation}}"})
                  .find("\"foundation\" matches no stone left over from earlier rules"),
              std::string::npos);
    EXPECT_EQ(
        groups_in(text, {"blocks[0].groups={foundation: cube, second: {touching: foundation}, third: {touching: "
                         "second}}"}),
        "fstmmmno")
        << "a later rule finds what an earlier one took";
}

TEST(GroupRules, FirstThatFitsTakesAStone)
{
    EXPECT_EQ(groups_of("{foundation: {lowest: 0 %}, all: \"*\"}"), "faaaaa");
    EXPECT_EQ(groups_of("{all: \"*\"}", {"foundation=null"}), "aaaaaa");
    EXPECT_EQ(groups_of("{foundation: {lowest: 0 %}}", {"blocks[0].group=rest"}), "frrrrr")
        << "group is for those left over";
}

TEST(GroupRules, WorkInThePlane)
{
    const std::vector<std::string> planar = {"kinematics=planar_rigid",
                                             "blocks[0].box={name: cube, lower: [0, 0], upper: [1, 1]}",
                                             "blocks[0].copy={copies: 5, step: [0, 1]}"};
    EXPECT_EQ(groups_of("{foundation: {lowest: 17 %}, near: {touching: foundation}}", planar), "ffnmmm");
    EXPECT_EQ(groups_of("{foundation: {inside: {lower: [0, 1], upper: [1, 2]}}}", planar), "mfmmmm");
}

TEST(GroupRules, HoldStonesInFoundations)
{
    const Model model = read(tower, {"blocks[0].groups={foundation: {lowest: 20 %}}"}).model;
    ASSERT_EQ(model.foundations.size(), 2U);
    EXPECT_EQ(model.blocks[model.foundations[1].block].name, "cube_2");
}

TEST(GroupRules, NumberGroupsByTheirFirstBlock)
{
    const Model model = read(tower, {"blocks[0].groups={top: {highest: 0 %}, foundation: {lowest: 0 %}}"}).model;
    EXPECT_EQ(model.groups, (std::vector<std::string>{"foundation", "masonry", "top"}));
}

TEST(GroupRules, BadOnesAreRefusedInASentence)
{
    const std::string place = "--set blocks[0].groups: blocks[0].groups.foundation";
    EXPECT_EQ(fault_of("{foundation: {lowest: 0.05}}"),
              place +
                  ".lowest: \"0.05\" has no unit; the unit determines the meaning; expected a share of the height "
                  "such as 5 %, or a length such as 10 cm");
    EXPECT_EQ(fault_of("{foundation: {lowest: 5 kg}}").find(place + ".lowest: \"5 kg\" has the wrong dimension"),
              0U);
    EXPECT_EQ(
        fault_of("{foundation: {lowest: -5 %}}").find(place + ".lowest: -5 %; must be >= 0 and at most 100 %"),
        0U);
    EXPECT_EQ(fault_of("{foundation: {lowest: [1]}}").find(place + ".lowest: a list; expected a share"), 0U);
    EXPECT_EQ(fault_of("{foundation: {}}").find(place + ": no rule; give lowest, highest, inside or touching"),
              0U);
    EXPECT_EQ(fault_of("{foundation: {lowest: 1 %, highest: 1 %}}").find(place + ": more than one rule; give"),
              0U);
    EXPECT_EQ(fault_of("{foundation: {lowst: 1 %}}").find(place + ".lowst: unknown key; did you mean lowest?"),
              0U);
    EXPECT_EQ(fault_of("{foundation: {inside: {lower: [0, 0, 1], upper: [1, 1, 0]}}}")
                  .find(place + ".inside: no volume; upper must exceed lower along every axis"),
              0U);
    EXPECT_EQ(
        fault_of("{foundation: cube, near: {touching: fundation}}"),
        "--set blocks[0].groups: blocks[0].groups.near.touching: no block is in group \"fundation\"; did you mean "
        "foundation?");
    EXPECT_EQ(
        fault_of("{foundation: \"*\", low: {lowest: 5 %}}"),
        "--set blocks[0].groups: blocks[0].groups.low.lowest: 5 % matches no stone left over from earlier rules; "
        "a stone belongs to the first rule that fits it, by touch last");
    EXPECT_EQ(fault_of("{foundation: \"*\", low: \"cube_1\"}"),
              "--set blocks[0].groups: blocks[0].groups.low: \"cube_1\" matches no stone left over from earlier "
              "patterns; the block is named cube");
}

/// The materials of the tower's blocks, one letter of each.
std::string materials_in(const std::vector<std::string>& overrides)
{
    const Model model = read(tower, overrides).model;
    std::string letters;
    for (const Block& block : model.blocks) letters += model.materials[block.material].name[0];
    return letters;
}

const std::string brick = "materials.brick={density: 1800 kg/m3, young: 1 GPa, poisson: 0.2}";

TEST(MaterialsByGroup, AreThoseOfTheStonesGroups)
{
    EXPECT_EQ(materials_in({brick, "blocks[0].material=brick"}), "bbbbbb");
    EXPECT_EQ(materials_in({brick, "blocks[0].groups={foundation: {lowest: 17 %}}",
                            "blocks[0].material={foundation: stone, default: brick}"}),
              "ssbbbb");
    EXPECT_EQ(materials_in({brick, "blocks[0].material={foundation: stone, masonry: brick}"}), "sbbbbb");
    const Model model = read(tower, {brick, "blocks[0].material={foundation: stone, masonry: brick}"}).model;
    EXPECT_DOUBLE_EQ(model.mass(0), 2000);
    EXPECT_DOUBLE_EQ(model.mass(5), 1800);
}

TEST(MaterialsByGroup, BadOnesAreRefusedInASentence)
{
    const auto fault = [](const std::string& material) {
        return faults_of(tower, {brick, "blocks[0].material=" + material});
    };
    EXPECT_EQ(
        fault("{fundation: stone, default: brick}"),
        "--set blocks[0].material: blocks[0].material.fundation: no group \"fundation\" in this entry; did you "
        "mean foundation?");
    EXPECT_EQ(
        fault("{foundation: stnoe, default: brick}"),
        "--set blocks[0].material: blocks[0].material.foundation: no material \"stnoe\"; did you mean stone?");
    EXPECT_EQ(
        fault("{foundation: stone}"),
        "case.yaml:6: blocks[0]: no material for group \"masonry\", of cube_2; name it in material, or give a "
        "default there");
    EXPECT_EQ(fault("[stone]"), "--set blocks[0].material: a list; expected a text");
}

}  // namespace
}  // namespace voussoir::app::reader
