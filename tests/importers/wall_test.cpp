// Walls: counts, volumes and joint areas in closed form, and every parameter that makes no wall.
#include "importers/patterns/wall.h"

#include <cmath>
#include <numbers>
#include <set>

#include "app/geometry/import_meshes.h"
#include "importers/mesh/write_obj.h"
#include "tests/importers/masonry_checks.h"
#include "tests/importers/shapes.h"

namespace voussoir
{
namespace
{

/// `across` blocks of 0.5 m x 0.25 m in a course, `up` courses, 0.3 m thick.
Wall whole_wall(int across, int up)
{
    Wall wall;
    wall.length = 0.5 * across;
    wall.height = 0.25 * up;
    wall.thickness = 0.3;
    wall.block_length = 0.5;
    wall.block_height = 0.25;
    wall.lintel = {0.25, 0.25};
    return wall;
}

/// One with a door, a window whose sill and head lie between courses, and an opening up to the top.
Wall pierced_wall()
{
    Wall wall = whole_wall(16, 12);
    wall.openings = {{1, 0, 1, 1.75}, {3.3, 0.85, 0.9, 0.8}, {6, 1.5, 1, 1.5}};
    wall.base = {0.3, 0.1};
    return wall;
}

double holes(const Wall& wall)
{
    double area = 0;
    for (const Opening& opening : wall.openings) area += opening.width * opening.height;
    return area;
}

class WholeWall : public testing::TestWithParam<std::pair<int, int>>
{
};

TEST_P(WholeWall, HasTheBlocksAndJointsOfRunningBond)
{
    const auto [across, up] = GetParam();
    const std::vector<MasonryBlock> blocks = wall(whole_wall(across, up));
    const int count = across * up + up / 2;  // one more in every second course, for its half blocks
    ASSERT_EQ(static_cast<int>(blocks.size()), count);
    EXPECT_NEAR(volume_of(blocks), 0.5 * across * 0.25 * up * 0.3, 1e-12 * count);
    const Joints joints = joints_of(blocks);
    EXPECT_NEAR(joints.bed, (up - 1) * 0.5 * across * 0.3, 1e-12 * count);
    EXPECT_NEAR(joints.head, (count - up) * 0.25 * 0.3, 1e-12 * count);
    EXPECT_EQ(standing_on_first(joints), count);
    EXPECT_TRUE(overlaps_of(blocks).empty());
    EXPECT_EQ(smallest_bond(vertical_joints(blocks, "wall", 0, 0, 0)), 0.25);
}

INSTANTIATE_TEST_SUITE_P(Sizes, WholeWall,
                         testing::Values(std::pair{2, 2}, std::pair{4, 7}, std::pair{7, 4}, std::pair{20, 12}));

TEST(Wall, CutsTheLastBlockAndTheLastCourse)
{
    Wall asked = whole_wall(4, 3);
    asked.length = 2.2;   // four blocks and 0.2 m, more than a third of a block
    asked.height = 0.85;  // three courses and 0.1 m, more than a third of a course
    const std::vector<MasonryBlock> cut = wall(asked);
    ASSERT_EQ(cut.size(), 5U + 5U + 5U + 5U);  // odd courses: a half block, three and 0.45 m
    EXPECT_EQ(cut[0].name, "wall_c01_b01");
    EXPECT_EQ(cut[4].corners[0].x(), 2.0);
    EXPECT_EQ(cut[4].corners[7].x(), 2.2);
    EXPECT_EQ(cut[5].corners[7].x(), 0.25);
    EXPECT_EQ(cut[9].name, "wall_c02_b05");
    EXPECT_EQ(cut[9].corners[0].x(), 1.75);
    EXPECT_EQ(cut[19].corners[0].z(), 0.75);
    EXPECT_EQ(cut[19].corners[7].z(), 0.85);
    EXPECT_NEAR(volume_of(cut), 2.2 * 0.85 * 0.3, 1e-13);
}

TEST(Wall, LeavesNoPieceShorterThanAThird)
{
    Wall asked = whole_wall(4, 3);
    asked.length = 2.1;  // four blocks and 0.1 m: the last is 0.6 m long
    asked.height = 0.8;  // three courses and 0.05 m: the last is 0.3 m high
    const std::vector<MasonryBlock> merged = wall(asked);
    ASSERT_EQ(merged.size(), 4U + 5U + 4U);
    EXPECT_EQ(merged[3].corners[0].x(), 1.5);
    EXPECT_EQ(merged[3].corners[7].x(), 2.1);
    EXPECT_EQ(merged[12].corners[0].z(), 0.5);
    EXPECT_EQ(merged[12].corners[7].z(), 0.8);
    for (double length = 1; length < 3; length += 0.0137) {
        asked.length = length;
        EXPECT_GT(smallest_edge(wall(asked)), 0.25 / 3 - 1e-5) << length;
    }
}

TEST(Wall, MakesWayForOpeningsAndBearsOnLintels)
{
    const Wall asked = pierced_wall();
    const std::vector<MasonryBlock> blocks = wall(asked);
    EXPECT_EQ(blocks[0].name, "wall_base");
    EXPECT_EQ(blocks[0].corners[0], Eigen::Vector3d(-0.1, -0.1, -0.3));
    EXPECT_EQ(blocks[0].corners[7], Eigen::Vector3d(8.1, 0.4, 0));
    EXPECT_NEAR(volume_of(blocks), (8 * 3 - holes(asked)) * 0.3 + 8.2 * 0.5 * 0.3, 1e-12);
    const auto lintel = std::find_if(blocks.begin(), blocks.end(),
                                     [](const MasonryBlock& block) { return block.name == "wall_lintel_2"; });
    ASSERT_NE(lintel, blocks.end());
    EXPECT_NEAR((lintel->corners[0] - Eigen::Vector3d(3.05, 0, 1.65)).norm(), 0, 1e-15);
    EXPECT_NEAR((lintel->corners[7] - Eigen::Vector3d(4.45, 0.3, 1.9)).norm(), 0, 1e-15);
    EXPECT_EQ(std::count_if(blocks.begin(), blocks.end(),
                            [](const MasonryBlock& block) { return block.name.starts_with("wall_lintel"); }),
              2)
        << "the opening that reaches the top has none";
    EXPECT_TRUE(overlaps_of(blocks).empty());
    EXPECT_EQ(standing_on_first(joints_of(blocks)), static_cast<int>(blocks.size()));
}

TEST(Wall, BondsItsJointsByAQuarterBlockRoundOpenings)
{
    Wall asked = pierced_wall();
    asked.openings.erase(asked.openings.begin() +
                         1);  // its lintel reaches through two courses, and so do its ends
    for (double at = 0.7; at < 3.5; at += 0.0319) {
        asked.openings[0].at = at;
        EXPECT_GE(smallest_bond(vertical_joints(wall(asked), "wall", 0, 0, 0)), 0.125 - 1e-5) << at;
    }
}

TEST(Wall, HasTheBedsOfEveryLevel)
{
    const Wall asked = pierced_wall();
    const std::vector<MasonryBlock> blocks = wall(asked);
    // Without the openings every bed is 8 m long; at each bed an opening takes its width away, from sill to head.
    std::set<double> levels;
    for (const MasonryBlock& block : blocks)
        if (block.name.starts_with("wall_c")) levels.insert(block.corners[0].z());
    double length = 0;
    for (const double z : levels) {
        length += 8;
        for (const Opening& opening : asked.openings)
            if (z > opening.sill - 1e-9 && z < opening.sill + opening.height + 1e-9) length -= opening.width;
    }
    // Inside the lintels, 1.65 m to 1.9 m and 1.75 m to 2 m, there is no bed at 1.75 m and 1.9 m.
    EXPECT_NEAR(joints_of(blocks).bed, (length - 1.4 - 1.5) * 0.3, 1e-10);
}

TEST(Wall, HasLeavesThatHeadersHoldTogether)
{
    Wall asked = whole_wall(8, 6);
    asked.thickness = 0.6;
    asked.leaves = 2;
    asked.header_every = 3;
    const std::vector<MasonryBlock> blocks = wall(asked);
    EXPECT_EQ(blocks[0].name, "wall_c01_l1_b01");
    EXPECT_NEAR(volume_of(blocks), 4 * 1.5 * 0.6, 1e-12);
    EXPECT_TRUE(overlaps_of(blocks).empty());
    int headers = 0;
    for (const MasonryBlock& block : blocks)
        if (block.corners[7].y() - block.corners[0].y() == 0.6) ++headers;
    EXPECT_GE(headers, 2 * 8);
    EXPECT_EQ(std::count_if(blocks.begin(), blocks.end(),
                            [](const MasonryBlock& block) { return block.name.starts_with("wall_c03_b"); }),
              8)
        << "its joints lie a quarter off those of both leaves";
    EXPECT_NEAR(joints_of(blocks).bed, 5 * 4 * 0.6, 1e-12);
    EXPECT_EQ(standing_on_first(joints_of(blocks)), static_cast<int>(blocks.size()));
}

TEST(Wall, IsTheSameWhereverItStands)
{
    const Wall here = pierced_wall();
    const Joints joints = joints_of(wall(here));
    const double volume = volume_of(wall(here));
    for (const double angle : {0.3, std::numbers::pi / 2, 2.5, std::numbers::pi}) {
        Wall there = here;
        there.placement = {{100, -50, 7}, angle};
        const std::vector<MasonryBlock> blocks = wall(there);
        EXPECT_NEAR(volume_of(blocks), volume, 1e-10);
        const Joints turned = joints_of(blocks);
        EXPECT_NEAR(turned.bed, joints.bed, 1e-9);
        EXPECT_NEAR(turned.head, joints.head, 1e-9);
        EXPECT_EQ(turned.touching, joints.touching) << angle;
    }
}

TEST(Wall, AQuarterTurnKeepsEveryBit)
{
    Wall turned = pierced_wall();
    turned.placement.direction = std::numbers::pi / 2;
    const std::vector<MasonryBlock> along_y = wall(turned), along_x = wall(pierced_wall());
    for (std::size_t i = 0; i < along_x.size(); ++i)
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d& x = along_x[i].corners[corner];
            EXPECT_EQ(along_y[i].corners[corner], Eigen::Vector3d(-x.y(), x.x(), x.z()));
        }
}

TEST(WallImperfection, IsTheSameForTheSameSeed)
{
    Wall asked = pierced_wall();
    asked.imperfection = {.seed = 7, .size = 0.01, .joint = 0.002, .friction = 0.05};
    const std::vector<MasonryBlock> one = wall(asked), two = wall(asked);
    asked.imperfection.seed = 8;
    const std::vector<MasonryBlock> other = wall(asked);
    int different = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].corners, two[i].corners);
        EXPECT_EQ(one[i].friction_factor, two[i].friction_factor);
        different += one[i].corners != other[i].corners ? 1 : 0;
    }
    EXPECT_EQ(different, static_cast<int>(one.size()) - 3) << "all but the base and two lintels";
    // The first numbers of splitmix64 from 7 on, so that another machine or compiler is seen to give the same
    // wall.
    EXPECT_EQ(one[0].friction_factor, 1);
    EXPECT_EQ(one[1].name, "wall_c01_b01");
    EXPECT_EQ(one[1].corners[0].z(), 0);
}

