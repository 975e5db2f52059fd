#include "importers/helper/repair_summary.h"

#include <gtest/gtest.h>

#include "importers/helper/wire.h"

namespace voussoir::importers
{
namespace
{

helper::ImportedMesh mended_mesh()
{
    helper::ImportedMesh mesh;
    mesh.file = "vault.obj";
    mesh.repairs = {{"", "the text is UTF-16 and was read as such"}};
    for (int i = 0; i < 90; ++i) {
        helper::Stone& stone = mesh.stones.emplace_back();
        stone.name = "stone_" + std::to_string(i);
        stone.reason = "a stone of this test has no shape";
        stone.repairs.push_back(
            {"vertices welded", "2 vertices were welded", 2, "vertices", i == 41 ? 3e-6 : 1e-7, "m"});
        stone.repairs.push_back({"joints left open", "its joints were left open"});
    }
    mesh.stones[7].repairs.push_back({"turned inside out", "all 12 faces were turned outward", 12, "faces"});
    return mesh;
}

TEST(RepairSummary, HasOneLineForEachKindWithTheWorstStone)
{
    std::vector<std::string> lines;
    for (const helper::RepairSummary& kind : helper::summarised_repairs(mended_mesh()))
        lines.push_back(helper::in_words(kind));
    EXPECT_EQ(lines, (std::vector<std::string>{
                         "the text is UTF-16 and was read as such",
                         "vertices welded: 90 stones, 180 vertices, at most 3e-06 m (stone_41)",
                         "joints left open: 90 stones",
                         "stone_7: all 12 faces were turned outward",
                     }));
    EXPECT_EQ(helper::all_repairs(mended_mesh()).size(), 182U);
}

TEST(RepairSummary, TellsRepairsOfTheFileFromThoseOfItsStones)
{
    helper::ImportedMesh mesh = mended_mesh();
    mesh.repairs = {{"cavities", "\"a\": 1", 1, "cavities"}, {"cavities", "\"b\": 2", 2, "cavities"}};
    mesh.stones[3].repairs = {{"cavities", "3 cavities", 3, "cavities"}};
    const std::vector<helper::RepairSummary> kinds = helper::summarised_repairs(mesh);
    EXPECT_EQ(helper::in_words(kinds[0]), "cavities: 2 times in the file, 3 cavities");
    const auto of_stone = std::find_if(kinds.begin() + 1, kinds.end(),
                                       [](const helper::RepairSummary& kind) { return kind.kind == "cavities"; });
    ASSERT_NE(of_stone, kinds.end());
    EXPECT_EQ(helper::in_words(*of_stone), "stone_3: 3 cavities");
}

TEST(RepairSummary, CrossesTheWireUnchanged)
{
    helper::Geometry geometry;
    geometry.meshes = {mended_mesh()};
    const helper::Geometry back = helper::geometry_from_json(helper::to_json(geometry));
    const std::vector<mesh::Repair>& sent = geometry.meshes[0].stones[41].repairs;
    const std::vector<mesh::Repair>& received = back.meshes.at(0).stones.at(41).repairs;
    ASSERT_EQ(received.size(), sent.size());
    for (std::size_t i = 0; i < sent.size(); ++i) {
        EXPECT_EQ(received[i].kind, sent[i].kind);
        EXPECT_EQ(received[i].text, sent[i].text);
        EXPECT_EQ(received[i].count, sent[i].count);
        EXPECT_EQ(received[i].counted, sent[i].counted);
        EXPECT_EQ(received[i].worst, sent[i].worst);
        EXPECT_EQ(received[i].unit, sent[i].unit);
    }
    EXPECT_EQ(back.meshes[0].repairs.at(0).text, geometry.meshes[0].repairs[0].text);
}

}  // namespace
}  // namespace voussoir::importers
