// Houses: counts, volumes and joint areas in closed form, the bond at corners, and what makes no house.
#include "importers/patterns/house.h"

#include <cmath>
#include <set>

#include "tests/importers/patterns/masonry_checks.h"

namespace voussoir::importers
{
namespace
{

/// Inside, n blocks of 0.6 m along x and m along y; `up` courses of 0.3 m; walls of 0.4 m.
patterns::House whole_house(int n, int m, int up)
{
    patterns::House house;
    house.length = 0.6 * n + 0.8;
    house.width = 0.6 * m + 0.8;
    house.height = 0.3 * up;
    return house;
}

/// As cases/house.yaml has it.
patterns::House pierced_house()
{
    patterns::House house;
    house.length = 5;
    house.width = 4;
    house.height = 2.8;
    house.block_height = 0.35;
    house.lintel = {0.35, 0.3};
    house.base = {0.3, 0.2};
    house.openings = {{patterns::Side::south, {0.9, 0, 1, 2.1}},
                      {patterns::Side::south, {2.9, 1.05, 1, 1.05}},
                      {patterns::Side::north, {2, 1.05, 1, 1.05}},
                      {patterns::Side::east, {1.5, 1.05, 1, 1.05}}};
    return house;
}

struct Size {
    int n, m, up;
};

class WholeHouse : public testing::TestWithParam<Size>
{
};

TEST_P(WholeHouse, HasTheBlocksAndJointsOfRunningBond)
{
    const auto [n, m, up] = GetParam();
    const patterns::House asked = whole_house(n, m, up);
    const std::vector<patterns::MasonryBlock> blocks = patterns::house(asked);
    // A wall that ends at the inner corners has n blocks, one that runs through has n + 1.
    const int in_course = 2 * (n + m + 1);
    ASSERT_EQ(static_cast<int>(blocks.size()), 1 + up * in_course);
    const double plan = 2 * 0.4 * (asked.length + asked.width - 0.8);
    EXPECT_NEAR(volume_of(blocks), plan * asked.height + 0.3 * asked.length * asked.width, 1e-10);
    const Joints joints = joints_of(blocks);
    EXPECT_NEAR(joints.bed, up * plan, 1e-10);
    EXPECT_NEAR(joints.head, up * in_course * 0.4 * 0.3, 1e-10);  // as many joints round a course as blocks
    EXPECT_EQ(standing_on_first(joints), static_cast<int>(blocks.size()));
    EXPECT_TRUE(overlaps_of(blocks).empty());
    EXPECT_NEAR(smallest_bond(vertical_joints(blocks, "house_south", 0, 0.4, asked.length)), 0.3, 1e-12);
    EXPECT_NEAR(smallest_bond(vertical_joints(blocks, "house_west", 1, 0.4, asked.width)), 0.3, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sizes, WholeHouse, testing::Values(Size{1, 1, 2}, Size{2, 3, 4}, Size{8, 6, 10}));

TEST(House, RunsItsWallsThroughTheCornersInTurn)
{
    const std::vector<patterns::MasonryBlock> blocks = patterns::house(whole_house(4, 3, 2));
    std::set<std::string> at_corner;  // blocks with a corner at the outer corner (0, 0)
    for (const patterns::MasonryBlock& block : blocks)
        if (block.corners[0].head<2>() == Eigen::Vector2d::Zero()) at_corner.insert(block.name);
    EXPECT_EQ(at_corner, (std::set<std::string>{"house_base", "house_south_c01_b01", "house_west_c02_b01"}));
}

TEST(House, WithOpeningsHasTheVolumeAndJointsOfItsGeometry)
{
    const patterns::House asked = pierced_house();
    const std::vector<patterns::MasonryBlock> blocks = patterns::house(asked);
    EXPECT_EQ(blocks.size(), 201U);
    const double plan = 2 * 0.4 * (5 + 4 - 0.8), holes = 2.1 + 3 * 1.05;
    EXPECT_NEAR(volume_of(blocks), plan * 2.8 - 0.4 * holes + 0.3 * 5.4 * 4.4, 1e-11);
    // Eight beds, the base's included. The door takes 1 m from those at 0 to 2.1 m (7), each window from 4.
    const Joints joints = joints_of(blocks);
    EXPECT_NEAR(joints.bed, 8 * plan - 0.4 * (7 + 3 * 4), 1e-10);
    // Round a course there are as many joints as blocks, less one for each opening it meets.
    const int cuts = 6 + 3 * 3;
    EXPECT_NEAR(joints.head, (200 - cuts) * 0.4 * 0.35, 1e-10);
    EXPECT_EQ(standing_on_first(joints), 201);
    EXPECT_TRUE(overlaps_of(blocks).empty());
    EXPECT_GT(smallest_edge(blocks), 0.2 - 1e-6);
}

TEST(House, BondsItsJointsByAQuarterBlock)
{
    const std::vector<patterns::MasonryBlock> blocks = patterns::house(pierced_house());
    for (const char* side : {"house_south", "house_north"})
        EXPECT_GE(smallest_bond(vertical_joints(blocks, side, 0, 0.4, 5)), 0.15 - 1e-5) << side;
    for (const char* side : {"house_east", "house_west"})
        EXPECT_GE(smallest_bond(vertical_joints(blocks, side, 1, 0.4, 4)), 0.15 - 1e-5) << side;
}

TEST(House, LeavesNoSliverWhateverItsSize)
{
    patterns::House asked = whole_house(3, 3, 3);
    for (double length = 2; length < 5; length += 0.0173) {
        asked.length = length;
        const std::vector<patterns::MasonryBlock> blocks = patterns::house(asked);
        EXPECT_GT(smallest_edge(blocks), 0.2 - 1e-5) << length;
        EXPECT_TRUE(overlaps_of(blocks).empty());
        EXPECT_EQ(standing_on_first(joints_of(blocks)), static_cast<int>(blocks.size()));
        EXPECT_NEAR(volume_of(blocks), 0.8 * (length + asked.width - 0.8) * 0.9 + 0.3 * length * asked.width,
                    1e-10);
        EXPECT_GE(smallest_bond(vertical_joints(blocks, "house_south", 0, 0.4, length)), 0.15 - 1e-5) << length;
    }
}

TEST(House, IsTheSameWhereverItStands)
{
    const Joints joints = joints_of(patterns::house(pierced_house()));
    patterns::House there = pierced_house();
    there.placement = {{-20, 30, 400}, 0.7};
    const std::vector<patterns::MasonryBlock> blocks = patterns::house(there);
    const Joints turned = joints_of(blocks);
    EXPECT_NEAR(turned.bed, joints.bed, 1e-9);
    EXPECT_NEAR(turned.head, joints.head, 1e-9);
    EXPECT_EQ(turned.touching, joints.touching);
    EXPECT_NEAR(volume_of(blocks), volume_of(patterns::house(pierced_house())), 1e-9);
}

TEST(House, WithImperfectionsOverlapsNowhere)
{
    patterns::House asked = pierced_house();
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        asked.imperfection = {.seed = seed, .size = 0.02, .joint = 0.01, .friction = 0.05};
        const std::vector<patterns::MasonryBlock> blocks = patterns::house(asked);
        EXPECT_TRUE(overlaps_of(blocks).empty());
        EXPECT_EQ(standing_on_first(joints_of(blocks)), 201);
        EXPECT_LT(volume_of(blocks), volume_of(patterns::house(pierced_house())));
    }
    asked.imperfection = {.seed = 5, .size = 0, .joint = 0.01};
    EXPECT_TRUE(overlaps_of(patterns::house(asked)).empty());
    EXPECT_NEAR(volume_of(patterns::house(asked)), volume_of(patterns::house(pierced_house())), 1e-11);
}

TEST(HouseRefusal, NamesWhatMakesNoHouse)
{
    const auto refusal = [](const auto& change) {
        patterns::House asked = pierced_house();
        change(asked);
        return refusal_of([&] { patterns::house(asked); });
    };
    EXPECT_EQ(refusal([](patterns::House& house) { house.width = 1; }),
              "width: 1 m; must be at least two wall thicknesses and a block, 1.4 m\n"
              "openings[3]: from 1.5 m to 2.5 m along house_east; it must lie between 0.4 m and 0.6 m");
    EXPECT_EQ(refusal([](patterns::House& house) { house.openings[0].opening.at = 0.3; }),
              "openings[0]: from 0.3 m to 1.3 m along house_south; it must lie between 0.4 m and 4.6 m");
    EXPECT_EQ(refusal([](patterns::House& house) { house.openings[0].opening.at = 0.5; }),
              "openings[0]: its lintel would reach from 0.2 m to 1.8 m along house_south; both bearings must lie "
              "between 0.4 m and 4.6 m");
    EXPECT_EQ(refusal([](patterns::House& house) { house.openings[3].opening.sill = 1; }),
              "openings[1]: the sill of openings[3] and the sill of openings[1] lie 0.05 m apart in height; give "
              "them the same level, or separate them by at least a third of a course, 0.116667 m, apart")
        << "all walls have the same courses";
    EXPECT_EQ(refusal([](patterns::House& house) { house.wall_thickness = 0; }),
              "wall_thickness: 0 m; must be > 0 m");
}

}  // namespace
}  // namespace voussoir::importers
