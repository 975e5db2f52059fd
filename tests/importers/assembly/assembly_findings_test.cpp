// Each finding is provoked by one small assembly, and its advice carries the right number.
#include <gtest/gtest.h>

#include "importers/assembly/assembly_words.h"
#include "tests/importers/assembly/stones.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Vector3d;

assembly::AssemblyOrigin from_import()
{
    assembly::AssemblyOrigin origin;
    origin.metres_per_unit = 1;
    return origin;
}

assembly::Assembly examined(std::vector<assembly::AssemblyStone> stones)
{
    return assembly::examine_assembly(std::move(stones), {}, from_import());
}

bool says(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

TEST(Findings, HeadJointsDrawnAsGaps)
{
    const assembly::Assembly assembly = examined(wall(3, 4, 0.025));
    ASSERT_EQ(assembly.gaps.size(), 9U);
    for (const assembly::StoneGap& gap : assembly.gaps) {
        EXPECT_NEAR(gap.width, 0.025, 1e-12);
        EXPECT_NEAR(gap.area, 0.2 * 0.2, 1e-9);
    }
    ASSERT_EQ(assembly.gap_groups.size(), 1U);
    const assembly::AssemblyFinding& gaps = finding(assembly, "gaps");
    EXPECT_TRUE(says(gaps.what, "9 pairs stand 25 mm apart")) << gaps.what;
    EXPECT_TRUE(says(gaps.advice, "--close-joints 2")) << gaps.advice;
    EXPECT_TRUE(says(gaps.advice, "40 GPa/m")) << gaps.advice;  // 1 GPa over 25 mm
    EXPECT_EQ(assembly.components.size(), 1U) << "the beds still touch";
}

TEST(Findings, TheClosingWidthIsEnoughAndNotMuchMore)
{
    for (const double widest : {0.025, 0.0250000001, 0.01, 0.0099, 1.0, 0.0312345}) {
        const double width = assembly::closing_width(widest);
        EXPECT_GE(width, widest);
        EXPECT_LE(width, 1.101 * widest);
    }
    EXPECT_NEAR(assembly::closing_width(0.0312345), 0.032, 1e-12);
    EXPECT_NEAR(assembly::closing_width(0.0250000001), 0.026, 1e-12);
}

TEST(Findings, GapsOfTwoWidthsAreToldApart)
{
    const assembly::Assembly assembly =
        examined({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1.01, 0, 0}, {2.01, 1, 1}),
                  box("c", {2.06, 0, 0}, {3.06, 1, 1})});
    ASSERT_EQ(assembly.gap_groups.size(), 2U);
    EXPECT_NEAR(assembly.gap_groups[0].narrowest, 0.01, 1e-12);
    EXPECT_NEAR(assembly.gap_groups[1].narrowest, 0.05, 1e-12);
    EXPECT_EQ(assembly.floating.size(), 3U);
    EXPECT_TRUE(says(finding(assembly, "floating").advice, "--close-joints 5"))
        << finding(assembly, "floating").advice;
}

TEST(Findings, AGapFilledByAThinStoneIsNone)
{
    const assembly::Assembly assembly =
        examined({box("a", {0, 0, 0}, {1, 1, 1}), box("mortar", {1, 0, 0}, {1.02, 1, 1}),
                  box("b", {1.02, 0, 0}, {2.02, 1, 1})});
    EXPECT_TRUE(assembly.gaps.empty());
    EXPECT_EQ(assembly.contacts.size(), 2U);
}

TEST(Findings, StonesFarApartAreNoGap)
{
    const assembly::Assembly assembly =
        examined({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {1.3, 0, 0}, {2.3, 1, 1})});
    EXPECT_TRUE(assembly.gaps.empty());
    EXPECT_TRUE(says(finding(assembly, "floating").what, "none is near"));
}

TEST(Findings, AnOverlapWithItsDepthAndVolume)
{
    const assembly::Assembly assembly =
        examined({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {0.2, 0.3, 0.9}, {0.7, 0.8, 2})});
    ASSERT_EQ(assembly.overlaps.size(), 1U);
    EXPECT_NEAR(assembly.overlaps[0].volume, 0.5 * 0.5 * 0.1, 1e-9);
    EXPECT_NEAR(assembly.overlaps[0].depth, 0.1, 1e-9);
    const assembly::AssemblyFinding& overlap = finding(assembly, "overlaps");
    EXPECT_TRUE(says(overlap.what, "a and b")) << overlap.what;
    EXPECT_TRUE(says(overlap.advice, "at most 100 mm; or 50 mm")) << overlap.advice;
}