TEST(WallImperfection, OnlyEverMakesRoom)
{
    Wall asked = pierced_wall();
    asked.leaves = 2;
    const std::vector<MasonryBlock> exact = wall(asked);
    asked.imperfection = {.seed = 3, .size = 0.02, .joint = 0.004, .friction = 0.1};
    const std::vector<MasonryBlock> real = wall(asked);
    EXPECT_TRUE(overlaps_of(real).empty());
    EXPECT_NEAR(joints_of(real).bed, joints_of(exact).bed, 0.05 * joints_of(exact).bed);
    double least = 1, most = 1, moved = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const Eigen::Vector3d size = real[i].corners[7] - real[i].corners[0],
                              drawn = exact[i].corners[7] - exact[i].corners[0];
        EXPECT_EQ(size.z(), drawn.z()) << "beds stay planar";
        for (const int axis : {0, 1}) {
            EXPECT_LE(size[axis], drawn[axis] * (1 + 1e-12));
            EXPECT_GE(size[axis], drawn[axis] * 0.98 - 1e-12);
        }
        EXPECT_GE(real[i].corners[0].x(), exact[i].corners[0].x()) << "along the wall a block stays in its place";
        EXPECT_LE(real[i].corners[7].x(), exact[i].corners[7].x());
        moved = std::max(moved, exact[i].corners[0].y() - real[i].corners[0].y());
        least = std::min(least, real[i].friction_factor);
        most = std::max(most, real[i].friction_factor);
    }
    EXPECT_GT(moved, 0.002);
    EXPECT_LE(moved, 0.004);
    EXPECT_GE(least, 0.9);
    EXPECT_LT(least, 0.92);
    EXPECT_LE(most, 1.1);
    EXPECT_GT(most, 1.08);
}

