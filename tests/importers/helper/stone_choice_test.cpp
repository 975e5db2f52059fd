// Which stones of a file are taken, what becomes of bad ones, and that all of it is told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "importers/helper/import_meshes.h"
#include "importers/helper/repair_summary.h"
#include "importers/helper/wire.h"
#include "importers/mesh/write_obj.h"
#include "tests/importers/concave_shapes.h"
#include "tests/importers/rough_stone.h"

namespace voussoir::importers
{
namespace
{

using Names = std::vector<std::string>;

mesh::PolygonSurface named(mesh::PolygonSurface surface, const std::string& name, double x = 0)
{
    surface.name = name;
    for (Eigen::Vector3d& v : surface.vertices) v.x() += x;
    return surface;
}

/// Two sound stones, one that is open and one whose vertices lie in a plane.
class StoneChoices : public ::testing::Test
{
 protected:
    StoneChoices()
    {
        mesh::PolygonSurface open = named(box({0, 0, 0}, {1, 2, 3}), "lid", 3), sheet{"sheet", {}, {}};
        open.faces.pop_back();
        sheet.vertices = {{9, 0, 0}, {10, 0, 0}, {10, 1, 0}, {9, 1, 0}};
        sheet.faces = {{0, 1, 2, 3}};
        file_ = folder_.write(
            "four.obj",
            mesh::to_obj({named(unit_cube(), "arch_1"), named(l_shape(), "arch_2", 6), open, sheet}, {}));
    }
    helper::ImportedMesh import(helper::StoneChoice choice, helper::StoneSimplification simplify = {},
                                double volume_error = 0.01) const
    {
        helper::MeshRequest request;
        request.file = file_;
        request.choice = std::move(choice);
        request.simplify = std::move(simplify);
        request.volume_error = volume_error;
        // What is asked for crosses the wire, and so does the answer.
        const helper::HelperRequest sent =
            helper::request_from_json(helper::to_json(helper::HelperRequest{{request}, {}}));
        return helper::geometry_from_json(helper::to_json(helper::import_meshes(sent.meshes))).meshes.at(0);
    }
    static Names taken(const helper::ImportedMesh& mesh)
    {
        Names names;
        for (const helper::Stone& stone : mesh.stones) names.push_back(stone.name);
        return names;
    }