TEST(Findings, AnOverlapWithinTheContactToleranceIsANote)
{
    const std::vector<assembly::AssemblyStone> stones = {box("a", {0, 0, 0}, {1, 1, 1}),
                                                         box("b", {0, 0, 0.9999}, {1, 1, 2})};
    EXPECT_TRUE(finding(assembly::examine_assembly(stones, {{0, 1, 1e-4, 0}}, {}), "overlaps").harmless);
    const std::vector<assembly::AssemblyStone> deep = {box("a", {0, 0, 0}, {1, 1, 1}),
                                                       box("b", {0, 0, 0.9}, {1, 1, 2})};
    EXPECT_FALSE(finding(examined(deep), "overlaps").harmless);
}

TEST(Findings, AKnownOverlapKeepsItsExactVolume)
{
    const assembly::Assembly assembly = assembly::examine_assembly(
        {box("a", {0, 0, 0}, {1, 1, 1}), box("b", {0, 0, 0.9}, {1, 1, 2})}, {{1, 0, 0.125, 0}}, {});
    ASSERT_EQ(assembly.overlaps.size(), 1U);
    EXPECT_EQ(assembly.overlaps[0].a, 0);
    EXPECT_EQ(assembly.overlaps[0].volume, 0.125);
    EXPECT_NEAR(assembly.overlaps[0].depth, 0.1, 1e-9);
}

TEST(Findings, AStoneInTheAir)
{
    const assembly::Assembly assembly = examined(
        {box("a", {0, 0, 0}, {1, 1, 1}), box("b", {0, 0, 1}, {1, 1, 2}), box("kite", {5, 0, 7}, {6, 1, 8})});
    EXPECT_EQ(assembly.floating, std::vector<int>{2});
    EXPECT_EQ(assembly.unsupported, std::vector<int>{2});
    EXPECT_EQ(assembly.components.size(), 2U);
    EXPECT_TRUE(says(finding(assembly, "floating").what, "kite"));
    EXPECT_FALSE(has_finding(assembly, "unsupported")) << "a floating stone is told once";
}

TEST(Findings, TwoStonesThatHangTogetherInTheAir)
{
    const assembly::Assembly assembly =
        examined({box("a", {0, 0, 0}, {1, 1, 1}), box("b", {0, 0, 1}, {1, 1, 2}),
                  box("kite", {5, 0, 7}, {6, 1, 8}), box("tail", {5, 0, 6}, {6, 1, 7})});
    EXPECT_TRUE(assembly.floating.empty());
    EXPECT_EQ(assembly.unsupported, (std::vector<int>{2, 3}));
    EXPECT_TRUE(says(finding(assembly, "unsupported").what, "kite, tail"));
}

TEST(Findings, FoundationsAreTheGroundWhereThereAreAny)
{
    std::vector<assembly::AssemblyStone> stones = {box("a", {0, 0, 0}, {1, 1, 1}), box("b", {3, 0, 0}, {4, 1, 1}),
                                                   box("c", {3, 0, 1}, {4, 1, 2})};
    stones[0].foundation = true;
    const assembly::Assembly assembly = examined(stones);
    EXPECT_TRUE(assembly.ground_given);
    EXPECT_EQ(assembly.unsupported, (std::vector<int>{1, 2}));
}

TEST(Findings, ASliverAndAShortEdge)
{
    const assembly::Assembly assembly =
        examined({box("slab", {0, 0, 0}, {1, 1, 1}), box("flake", {0, 0, 1}, {1, 1, 1.005})});
    ASSERT_EQ(assembly.slivers.size(), 1U);
    EXPECT_EQ(assembly.slivers[0].stone, 1);
    EXPECT_TRUE(assembly.slivers[0].thin);
    EXPECT_NEAR(assembly.slivers[0].width, 0.005, 1e-12);
    EXPECT_TRUE(says(finding(assembly, "slivers").what, "flake"));
    // a prism whose outline has two corners half a millimetre apart
    const double e = 5e-4;
    const assembly::AssemblyStone nicked = stone("nicked", make_convex_polyhedron({{0, 0, 0},
                                                                                   {1, 0, 0},
                                                                                   {1, 1 - e, 0},
                                                                                   {1 - e, 1, 0},
                                                                                   {0, 1, 0},
                                                                                   {0, 0, 1},
                                                                                   {1, 0, 1},
                                                                                   {1, 1 - e, 1},
                                                                                   {1 - e, 1, 1},
                                                                                   {0, 1, 1}},
                                                                                  {{4, 3, 2, 1, 0},
                                                                                   {5, 6, 7, 8, 9},
                                                                                   {0, 1, 6, 5},
                                                                                   {1, 2, 7, 6},
                                                                                   {2, 3, 8, 7},
                                                                                   {3, 4, 9, 8},
                                                                                   {4, 0, 5, 9}}));
    const assembly::Assembly short_edged = examined({nicked});
    ASSERT_EQ(short_edged.slivers.size(), 1U);
    EXPECT_FALSE(short_edged.slivers[0].thin);
    EXPECT_TRUE(has_finding(short_edged, "short edges"));
}

