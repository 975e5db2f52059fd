// Walls of leaves of different thickness from a case file.
#include "tests/app/patterns/pattern_checks.h"

namespace voussoir::app::patterns_test
{
namespace
{

std::string wall(const std::string& leaves, const std::string& more = "")
{
    return "{wall: {length: 1.8 m, height: 1.6 m, thickness: 0.9 m, block: [0.6 m, 0.4 m], base: {height: 0.3 m}, "
           "leaves: " +
           leaves + more + "}, groups: {foundation: \"*_base\", core: \"*_l2_*\"}}";
}

double volume_of_leaf(const Model& model, const std::string& leaf)
{
    double volume = 0;
    for (const Block& block : model.blocks)
        if (block.name.find(leaf) != std::string::npos) volume += block.moments.volume;
    return volume;
}

TEST(WallPattern, LeavesHaveTheThicknessOfTheirOwn)
{
    const Model model = read_pattern(wall("[0.25 m, 0.45 m, 0.2 m]")).model;
    EXPECT_NEAR(volume_of_leaf(model, "_l1_"), 1.8 * 1.6 * 0.25, 1e-9);
    EXPECT_NEAR(volume_in(model, "core"), 1.8 * 1.6 * 0.45, 1e-9);
    EXPECT_NEAR(volume_of_leaf(model, "_l3_"), 1.8 * 1.6 * 0.2, 1e-9);
    const auto assembly = assembly_of(model);
    expect_sound(assembly);
    double faces = 0;
    for (const auto& contact : assembly.contacts)
        if (std::abs(contact.normal.y()) > 0.99) faces += contact.area;
    EXPECT_NEAR(faces, 2 * 1.8 * 1.6, 1e-8) << "two joints between three leaves";
    expect_rest(read_pattern(wall("[0.25 m, 0.45 m, 0.2 m]"), {"kinematics=spatial_rigid"}));
    // Headers reach through all of them.
    const Model bonded = read_pattern(wall("[0.25 m, 0.45 m, 0.2 m]", ", header_every: 2")).model;
    EXPECT_NEAR(volume_in(bonded, "core"), 1.8 * 0.8 * 0.45, 1e-9);
    EXPECT_NEAR(volume_in(bonded, "") - volume_in(bonded, "foundation"), 1.8 * 1.6 * 0.9, 1e-9);
}

TEST(WallPattern, EqualLeavesAreThoseOfTheirNumber)
{
    const Model number = read_pattern(wall("3")).model, list = read_pattern(wall("[0.3 m, 0.3 m, 0.3 m]")).model;
    ASSERT_EQ(number.blocks.size(), list.blocks.size());
    for (std::size_t b = 0; b < number.blocks.size(); ++b)
        EXPECT_NEAR(number.blocks[b].moments.volume, list.blocks[b].moments.volume, 1e-12);
}

TEST(WallPattern, SaysWhichLeavesDoNotFit)
{
    const auto faults = [](const std::string& leaves) { return reader::faults_of(pattern_case(wall(leaves))); };
    EXPECT_NE(faults("[0.3 m, 0.3 m]").find("wall.leaves: 0.600000 m in all; must add up to the thickness"),
              std::string::npos)
        << faults("[0.3 m, 0.3 m]");
    EXPECT_NE(faults("[]").find("leaves"), std::string::npos);
    EXPECT_NE(faults("[0.3, -0.1 m, 0.7 m]").find("leaves[1]"), std::string::npos)
        << faults("[0.3, -0.1 m, 0.7 m]");
}

}  // namespace
}  // namespace voussoir::app::patterns_test
