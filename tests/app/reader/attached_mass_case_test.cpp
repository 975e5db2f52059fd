// Keys of a case that load blocks: attached_masses.
#include <gtest/gtest.h>

#include "tests/app/reader/case_reading.h"

namespace voussoir::app::reader
{
namespace
{

std::string case_with(const std::string& masses, const std::string& kinematics = "spatial_rigid")
{
    return "kinematics: " + kinematics + R"(
materials: {stone: {density: 2000 kg/m3, young: 5 GPa, poisson: 0.2}}
joints: {dry: {friction: 30 deg}}
blocks:
  - {box: {name: floor, lower: [-5, -5, -1], upper: [5, 5, 0]}, group: ground}
  - {box: {name: pier_1, lower: [0, 0, 0], upper: [1, 1, 2]}}
  - {box: {name: pier_2, lower: [3, 0, 0], upper: [4, 1, 2]}}
foundation: {blocks: ground}
attached_masses:
)" + masses +
           "stages: [{name: rest, type: static}]\n";
}

TEST(AttachedMassKeys, GoToEveryMatchingBlockAtTheChosenPlace)
{
    const Model each = read(case_with("  - {blocks: pier_*, mass: 4 t, at: top}\n")).model;
    for (const int pier : {1, 2}) {
        EXPECT_DOUBLE_EQ(each.mass(pier), 4000 + 4000);
        EXPECT_NEAR(each.blocks[pier].moments.centroid.z(), 1.5, 1e-12) << "half way between 1 m and 2 m";
    }
    EXPECT_DOUBLE_EQ(each.mass(0), 200000);

    const Model shared = read(case_with("  - {blocks: pier_*, total: 1000 kg}\n")).model;
    EXPECT_DOUBLE_EQ(shared.mass(1), 4500);
    EXPECT_NEAR(shared.blocks[1].moments.centroid.z(), 1, 1e-12);

    const Model there = read(case_with("  - {blocks: pier_1, mass: 4000 kg, at: [2.5, 0.5, 1]}\n")).model;
    EXPECT_NEAR(there.blocks[1].moments.centroid.x(), 1.5, 1e-12);
    EXPECT_DOUBLE_EQ(there.mass(2), 4000);
}

TEST(AttachedMassKeys, PlanarScenesGiveTheirPlaceInThePlane)
{
    std::string text = case_with("  - {blocks: pier_1, mass: 4000 kg, at: [2.5, 1.5]}\n", "planar_rigid");
    const std::string deep = "lower: [-5, -5, -1], upper: [5, 5, 0]";
    text.replace(text.find(deep), deep.size(), "lower: [-5, 0, -1], upper: [5, 1, 0]");
    const Model model = read(text).model;
    EXPECT_NEAR(model.blocks[1].moments.centroid.x(), 1.5, 1e-12);
    EXPECT_NEAR(model.blocks[1].moments.centroid.z(), 1.25, 1e-12);
}

TEST(AttachedMassKeys, FaultsNameTheirLine)
{
    const auto faults = [](const std::string& masses) { return faults_of(case_with(masses)); };
    const auto says = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(says(faults("  - {blocks: peer_*, mass: 1 t}\n"), "case.yaml:10")) << "the line of the pattern";
    EXPECT_TRUE(says(faults("  - {blocks: peer_*, mass: 1 t}\n"), "matches no block"));
    EXPECT_TRUE(says(faults("  - {blocks: pier_*}\n"), "neither mass nor total"));
    EXPECT_TRUE(says(faults("  - {blocks: pier_*, mass: 1 t, total: 2 t}\n"), "both mass and total"));
    EXPECT_TRUE(says(faults("  - {blocks: pier_*, mass: 1 m}\n"), "mass"));
    EXPECT_TRUE(says(faults("  - {blocks: pier_*, mass: -1 kg}\n"), "must be > 0"));
    EXPECT_TRUE(says(faults("  - {blocks: pier_*, mass: 1 t, at: roof}\n"), "top"));
}

}  // namespace
}  // namespace voussoir::app::reader
