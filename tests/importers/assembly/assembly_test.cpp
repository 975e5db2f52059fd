// The contact graph: closed-form areas, the same in any position and order.
#include "importers/assembly/assembly.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <random>

#include "tests/importers/assembly/stones.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Vector3d;
using Graph = std::map<std::pair<std::string, std::string>, double>;

assembly::Assembly examined(const std::vector<assembly::AssemblyStone>& stones)
{
    return assembly::examine_assembly(stones, {}, {});
}

/// Area by pair of names, in alphabetical order.
Graph graph_of(const assembly::Assembly& assembly)
{
    Graph graph;
    for (const assembly::StoneContact& contact : assembly.contacts) {
        const auto names = std::minmax(assembly.stones[contact.a].name, assembly.stones[contact.b].name);
        graph[{names.first, names.second}] = contact.area;
    }
    return graph;
}

void expect_same(const Graph& graph, const Graph& reference)
{
    ASSERT_EQ(graph.size(), reference.size());
    for (const auto& [pair, area] : reference) {
        ASSERT_TRUE(graph.contains(pair)) << pair.first << " " << pair.second;
        EXPECT_NEAR(graph.at(pair), area, 1e-6 * area) << pair.first << " " << pair.second;
    }
}

TEST(ContactGraph, AWallOfBoxesHasItsClosedForm)
{
    const assembly::Assembly assembly = examined(wall(3, 4));
    // on the slab 4; heads 3 in each course; beds: 4 bricks over 4 shifted by a half, 4 + 3, twice
    EXPECT_EQ(assembly.contacts.size(), 4U + 3 * 3 + 2 * 7);
    double area = 0;
    for (const assembly::StoneContact& contact : assembly.contacts) area += contact.area;
    EXPECT_NEAR(area, 4 * 0.4 * 0.2 + 9 * 0.2 * 0.2 + 14 * 0.2 * 0.2, 1e-9);
    EXPECT_EQ(assembly.components.size(), 1U);
    EXPECT_TRUE(assembly.gaps.empty());
    EXPECT_TRUE(assembly.findings.empty());
    EXPECT_EQ(assembly.ground, std::vector<int>{0});
    EXPECT_FALSE(assembly.ground_given);
}

TEST(ContactGraph, AnArchTouchesInItsJoints)
{
    const assembly::Assembly assembly = examined(arch(15, 2, 2.5));
    ASSERT_EQ(assembly.contacts.size(), 14U);
    for (const assembly::StoneContact& contact : assembly.contacts) {
        EXPECT_EQ(contact.b, contact.a + 1);
        EXPECT_NEAR(contact.area, 0.5, 1e-6);
        const double angle = std::numbers::pi * contact.b / 15;  // of the joint; a looks at b along the ring
        EXPECT_NEAR(contact.normal.dot(Vector3d(std::sin(angle), 0, std::cos(angle))), 1, 1e-9);
    }
    EXPECT_EQ(assembly.ground, (std::vector<int>{0, 14}));
    EXPECT_TRUE(assembly.findings.empty());
}

TEST(ContactGraph, IsTheSameAfterAMotionAndInAnotherOrder)
{
    const std::vector<assembly::AssemblyStone> stones = wall(4, 5);
    const Graph reference = graph_of(examined(stones));
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    motion.rotate(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
    motion.pretranslate(Vector3d(31, -17, 8));
    expect_same(graph_of(examined(moved(stones, motion))), reference);
    std::vector<assembly::AssemblyStone> shuffled = stones;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
    expect_same(graph_of(examined(shuffled)), reference);
}

TEST(ContactGraph, DoesNotDependOnTheSize)
{
    const assembly::Assembly small = examined(wall(2, 3));
    std::vector<assembly::AssemblyStone> stones = wall(2, 3);
    for (assembly::AssemblyStone& each : stones) {
        for (ConvexPolyhedron& part : each.parts)
            for (Vector3d& x : part.vertices) x *= 10;
        each.volume *= 1000;
    }
    const assembly::Assembly large = examined(stones);
    ASSERT_EQ(large.contacts.size(), small.contacts.size());
    for (std::size_t i = 0; i < small.contacts.size(); ++i)
        EXPECT_NEAR(large.contacts[i].area, 100 * small.contacts[i].area, 1e-8);
}

TEST(ContactGraph, GluedPartsCountOncePerPair)
{
    assembly::AssemblyStone pair = box("base", {0, 0, 0}, {1, 1, 1});
    ConvexPolyhedron left = make_box({0, 0, 1}, {0.5, 1, 2}), right = make_box({0.5, 0, 1}, {1, 1, 1.5});
    const assembly::AssemblyStone glued{"stepped", {left, right}, 0.75, 0, false};
    const assembly::Assembly assembly = examined({pair, glued});
    ASSERT_EQ(assembly.contacts.size(), 1U);
    EXPECT_EQ(assembly.contacts[0].patches, 2);
    EXPECT_NEAR(assembly.contacts[0].area, 1, 1e-9);
    EXPECT_NEAR(assembly.contacts[0].normal.z(), 1, 1e-12);
}

TEST(ContactGraph, OfAWallOf10000StonesTakesSeconds)
{
    const auto start = std::chrono::steady_clock::now();
    const assembly::Assembly assembly = examined(wall(100, 100));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_EQ(assembly.contacts.size(), 100U + 100 * 99 + 99 * 199);
    EXPECT_LT(seconds, 20);
}

TEST(SharedRegion, OfTwoBoxesIsABox)
{
    const auto region =
        assembly::shared_region(make_box({0, 0, 0}, {1, 1, 1}), make_box({0.75, 0.5, 0}, {2, 2, 1}));
    EXPECT_NEAR(assembly::volume_inside(region), 0.25 * 0.5, 1e-8);  // planes are widened by 1e-9 of the size
    EXPECT_TRUE(assembly::shared_region(make_box({0, 0, 0}, {1, 1, 1}), make_box({1.5, 0, 0}, {2, 1, 1})).empty());
}

}  // namespace
}  // namespace voussoir::importers
