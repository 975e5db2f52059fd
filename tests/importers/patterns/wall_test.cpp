// Walls: counts, volumes and joint areas in closed form, bond, placement, mesh files.
#include "importers/patterns/wall.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <set>

#include "importers/helper/import_meshes.h"
#include "importers/mesh/write_obj.h"
#include "tests/importers/patterns/masonry_checks.h"
#include "tests/importers/patterns/wall_scenes.h"
#include "tests/importers/shapes.h"

namespace voussoir::importers
{
namespace
{

double holes(const patterns::Wall& wall)
{
    double area = 0;
    for (const patterns::Opening& opening : wall.openings) area += opening.width * opening.height;
    return area;
}

class WholeWall : public testing::TestWithParam<std::pair<int, int>>
{
};

TEST_P(WholeWall, HasTheBlocksAndJointsOfRunningBond)
{
    const auto [across, up] = GetParam();
    const std::vector<patterns::MasonryBlock> blocks = patterns::wall(whole_wall(across, up));
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
    patterns::Wall asked = whole_wall(4, 3);
    asked.length = 2.2;   // four blocks and 0.2 m, more than a third of a block
    asked.height = 0.85;  // three courses and 0.1 m, more than a third of a course
    const std::vector<patterns::MasonryBlock> cut = patterns::wall(asked);
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
    patterns::Wall asked = whole_wall(4, 3);
    asked.length = 2.1;  // four blocks and 0.1 m: the last is 0.6 m long
    asked.height = 0.8;  // three courses and 0.05 m: the last is 0.3 m high
    const std::vector<patterns::MasonryBlock> merged = patterns::wall(asked);
    ASSERT_EQ(merged.size(), 4U + 5U + 4U);
    EXPECT_EQ(merged[3].corners[0].x(), 1.5);
    EXPECT_EQ(merged[3].corners[7].x(), 2.1);
    EXPECT_EQ(merged[12].corners[0].z(), 0.5);
    EXPECT_EQ(merged[12].corners[7].z(), 0.8);
    for (double length = 1; length < 3; length += 0.0137) {
        asked.length = length;
        EXPECT_GT(smallest_edge(patterns::wall(asked)), 0.25 / 3 - 1e-5) << length;
    }
}

TEST(Wall, MakesWayForOpeningsAndBearsOnLintels)
{
    const patterns::Wall asked = pierced_wall();
    const std::vector<patterns::MasonryBlock> blocks = patterns::wall(asked);
    EXPECT_EQ(blocks[0].name, "wall_base");
    EXPECT_EQ(blocks[0].corners[0], Eigen::Vector3d(-0.1, -0.1, -0.3));
    EXPECT_EQ(blocks[0].corners[7], Eigen::Vector3d(8.1, 0.4, 0));
    EXPECT_NEAR(volume_of(blocks), (8 * 3 - holes(asked)) * 0.3 + 8.2 * 0.5 * 0.3, 1e-12);
    const auto lintel = std::find_if(blocks.begin(), blocks.end(), [](const patterns::MasonryBlock& block) {
        return block.name == "wall_lintel_2";
    });
    ASSERT_NE(lintel, blocks.end());
    EXPECT_NEAR((lintel->corners[0] - Eigen::Vector3d(3.05, 0, 1.65)).norm(), 0, 1e-15);
    EXPECT_NEAR((lintel->corners[7] - Eigen::Vector3d(4.45, 0.3, 1.9)).norm(), 0, 1e-15);
    EXPECT_EQ(
        std::count_if(blocks.begin(), blocks.end(),
                      [](const patterns::MasonryBlock& block) { return block.name.starts_with("wall_lintel"); }),
        2)
        << "the opening that reaches the top has none";
    EXPECT_TRUE(overlaps_of(blocks).empty());
    EXPECT_EQ(standing_on_first(joints_of(blocks)), static_cast<int>(blocks.size()));
}

TEST(Wall, BondsItsJointsByAQuarterBlockRoundOpenings)
{
    patterns::Wall asked = pierced_wall();
    asked.openings.erase(asked.openings.begin() +
                         1);  // its lintel reaches through two courses, and so do its ends
    for (double at = 0.7; at < 3.5; at += 0.0319) {
        asked.openings[0].at = at;
        EXPECT_GE(smallest_bond(vertical_joints(patterns::wall(asked), "wall", 0, 0, 0)), 0.125 - 1e-5) << at;
    }
}

TEST(Wall, HasTheBedsOfEveryLevel)
{
    const patterns::Wall asked = pierced_wall();
    const std::vector<patterns::MasonryBlock> blocks = patterns::wall(asked);
    // Without the openings every bed is 8 m long; at each bed an opening takes its width away, from sill to head.
    std::set<double> levels;
    for (const patterns::MasonryBlock& block : blocks)
        if (block.name.starts_with("wall_c")) levels.insert(block.corners[0].z());
    double length = 0;
    for (const double z : levels) {
        length += 8;
        for (const patterns::Opening& opening : asked.openings)
            if (z > opening.sill - 1e-9 && z < opening.sill + opening.height + 1e-9) length -= opening.width;
    }
    // Inside the lintels, 1.65 m to 1.9 m and 1.75 m to 2 m, there is no bed at 1.75 m and 1.9 m.
    EXPECT_NEAR(joints_of(blocks).bed, (length - 1.4 - 1.5) * 0.3, 1e-10);
}

TEST(Wall, HasLeavesThatHeadersHoldTogether)
{
    patterns::Wall asked = whole_wall(8, 6);
    asked.thickness = 0.6;
    asked.leaves = 2;
    asked.header_every = 3;
    const std::vector<patterns::MasonryBlock> blocks = patterns::wall(asked);
    EXPECT_EQ(blocks[0].name, "wall_c01_l1_b01");
    EXPECT_NEAR(volume_of(blocks), 4 * 1.5 * 0.6, 1e-12);
    EXPECT_TRUE(overlaps_of(blocks).empty());
    int headers = 0;
    for (const patterns::MasonryBlock& block : blocks)
        if (block.corners[7].y() - block.corners[0].y() == 0.6) ++headers;
    EXPECT_GE(headers, 2 * 8);
    EXPECT_EQ(
        std::count_if(blocks.begin(), blocks.end(),
                      [](const patterns::MasonryBlock& block) { return block.name.starts_with("wall_c03_b"); }),
        8)
        << "its joints lie a quarter off those of both leaves";
    EXPECT_NEAR(joints_of(blocks).bed, 5 * 4 * 0.6, 1e-12);
    EXPECT_EQ(standing_on_first(joints_of(blocks)), static_cast<int>(blocks.size()));
}

TEST(Wall, IsTheSameWhereverItStands)
{
    const patterns::Wall here = pierced_wall();
    const Joints joints = joints_of(patterns::wall(here));
    const double volume = volume_of(patterns::wall(here));
    for (const double angle : {0.3, std::numbers::pi / 2, 2.5, std::numbers::pi}) {
        patterns::Wall there = here;
        there.placement = {{100, -50, 7}, angle};
        const std::vector<patterns::MasonryBlock> blocks = patterns::wall(there);
        EXPECT_NEAR(volume_of(blocks), volume, 1e-10);
        const Joints turned = joints_of(blocks);
        EXPECT_NEAR(turned.bed, joints.bed, 1e-9);
        EXPECT_NEAR(turned.head, joints.head, 1e-9);
        EXPECT_EQ(turned.touching, joints.touching) << angle;
    }
}

TEST(Wall, AQuarterTurnKeepsEveryBit)
{
    patterns::Wall turned = pierced_wall();
    turned.placement.direction = std::numbers::pi / 2;
    const std::vector<patterns::MasonryBlock> along_y = patterns::wall(turned),
                                              along_x = patterns::wall(pierced_wall());
    for (std::size_t i = 0; i < along_x.size(); ++i)
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Vector3d& x = along_x[i].corners[corner];
            EXPECT_EQ(along_y[i].corners[corner], Eigen::Vector3d(-x.y(), x.x(), x.z()));
        }
}

TEST(Wall, OfTenThousandBlocksIsMadeAndCertified)
{
    const std::vector<patterns::MasonryBlock> blocks = patterns::wall(whole_wall(200, 50));
    ASSERT_EQ(blocks.size(), 200U * 50 + 25);
    const Joints joints = joints_of(blocks);
    EXPECT_NEAR(joints.bed, 49 * 100 * 0.3, 1e-7);
    EXPECT_NEAR(joints.head, (10025 - 50) * 0.25 * 0.3, 1e-7);
    EXPECT_TRUE(overlaps_of(blocks).empty());
}

TEST(Wall, IsCertifiedFromItsObjWithoutRepair)
{
    const TemporaryFolder folder;
    patterns::Wall asked = pierced_wall();
    asked.placement = {{5, 6, 7}, 0.4};
    std::vector<mesh::PolygonSurface> surfaces;
    for (const patterns::MasonryBlock& block : patterns::wall(asked))
        surfaces.push_back(patterns::to_surface(block));
    const helper::Geometry geometry =
        helper::import_meshes({{.file = folder.write("wall.obj", mesh::to_obj(surfaces, {}))}});
    const helper::ImportedMesh& mesh = geometry.meshes.at(0);
    EXPECT_TRUE(mesh.accepted) << mesh.reason;
    EXPECT_TRUE(mesh.repairs.empty());
    EXPECT_TRUE(geometry.overlaps.empty());
    ASSERT_EQ(mesh.stones.size(), surfaces.size());
    double volume = 0;
    for (const helper::Stone& stone : mesh.stones) {
        EXPECT_TRUE(stone.repairs.empty()) << stone.name;
        volume += stone.moments.volume;
    }
    EXPECT_NEAR(volume, volume_of(patterns::wall(asked)), 1e-10);
}

std::string contents(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The first line of a generated mesh is the command that makes it again.
TEST(Generate, WritesWallsAndHousesWithTheCommandThatMakesThemAgain)
{
    const TemporaryFolder first, second;
    const auto run = [](const TemporaryFolder& folder, const std::string& arguments) {
        const std::string command =
            "cd '" + folder.path().string() + "' && '" + VOUSSOIR_BINARIES + "'/" + arguments;
        return std::system(command.c_str());
    };
    for (const char* arguments :
         {"voussoir-generate wall --leaves 2 --opening 1,0,1,2.1 --opening 2.6,0.9,0.7,1.2 --size 0.01 -o x.obj",
          "voussoir-generate house --south 2,0,1,2.1 --east 2,0.9,1,1.2 --direction 30 --joint 0.002 -o x.obj"}) {
        ASSERT_EQ(run(first, arguments), 0);
        const std::string mesh = contents(first.path() / "x.obj");
        ASSERT_TRUE(mesh.starts_with("# voussoir-generate "));
        ASSERT_EQ(run(second, mesh.substr(2, mesh.find('\n') - 2)), 0);
        EXPECT_TRUE(contents(second.path() / "x.obj") == mesh) << "not the same, byte for byte";
    }
    EXPECT_NE(run(first, "voussoir-generate wall --opening 1,0,1 -o x.obj 2> /dev/null"), 0);
}

// Every pair of them overlaps: what is said grows with their number, not with its square.
TEST(Wall, OfManyEqualOpeningsIsRefusedInALineForEach)
{
    patterns::Wall asked = whole_wall(16, 12);
    asked.openings.assign(3000, {1, 1, 1, 1});
    try {
        patterns::wall(asked);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        ASSERT_EQ(error.faults.size(), 2U * 3000 - 2);  // each but the first, and its lintel
        EXPECT_EQ(error.faults[0].place, "openings[1]");
        EXPECT_EQ(error.faults[0].found, "openings[0] and openings[1] overlap");
    }
}

// The estimate knows whole blocks; a course of one block has two halves above it.
TEST(Wall, OfMoreBlocksThanItSeemsIsRefusedBeforeTheyAreMade)
{
    patterns::Wall asked = whole_wall(3, 2);
    asked.length = 1.0;
    asked.block_length = 0.5;
    asked.height = 0.25 * 99'000;  // estimated 198 000, laid 247 500
    try {
        patterns::wall(asked);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.faults.at(0).found, "more than 200000 blocks");
    }
}

TEST(Wall, ThatIsAllOpeningIsRefused)
{
    patterns::Wall nothing;
    nothing.length = 3;
    nothing.height = 1.5;
    nothing.openings = {{0, 0, 3, 1.5}};
    EXPECT_THROW(patterns::wall(nothing), InputError);
}

}  // namespace
}  // namespace voussoir::importers
