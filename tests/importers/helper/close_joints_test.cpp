#include "importers/helper/close_joints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "importers/assembly/assembly.h"
#include "importers/helper/import_meshes.h"
#include "importers/mesh/write_obj.h"
#include "tests/importers/concave_shapes.h"

namespace voussoir::importers
{
namespace
{

constexpr double gap = 0.025, length = 0.5, height = 0.25, depth = 0.3;

/// Three courses of bricks with head and bed joints drawn as gaps.
std::vector<mesh::PolygonSurface> bricks()
{
    std::vector<mesh::PolygonSurface> stones;
    for (int c = 0; c < 3; ++c)
        for (int b = 0; b < 4; ++b) {
            const double x = b * (length + gap) + (c % 2) * (length + gap) / 2, z = c * (height + gap);
            mesh::PolygonSurface brick = box({x, 0, z}, {x + length, depth, z + height});
            brick.name = "brick_" + std::to_string(c) + std::to_string(b);
            stones.push_back(brick);
        }
    return stones;
}

helper::ImportedMesh import(const std::vector<mesh::PolygonSurface>& stones, double close)
{
    const TemporaryFolder folder;
    return helper::import_meshes(
               {{.file = folder.write("stones.obj", mesh::to_obj(stones, {})), .close_joints = close}})
        .meshes[0];
}

assembly::Assembly assembly_of(const helper::ImportedMesh& mesh)
{
    std::vector<assembly::AssemblyStone> stones;
    for (const helper::Stone& stone : mesh.stones)
        stones.push_back({stone.name, stone.parts, stone.moments.volume, stone.volume_error, false});
    return assembly::examine_assembly(stones, {}, {});
}

TEST(CloseJoints, MovesFacingFacesToTheMiddle)
{
    EXPECT_TRUE(assembly_of(import(bricks(), 0)).contacts.empty());
    const helper::ImportedMesh closed = import(bricks(), 0.03);
    ASSERT_TRUE(closed.accepted) << closed.reason;
    const assembly::Assembly assembly = assembly_of(closed);
    EXPECT_TRUE(assembly.gaps.empty());
    EXPECT_TRUE(assembly.floating.empty());
    double head = 0, bed = 0;
    for (const assembly::StoneContact& contact : assembly.contacts)
        (std::abs(contact.normal.z()) > 0.5 ? bed : head) += contact.area;
    // Courses are 25 cm high and the two beds grew by half a joint each; the middle course is 27.5 cm high.
    EXPECT_NEAR(head, depth * 3 * (2 * (height + gap / 2) + height + gap), 1e-9);
    const double course = 4 * length + 3 * gap, half = (length + gap) / 2;
    EXPECT_NEAR(bed, depth * 2 * (course - half), 1e-9);
    double volume = 0;
    for (const helper::Stone& stone : closed.stones) {
        volume += stone.moments.volume;
        ASSERT_EQ(stone.repairs.size(), 1U);
        EXPECT_NE(stone.repairs[0].text.find("the stone grew by"), std::string::npos);
    }
    EXPECT_NEAR(volume, depth * course * (3 * height + 2 * gap), 1e-9);
}

TEST(CloseJoints, LeavesWiderGapsOpen)
{
    const helper::ImportedMesh open = import(bricks(), 0.02);
    EXPECT_TRUE(assembly_of(open).contacts.empty());
    EXPECT_TRUE(open.stones[0].repairs.empty());
}

TEST(CloseJoints, ClosesJointsOfDifferentWidthWithoutOverlaps)
{
    std::vector<mesh::PolygonSurface> stones{box({0, 0, 0}, {2, 1, 1}), box({0, 0, 1.01}, {0.99, 1, 2}),
                                             box({1.01, 0, 1.03}, {2, 1, 2})};
    for (std::size_t i = 0; i < stones.size(); ++i) stones[i].name = "stone_" + std::to_string(i);
    for (const double width : {0.03, 0.031}) {  // the drawn width itself will do
        const helper::ImportedMesh closed = import(stones, width);
        ASSERT_TRUE(closed.accepted) << closed.reason;
        const assembly::Assembly assembly = assembly_of(closed);
        EXPECT_TRUE(assembly.gaps.empty());
        ASSERT_EQ(assembly.contacts.size(), 3U);
        double volume = 0;
        for (const helper::Stone& stone : closed.stones) volume += stone.moments.volume;
        EXPECT_NEAR(volume, 4, 1e-6);
        for (const assembly::StoneContact& contact : assembly.contacts) EXPECT_GT(contact.smallest_gap, -1e-6);
    }
}

TEST(CloseJoints, MovesTheWholeWallOfAGluedStone)
{
    mesh::PolygonSurface l = l_shape();  // its wall x = 0 belongs to two parts; the post faces only one of them
    mesh::PolygonSurface post = box({-0.5, 1.2, 0}, {-gap, 2, 1});
    post.name = "post";
    l.name = "L";
    const helper::ImportedMesh closed = import({l, post}, 0.03);
    ASSERT_TRUE(closed.accepted) << closed.reason;
    EXPECT_NEAR(closed.stones[0].moments.volume, 3 + 2 * gap / 2, 1e-9);
    const assembly::Assembly assembly = assembly_of(closed);
    ASSERT_EQ(assembly.contacts.size(), 1U);
    EXPECT_NEAR(assembly.contacts[0].area, 0.8, 1e-9);
}

}  // namespace
}  // namespace voussoir::importers