TEST(Findings, FacesTiltedAgainstEachOther)
{
    Eigen::Isometry3d tilt = Eigen::Isometry3d::Identity();
    tilt.translate(Vector3d(0, 0, 1));
    tilt.rotate(Eigen::AngleAxisd(-0.05, Vector3d::UnitY()));
    std::vector<assembly::AssemblyStone> stones = moved({box("top", {0, 0, 0}, {1, 1, 1})}, tilt);
    stones.push_back(box("base", {0, 0, 0}, {1, 1, 1}));
    const assembly::Assembly assembly = examined(stones);
    ASSERT_EQ(assembly.contacts.size(), 1U);
    EXPECT_EQ(assembly.contacts[0].touch, assembly::Touch::tilted);
    EXPECT_NEAR(assembly.contacts[0].area, 0.002 / std::tan(0.05), 1e-4);  // nearer than the two reaches of 1 mm
    EXPECT_NEAR(assembly.contacts[0].largest_gap, std::sin(0.05), 2e-3);
    EXPECT_TRUE(has_finding(assembly, "tilted"));
}

TEST(Findings, APebbleBesideARock)
{
    const assembly::Assembly assembly =
        examined({box("rock", {0, 0, 0}, {2, 2, 2}), box("pebble", {0, 0, 2}, {0.1, 0.1, 2.1})});
    EXPECT_NEAR(assembly.size_ratio, 8000, 1e-6);
    const assembly::AssemblyFinding& ratio = finding(assembly, "size ratio");
    EXPECT_TRUE(says(ratio.what, "rock") && says(ratio.what, "pebble")) << ratio.what;
}

// A stone in the air is nothing to mend where the case wants it there.
TEST(Findings, StonesThatBeginApartAreMeantToBe)
{
    std::vector<assembly::AssemblyStone> stones = wall(2, 3);
    for (ConvexPolyhedron& part : stones.back().parts)
        for (Vector3d& x : part.vertices) x.z() += 2;
    assembly::AssemblyOrigin origin = from_import();
    EXPECT_TRUE(has_finding(assembly::examine_assembly(stones, {}, origin), "floating"));
    origin.apart = {stones.back().name};
    EXPECT_FALSE(has_finding(assembly::examine_assembly(stones, {}, origin), "floating"));
    origin.apart = {stones.front().name};
    EXPECT_TRUE(has_finding(assembly::examine_assembly(stones, {}, origin), "floating"));
}

TEST(Findings, ABridgeOfMillimetresHasTheWrongUnit)
{
    std::vector<assembly::AssemblyStone> stones = wall(2, 3);
    for (assembly::AssemblyStone& each : stones) {
        for (ConvexPolyhedron& part : each.parts)
            for (Vector3d& x : part.vertices) x *= 1e-3;
        each.volume *= 1e-9;
    }
    assembly::AssemblyOrigin origin;
    origin.metres_per_unit = 1e-3;
    const assembly::Assembly assembly = assembly::examine_assembly(stones, {}, origin);
    EXPECT_TRUE(says(finding(assembly, "unit").advice, "--unit m the whole is 1.4 m"))
        << finding(assembly, "unit").advice;
    EXPECT_FALSE(has_finding(examined(wall(2, 3)), "unit"));
}

TEST(Findings, ACaseIsToldOfKeysAndAnImportOfOptions)
{
    assembly::AssemblyOrigin origin;
    origin.from_case = true;
    const assembly::Assembly assembly = assembly::examine_assembly(wall(2, 3, 0.01), {}, origin);
    EXPECT_TRUE(says(finding(assembly, "gaps").advice, "close_joints: 1")) << finding(assembly, "gaps").advice;
    EXPECT_FALSE(says(finding(assembly, "gaps").advice, "--close-joints"));
}

}  // namespace
}  // namespace voussoir::importers
