// `import` and `check` as their user meets them: exit codes, JSON, files.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/app/test_files.h"

namespace voussoir::app::commands
{
namespace
{

using nlohmann::json;

std::string contents(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Runs the program; its output goes to files `stdout` and `stderr` of the folder. @returns the exit code
int run(const TemporaryFolder& folder, const std::string& arguments)
{
    const std::string command = std::string(VOUSSOIR_PROGRAM) + " " + arguments + " > " +
                                (folder / "stdout").string() + " 2> " + (folder / "stderr").string();
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// An OBJ box. @param faces fewer than 6 leave it open
std::string obj_box(const std::string& name, std::array<double, 3> lower, std::array<double, 3> upper, int first,
                    int faces = 6)
{
    std::ostringstream text;
    text << "o " << name << "\n";
    for (int k = 0; k < 8; ++k)
        text << "v " << (k & 1 ? upper : lower)[0] << " " << (k & 2 ? upper : lower)[1] << " "
             << (k & 4 ? upper : lower)[2] << "\n";
    const int loops[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int i = 0; i < faces; ++i) {
        text << "f";
        for (const int v : loops[i]) text << " " << v + first;
        text << "\n";
    }
    return text.str();
}

TEST(Certificate, CheckOfASoundCase)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("case.yaml", two_boxes).string();
    EXPECT_EQ(run(folder, "check " + file + " --json " + (folder / "c.json").string()), 0);
    const json certificate = json::parse(contents(folder / "c.json"));
    EXPECT_TRUE(certificate["accepted"].get<bool>());
    const json& assembly = certificate["assembly"];
    ASSERT_EQ(assembly["contacts"].size(), 1U);
    EXPECT_EQ(assembly["contacts"][0]["a"].get<std::string>(), "floor");
    EXPECT_NEAR(assembly["contacts"][0]["area_m2"].get<double>(), 1, 1e-12);
    EXPECT_NEAR(assembly["contacts"][0]["gap_m"].get<double>(), 0, 1e-12);
    EXPECT_EQ(assembly["ground"], json::array({"floor"}));
    EXPECT_EQ(assembly["ground_from"].get<std::string>(), "foundations");
    EXPECT_TRUE(assembly["advice"].empty());
    for (const char* key : {"components", "floating", "unsupported", "gaps", "overlaps", "slivers", "size_ratio"})
        EXPECT_TRUE(assembly.contains(key)) << key;
    EXPECT_NE(contents(folder / "stdout")
                  .find("no faults were found in the assembly of the stones\n"
                        "the case can be run\n"),
              std::string::npos);
}

TEST(Certificate, JsonOnStandardOutputIsAloneThere)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("case.yaml", two_boxes).string();
    EXPECT_EQ(run(folder, "check " + file + " --json -"), 0);
    EXPECT_TRUE(json::parse(contents(folder / "stdout"))["accepted"].get<bool>());
}

TEST(Certificate, ACaseWithAFloatingBlockCanRunAndIsTold)
{
    const TemporaryFolder folder;
    const std::string file =
        folder
            .write("case.yaml", with(two_boxes, "lower: [-0.5, -0.5, 0], upper: [50 cm, 0.5, 1]",
                                     "lower: [-0.5, -0.5, 0.05], upper: [50 cm, 0.5, 1.05]"))
            .string();
    EXPECT_EQ(run(folder, "check " + file + " --json " + (folder / "c.json").string()), 0);
    const json assembly = json::parse(contents(folder / "c.json"))["assembly"];
    EXPECT_EQ(assembly["floating"], json::array({"floor", "stone"}));
    EXPECT_EQ(assembly["unsupported"], json::array({"stone"}));
    ASSERT_EQ(assembly["gaps"].size(), 1U);
    EXPECT_NEAR(assembly["gaps"][0]["gap_m"].get<double>(), 0.05, 1e-12);
    const std::string said = contents(folder / "stdout");
    EXPECT_NE(said.find("  finding: 1 pair stands 50 mm apart"), std::string::npos) << said;
    EXPECT_NE(said.find("\nthe case can be run\n"), std::string::npos) << said;
    EXPECT_EQ(said.find("fault:"), std::string::npos) << "what is a fault cannot be run:\n" << said;
}

TEST(Certificate, ACaseWhoseBoxesOverlapGetsOneAllTheSame)
{
    const TemporaryFolder folder;
    const std::string file =
        folder.write("case.yaml", with(two_boxes, "lower: [-0.5, -0.5, 0]", "lower: [-0.5, -0.5, -0.2]")).string();
    EXPECT_EQ(run(folder, "check " + file + " -o " + (folder / "out").string()), 2);
    const json certificate = json::parse(contents(folder / "out/certificate.json"));
    EXPECT_FALSE(certificate["accepted"].get<bool>());
    EXPECT_EQ(certificate["faults"].size(), 1U);
    ASSERT_EQ(certificate["assembly"]["overlaps"].size(), 1U);
    EXPECT_NEAR(certificate["assembly"]["overlaps"][0]["volume_m3"].get<double>(), 0.2, 1e-8);
    EXPECT_NEAR(certificate["assembly"]["overlaps"][0]["depth_m"].get<double>(), 0.2, 1e-9);
    EXPECT_NE(contents(folder / "out/contact_graph.csv").find("floor,stone,contact"), std::string::npos);
#ifdef VOUSSOIR_HAS_PICTURES
    EXPECT_TRUE(std::filesystem::exists(folder / "out/assembly.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out/defect_01_floor_stone.png"));
#endif
}

TEST(Certificate, AFolderThatCannotBeMadeIsRefusedBeforeTheWork)
{
    const TemporaryFolder folder;
    const std::string file = folder.write("case.yaml", two_boxes).string();
    EXPECT_EQ(run(folder, "check " + file + " -o " + file + "/out"), 2);
    EXPECT_TRUE(contents(folder / "stdout").empty());
}

#ifdef VOUSSOIR_HAS_GEOMETRY
TEST(Certificate, ImportOfAWallWithOpenJoints)
{
    const TemporaryFolder folder;
    const std::string file = folder
                                 .write("wall.obj", obj_box("slab", {0, 0, -0.5}, {2.1, 1, 0}, 1) +
                                                        obj_box("left", {0, 0, 0}, {1, 1, 1}, 9) +
                                                        obj_box("right", {1.02, 0, 0}, {2.02, 1, 1}, 17))
                                 .string();
    EXPECT_EQ(run(folder, "import " + file + " --json - -o " + (folder / "out").string()), 0);
    const json files = json::parse(contents(folder / "stdout"));
    const json& assembly = files[0]["assembly"];
    EXPECT_EQ(assembly["contacts"].size(), 2U);
    ASSERT_EQ(assembly["gaps"].size(), 1U);
    EXPECT_NEAR(assembly["gaps"][0]["gap_m"].get<double>(), 0.02, 1e-9);
    EXPECT_EQ(assembly["components"].size(), 1U);
    EXPECT_EQ(assembly["ground"], json::array({"slab"}));
    EXPECT_EQ(json::parse(contents(folder / "out/certificate.json")), files);
}

TEST(Certificate, OfThePortalOfTheDocsHasTheFindingsToldThere)
{
    const TemporaryFolder folder;
    EXPECT_EQ(run(folder, std::string("import ") + VOUSSOIR_DOCS + "/figures/geometry/portal.obj --json -"), 0);
    std::set<std::string> kinds;
    const json files = json::parse(contents(folder / "stdout"));
    for (const json& finding : files[0]["assembly"]["findings"]) kinds.insert(finding["kind"].get<std::string>());
    EXPECT_EQ(kinds, (std::set<std::string>{"overlaps", "floating", "unsupported", "gaps", "tilted", "slivers",
                                            "size ratio"}));
}

TEST(Certificate, OfSeveralFilesHasAFolderForEach)
{
    const TemporaryFolder folder;
    const std::string one = folder.write("one.obj", obj_box("a", {0, 0, 0}, {1, 1, 1}, 1)).string();
    const std::string two = folder.write("two.obj", obj_box("b", {0, 0, 0}, {1, 1, 1}, 1)).string();
    EXPECT_EQ(run(folder, "import " + one + " " + two + " -o " + (folder / "out").string()), 0);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/certificate.json"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out/01_one/contact_graph.csv"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out/02_two/contact_graph.csv"));
}

TEST(Certificate, OfACaseWithARefusedStone)
{
    const TemporaryFolder folder;
    folder.write("open.obj", obj_box("floor", {0, 0, -1}, {1, 1, 0}, 1) +
                                 obj_box("stone", {0, 0, 0}, {1, 1, 1}, 9) +
                                 obj_box("hole", {0, 0, 1}, {1, 1, 2}, 17, 5));
    const std::size_t first = two_boxes.find("  - {box"), last = two_boxes.find("foundation: {");
    std::string text = two_boxes;
    text.replace(first, last - first,
                 "  - {mesh: open.obj}\n  - {box: {name: ground, lower: [0, 0, -2], upper: [1, 1, -1]}, group: "
                 "foundation}\n");
    const std::string file = folder.write("case.yaml", text).string();
    EXPECT_EQ(run(folder, "check " + file + " --json " + (folder / "c.json").string()), 2);
    const json certificate = json::parse(contents(folder / "c.json"));
    ASSERT_EQ(certificate["files"][0]["stones"].size(), 3U);
    EXPECT_FALSE(certificate["files"][0]["stones"][2]["reason"].get<std::string>().empty());
    EXPECT_EQ(certificate["assembly"]["contacts"].size(), 2U) << "the accepted stones and the box are examined";
    EXPECT_EQ(certificate["assembly"]["ground"], json::array({"ground"}));
    EXPECT_EQ(certificate["assembly"]["findings"][0]["kind"].get<std::string>(), "refused");
    EXPECT_NE(contents(folder / "stderr").find("hole"), std::string::npos);
}
#endif

}  // namespace
}  // namespace voussoir::app::commands
