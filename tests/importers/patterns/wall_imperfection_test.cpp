// Walls that differ from their drawing, and walls that cannot be.
#include <gtest/gtest.h>

#include <cmath>

#include "importers/patterns/wall.h"
#include "tests/importers/patterns/masonry_checks.h"
#include "tests/importers/patterns/wall_scenes.h"

namespace voussoir::importers
{
namespace
{

TEST(WallImperfection, IsTheSameForTheSameSeed)
{
    patterns::Wall asked = pierced_wall();
    asked.imperfection = {.seed = 7, .size = 0.01, .joint = 0.002, .friction = 0.05};
    const std::vector<patterns::MasonryBlock> one = patterns::wall(asked), two = patterns::wall(asked);
    asked.imperfection.seed = 8;
    const std::vector<patterns::MasonryBlock> other = patterns::wall(asked);
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
    patterns::Wall asked = pierced_wall();
    asked.leaves = 2;
    const std::vector<patterns::MasonryBlock> exact = patterns::wall(asked);
    asked.imperfection = {.seed = 3, .size = 0.02, .joint = 0.004, .friction = 0.1};
    const std::vector<patterns::MasonryBlock> real = patterns::wall(asked);
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

TEST(WallRefusal, NamesEveryParameterThatMakesNoWall)
{
    const auto refusal = [](const auto& change) {
        patterns::Wall asked = pierced_wall();
        change(asked);
        return refusal_of([&] { patterns::wall(asked); });
    };
    EXPECT_EQ(refusal([](patterns::Wall& wall) { wall.thickness = 0; }), "thickness: 0 m; must be > 0 m");
    EXPECT_EQ(refusal([](patterns::Wall& wall) { wall.length = std::nan(""), wall.height = -1; }),
              "length: nan m; must be > 0 m\nheight: -1 m; must be > 0 m");
    EXPECT_EQ(refusal([](patterns::Wall& wall) { wall.block_length = 9; }),
              "block: a block 9 m long in a wall of 8 m; the block must fit into the wall");
    EXPECT_EQ(refusal([](patterns::Wall& wall) { wall.block_height = 1e-9; }),
              "block: more than 200000 blocks; give a larger block or a smaller wall");
    EXPECT_EQ(refusal([](patterns::Wall& wall) { wall.length = wall.height = 120, wall.leaves = 99; }),
              "block: more than 200000 blocks; give a larger block or a smaller wall")
        << "every leaf has its own blocks";
    EXPECT_EQ(refusal([](patterns::Wall& wall) {
                  wall.openings = {{7.5, 0, 1, 3}};
              }),
              "openings[0]: from 7.5 m to 8.5 m along wall; it must lie between 0 m and 8 m");
    EXPECT_EQ(refusal([](patterns::Wall& wall) {
                  wall.openings = {{1, 2.5, 1, 1}};
              }),
              "openings[0]: from 2.5 m to 3.5 m above the foot; it must lie between 0 m and 3 m");
    EXPECT_EQ(refusal([](patterns::Wall& wall) {
                  wall.openings = {{1, 0, 1, 2}, {1.5, 0.5, 1, 1}};
              }),
              "openings[1]: openings[0] and openings[1] overlap; leave some wall between them\n"
              "openings[1]: openings[0] and the lintel over openings[1] overlap; leave some wall between them");
    EXPECT_EQ(refusal([](patterns::Wall& wall) {
                  wall.openings = {{0.2, 0, 1, 2}};
              }),
              "openings[0]: its lintel would reach from -0.05 m to 1.45 m along wall; both bearings must lie "
              "between 0 m and 8 m");
    EXPECT_EQ(refusal([](patterns::Wall& wall) {
                  wall.openings = {{1, 0, 1, 2.9}};
              }),
              "openings[0]: its lintel would reach up to 3.15 m; it must end at the top, 3 m, or below");
    EXPECT_EQ(refusal([](patterns::Wall& wall) {
                  wall.openings = {{1, 0, 1, 2}, {2.3, 0, 1, 2}};
              }),
              "openings[1]: the lintel over openings[0] and the lintel over openings[1] overlap; leave some wall "
              "between them");
    EXPECT_EQ(refusal([](patterns::Wall& wall) {
                  wall.openings = {{1, 0, 1, 2}, {4, 0, 1, 2.05}};
              }),
              "openings[1]: the head of openings[0] and the head of openings[1] lie 0.05 m apart in height; give "
              "them the same level, or separate them by at least a third of a course, 0.0833333 m, apart");
    EXPECT_EQ(refusal([](patterns::Wall& wall) {
                  wall.openings = {{0.1, 0, 1, 3}};
              }),
              "openings: only 0.1 m of wall between 0 m and 0.1 m; leave no wall, or at least a third of a block, "
              "0.166667 m");
    EXPECT_EQ(refusal([](patterns::Wall& wall) { wall.imperfection.joint = 0.1; }),
              "imperfection.joint: 0.1 m; must be >= 0 m and less than a quarter of the thickness of the wall or "
              "leaf");
    EXPECT_EQ(refusal([](patterns::Wall& wall) { wall.header_every = 2; }),
              "header_every: 2; must be > 0, in a wall of several leaves");
}

}  // namespace
}  // namespace voussoir::importers