TEST(Wall, OfTenThousandBlocksIsMadeAndCertified)
{
    const std::vector<MasonryBlock> blocks = wall(whole_wall(200, 50));
    ASSERT_EQ(blocks.size(), 200U * 50 + 25);
    const Joints joints = joints_of(blocks);
    EXPECT_NEAR(joints.bed, 49 * 100 * 0.3, 1e-7);
    EXPECT_NEAR(joints.head, (10025 - 50) * 0.25 * 0.3, 1e-7);
    EXPECT_TRUE(overlaps_of(blocks).empty());
}

TEST(Wall, IsCertifiedFromItsObjWithoutRepair)
{
    const ScratchFolder folder;
    Wall asked = pierced_wall();
    asked.placement = {{5, 6, 7}, 0.4};
    std::vector<PolygonSurface> surfaces;
    for (const MasonryBlock& block : wall(asked)) surfaces.push_back(to_surface(block));
    const Geometry geometry = import_meshes({{.file = folder.write("wall.obj", to_obj(surfaces, {}))}});
    const ImportedMesh& mesh = geometry.meshes.at(0);
    EXPECT_TRUE(mesh.accepted) << mesh.reason;
    EXPECT_TRUE(mesh.repairs.empty());
    EXPECT_TRUE(geometry.overlaps.empty());
    ASSERT_EQ(mesh.stones.size(), surfaces.size());
    double volume = 0;
    for (const Stone& stone : mesh.stones) {
        EXPECT_TRUE(stone.repairs.empty()) << stone.name;
        volume += stone.moments.volume;
    }
    EXPECT_NEAR(volume, volume_of(wall(asked)), 1e-10);
}