    TemporaryFolder folder_;
    std::filesystem::path file_;
};

TEST_F(StoneChoices, RefusalsNameTheCureThatWorks)
{
    const helper::ImportedMesh refused = import({});
    EXPECT_FALSE(refused.accepted);
    ASSERT_EQ(refused.stones.size(), 4U);
    helper::StoneChoice cure;
    for (const helper::Stone& stone : refused.stones) {
        EXPECT_EQ(stone.cure.empty(), stone.reason.empty());
        if (stone.cure == "hull") cure.hull.push_back(stone.name);
        if (stone.cure == "skip") cure.skip.push_back(stone.name);
    }
    EXPECT_EQ(cure.hull, Names{"lid"});
    EXPECT_EQ(cure.skip, Names{"sheet"});
    const helper::ImportedMesh cured = import(cure);
    EXPECT_TRUE(cured.accepted) << cured.reason;
    EXPECT_EQ(taken(cured), (Names{"arch_1", "arch_2", "lid"}));
    EXPECT_TRUE(cured.unmatched.empty());
}

TEST_F(StoneChoices, AHullHasTheMassOfTheStoneWhereThatHasOne)
{
    const helper::ImportedMesh mesh = import({.skip = {"sheet"}, .hull = {"lid", "arch_2"}});
    ASSERT_TRUE(mesh.accepted) << mesh.reason;
    const helper::Stone &l = mesh.stones[1], &lid = mesh.stones[2];
    EXPECT_NEAR(l.moments.volume, 3, 1e-12) << "the stone's own";
    EXPECT_NEAR(l.volume_error, 3.5 / 3 - 1, 1e-12);
    EXPECT_NEAR(moments_of(l.parts).volume, 3.5, 1e-12);
    EXPECT_NEAR(lid.moments.volume, 6, 1e-12) << "an open one has none: the hull's";
    EXPECT_EQ(lid.volume_error, 0);
    EXPECT_NE(lid.repairs.back().text.find("it is not closed"), std::string::npos) << "the reason is told";
    EXPECT_NE(lid.repairs.back().text.find("mass and inertia are those of the hull"), std::string::npos);
    EXPECT_NE(l.repairs.back().text.find("its mass and inertia stay those of the surface as drawn"),
              std::string::npos);
}

TEST_F(StoneChoices, RulesOfRepairMendWhatCanBeMended)
{
    const helper::ImportedMesh skipped = import({.repair = helper::RepairRule::skip});
    EXPECT_TRUE(skipped.accepted) << skipped.reason;
    EXPECT_EQ(taken(skipped), (Names{"arch_1", "arch_2"}));
    ASSERT_EQ(skipped.skipped.size(), 2U);
    EXPECT_NE(skipped.skipped[0].why.find("it is not closed"), std::string::npos);
    EXPECT_EQ(helper::skipped_in_words(skipped),
              Names{"2 stones were left out (repair: skip, for they would be refused): lid, sheet"});

    const helper::ImportedMesh hulls = import({.repair = helper::RepairRule::hull});
    EXPECT_FALSE(hulls.accepted) << "a sheet has no hull with a volume";
    EXPECT_EQ(hulls.stones[2].reason, "");
    EXPECT_EQ(hulls.stones[3].cure, "skip");
    EXPECT_EQ(hulls.stones[1].parts.size(), 2U) << "a sound stone stays as it is";
}

TEST_F(StoneChoices, PatternsChooseByNameAndEveryOneMustMatch)
{
    const helper::ImportedMesh only = import({.only = {"arch_?"}});
    EXPECT_TRUE(only.accepted) << only.reason;
    EXPECT_EQ(taken(only), (Names{"arch_1", "arch_2"}));
    EXPECT_EQ(only.skipped.size(), 2U);
    const helper::ImportedMesh one = import({.skip = {"arch_2", "keystone"}, .only = {"arch_*"}});
    EXPECT_EQ(taken(one), Names{"arch_1"});
    ASSERT_EQ(one.unmatched.size(), 1U);
    EXPECT_EQ(one.unmatched[0].key + ": " + one.unmatched[0].pattern, "skip: keystone");
    const helper::ImportedMesh none = import({.skip = {"*"}});
    EXPECT_FALSE(none.accepted);
    EXPECT_NE(none.reason.find("every stone was left out"), std::string::npos);
}

TEST_F(StoneChoices, ASkippedStoneIsNotLookedAt)
{
    const helper::ImportedMesh mesh = import({.skip = {"lid", "sheet"}});
    EXPECT_TRUE(mesh.accepted);
    EXPECT_EQ(mesh.skipped[0].why, "skip");
}

TEST_F(StoneChoices, TypesOfABuildingModelAreTheBeginningsOfNames)
{
    file_ = folder_.write(
        "house.obj",
        mesh::to_obj({named(unit_cube(), "IfcWall_south_1"), named(unit_cube(), "IfcWindow_1", 5)}, {}));
    const helper::ImportedMesh mesh = import({.skip_types = {"IfcWindow"}});
    EXPECT_TRUE(mesh.accepted) << mesh.reason;
    EXPECT_EQ(taken(mesh), Names{"IfcWall_south_1"});
    EXPECT_EQ(import({.skip_types = {"IfcWin"}}).unmatched.size(), 1U) << "a whole type";
}

TEST_F(StoneChoices, AStoneThatIsTooRoughBecomesAFewPartsByItsCure)
{
    file_ = folder_.write("rough.obj", mesh::to_obj({rough_stone(4, 0.02), named(l_shape(), "arch", 5)}, {}));
    const helper::ImportedMesh refused = import({}, {}, 1e-3);
    ASSERT_FALSE(refused.accepted);
    EXPECT_EQ(refused.stones[0].cure, "simplify");
    const helper::ImportedMesh mesh = import({}, {.stones = {"boul*"}, .parts = 5});
    ASSERT_TRUE(mesh.accepted) << mesh.reason;
    EXPECT_EQ(mesh.stones[0].parts.size(), 5U);
    EXPECT_EQ(mesh.stones[0].moments.volume, refused.stones[0].moments.volume);
    EXPECT_EQ(mesh.stones[1].parts.size(), 2U);
    EXPECT_NE(mesh.stones[1].repairs.back().kind, "simplified to convex parts") << "it was not asked for";
}

/// assimp reads in 32-bit numbers: far from the origin a small stone comes rounded.
TEST(Rounding, JoinsVerticesAsWidelyAsItNeedsOrRefusesThatStoneOnly)
{
    const TemporaryFolder folder;
    const auto moved = [](mesh::PolygonSurface surface, const std::string& name, double scale, double y) {
        surface.name = name;
        for (Eigen::Vector3d& v : surface.vertices) v = scale * v + Eigen::Vector3d(100, y, 0);
        return surface;
    };
    // Rounded by 1e-5 m: large enough, small for the rounding, and too small.
    const auto file = folder.write(
        "far.obj", mesh::to_obj({moved(unit_cube(), "large", 20, 0), moved(unit_cube(), "small", 0.5, 40),
                                 moved(unit_cube(), "tiny", 0.002, 60)},
                                {}));
    helper::MeshRequest request;
    request.file = file;
    request.reader = mesh::MeshReader::assimp;
    const helper::ImportedMesh mesh = helper::import_meshes({request}).meshes[0];
    ASSERT_EQ(mesh.stones.size(), 3U) << mesh.reason;
    EXPECT_EQ(mesh.stones[0].reason, "");
    EXPECT_EQ(mesh.stones[1].reason, "");
    ASSERT_FALSE(mesh.stones[1].repairs.empty());
    EXPECT_EQ(mesh.stones[1].repairs[0].kind, "joined within the rounding of reading");
    EXPECT_NEAR(mesh.stones[1].moments.volume, 0.125, 0.125 * 6 * 1e-5 / 0.5);
    EXPECT_NE(mesh.stones[2].reason.find("too much for its size"), std::string::npos) << mesh.stones[2].reason;
    request.choice.repair = helper::RepairRule::skip;
    EXPECT_TRUE(helper::import_meshes({request}).meshes[0].accepted) << "one stone does not refuse the file";
}

}  // namespace
}  // namespace voussoir::importers