TEST(WallRefusal, NamesEveryParameterThatMakesNoWall)
{
    const auto refusal = [](const auto& change) {
        Wall asked = pierced_wall();
        change(asked);
        return refusal_of([&] { wall(asked); });
    };
    EXPECT_EQ(refusal([](Wall& wall) { wall.thickness = 0; }), "thickness: 0 m; must be > 0 m");
    EXPECT_EQ(refusal([](Wall& wall) { wall.length = std::nan(""), wall.height = -1; }),
              "length: nan m; must be > 0 m\nheight: -1 m; must be > 0 m");
    EXPECT_EQ(refusal([](Wall& wall) { wall.block_length = 9; }),
              "block: a block 9 m long in a wall of 8 m; the block must fit into the wall");
    EXPECT_EQ(refusal([](Wall& wall) { wall.block_height = 1e-9; }),
              "block: more than two million blocks; give a larger block or a smaller wall");
    EXPECT_EQ(refusal([](Wall& wall) {
                  wall.openings = {{7.5, 0, 1, 3}};
              }),
              "openings[0]: from 7.5 m to 8.5 m along wall; it must lie between 0 m and 8 m");
    EXPECT_EQ(refusal([](Wall& wall) {
                  wall.openings = {{1, 2.5, 1, 1}};
              }),
              "openings[0]: from 2.5 m to 3.5 m above the foot; it must lie between 0 m and 3 m");
    EXPECT_EQ(refusal([](Wall& wall) {
                  wall.openings = {{1, 0, 1, 2}, {1.5, 0.5, 1, 1}};
              }),
              "openings[1]: openings[0] and openings[1] overlap; leave wall between them\n"
              "openings[1]: openings[0] and the lintel over openings[1] overlap; leave wall between them");
    EXPECT_EQ(refusal([](Wall& wall) {
                  wall.openings = {{0.2, 0, 1, 2}};
              }),
              "openings[0]: its lintel would reach from -0.05 m to 1.45 m along wall; both bearings must lie "
              "between 0 m and 8 m");
    EXPECT_EQ(refusal([](Wall& wall) {
                  wall.openings = {{1, 0, 1, 2.9}};
              }),
              "openings[0]: its lintel would reach up to 3.15 m; it must end at the top, 3 m, or below");
    EXPECT_EQ(refusal([](Wall& wall) {
                  wall.openings = {{1, 0, 1, 2}, {2.3, 0, 1, 2}};
              }),
              "openings[1]: the lintel over openings[0] and the lintel over openings[1] overlap; leave wall "
              "between them");
    EXPECT_EQ(refusal([](Wall& wall) {
                  wall.openings = {{1, 0, 1, 2}, {4, 0, 1, 2.05}};
              }),
              "openings[1]: the head of openings[0] and the head of openings[1] lie 0.05 m apart in height; bring "
              "them to one level or at least a third of a course, 0.0833333 m, apart");
    EXPECT_EQ(refusal([](Wall& wall) {
                  wall.openings = {{0.1, 0, 1, 3}};
              }),
              "openings: only 0.1 m of wall between 0 m and 0.1 m; leave nothing, or at least a third of a block, "
              "0.166667 m");
    EXPECT_EQ(refusal([](Wall& wall) { wall.imperfection.joint = 0.1; }),
              "imperfection.joint: 0.1 m; must be >= 0 m and less than a quarter of the thickness of the wall or "
              "leaf");
    EXPECT_EQ(refusal([](Wall& wall) { wall.header_every = 2; }),
              "header_every: 2; must be > 0, in a wall of several leaves");
}

}  // namespace
}  // namespace voussoir
