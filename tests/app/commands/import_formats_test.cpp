// The formats that only assimp reads, imported by the program: a block of 1.2 x 0.6 x 0.4 m that is turned and
// moved, and a wedge of an arch.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/importers/mesh/assimp_files.h"

namespace voussoir::app::commands
{
namespace
{

using nlohmann::json;
namespace fs = std::filesystem;

constexpr double block_volume = 1.2 * 0.6 * 0.4;
const double wedge_angle = 3.14159265358979323846 / 9;
const double wedge_volume = 0.5 * (2.5 * 2.5 - 2 * 2) * std::sin(wedge_angle) * 0.4;

/// @param metres the unit in which they are written
std::vector<importers::PlacedSurface> stones_in(double metres)
{
    importers::PlacedSurface block{
        importers::box({0, 0, 0}, {1.2, 0.6, 0.4}),
        Eigen::Translation3d(3, -2, 5) * Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())};
    block.surface.name = "clé block";
    const Eigen::Rotation2Dd turn(wedge_angle);
    const Eigen::Vector2d inner(2, 0), outer(2.5, 0);
    importers::PlacedSurface wedge{importers::prism({inner, outer, turn * outer, turn * inner}, 0, 0.4)};
    wedge.surface.name = "wedge";
    std::vector<importers::PlacedSurface> stones{block, wedge};
    for (importers::PlacedSurface& stone : stones) {
        for (Eigen::Vector3d& x : stone.surface.vertices) x /= metres;
        stone.placement.translation() /= metres;
    }
    return stones;
}

std::string contents(const fs::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Runs `voussoir import` with these arguments. @returns the exit code
int import(const TemporaryFolder& folder, const std::string& arguments, std::string& out, std::string& error)
{
    const fs::path to = folder.path() / "stdout", faults = folder.path() / "stderr";
    const std::string command =
        std::string(VOUSSOIR_PROGRAM) + " import " + arguments + " > " + to.string() + " 2> " + faults.string();
    const int status = std::system(command.c_str());
    out = contents(to);
    error = contents(faults);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

struct Format {
    const char* name;  // of the file
    std::string bytes;
    bool states_unit = true;
};

std::vector<Format> formats()
{
    return {{"cm.fbx", importers::to_fbx(stones_in(0.01), 1)},
            {"m.fbx", importers::to_fbx(stones_in(1), 100)},
            {"a.x3d", importers::to_x3d(stones_in(1))},
            {"a.lwo", importers::to_lwo(stones_in(1))},
            {"half_metres.ogex", importers::to_ogex(stones_in(0.5), 0.5)},
            {"a.3ds", importers::to_3ds(stones_in(1)), false},
            {"inch.amf", importers::to_amf(stones_in(1), "inch", 0.0254)}};
}

void expect_stone(const json& stone, double volume, const Eigen::Vector3d& centroid)
{
    EXPECT_TRUE(stone["closed"].get<bool>());
    EXPECT_TRUE(stone["convex"].get<bool>());
    EXPECT_EQ(stone["parts"].get<int>(), 1);
    EXPECT_NEAR(stone["volume_m3"].get<double>(), volume, 1e-6 * volume);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(stone["centroid_m"][static_cast<std::size_t>(i)].get<double>(), centroid[i], 2e-6);
}

TEST(ImportFormats, ThatOnlyAssimpReadsGiveCertifiedStonesWithNamesVolumesAndPlaces)
{
    const TemporaryFolder folder;
    for (const Format& format : formats()) {
        SCOPED_TRACE(format.name);
        std::string out, error;
        ASSERT_EQ(import(folder, folder.write(format.name, format.bytes).string() + " --json -", out, error), 0)
            << error;
        const json file = json::parse(out)[0];
        EXPECT_TRUE(file["accepted"].get<bool>());
        EXPECT_EQ(file["unit"]["from"].get<std::string>(), format.states_unit ? "file" : "assumed");
        ASSERT_EQ(file["stones"].size(), 2U);
        for (const json& stone : file["stones"]) {
            const bool is_block = stone["name"].get<std::string>() == "clé block";
            EXPECT_EQ(stone["name"].get<std::string>(), is_block ? "clé block" : "wedge");
            const Eigen::Vector3d middle = stones_in(1)[0].placement * Eigen::Vector3d(0.6, 0.3, 0.2);
            // Of the trapezium between the chords: (2/3) cos(angle/2) (R^3 - r^3) / (R^2 - r^2) from the centre.
            const double reach = 2. / 3 * std::cos(wedge_angle / 2) * (2.5 * 2.5 * 2.5 - 8) / (2.5 * 2.5 - 4);
            const Eigen::Vector3d of_wedge(reach * std::cos(wedge_angle / 2), reach * std::sin(wedge_angle / 2),
                                           0.2);
            expect_stone(stone, is_block ? block_volume : wedge_volume, is_block ? middle : of_wedge);
        }
    }
}

TEST(ImportFormats, TheContentTellsWhatAFileIsNotItsName)
{
    const TemporaryFolder folder;
    for (const Format& format : formats()) {
        SCOPED_TRACE(format.name);
        std::string out, error;
        EXPECT_EQ(import(folder, folder.write("stones.dat", format.bytes).string() + " --json -", out, error), 0)
            << error;
        EXPECT_EQ(import(folder, (folder.path() / "stones.dat").string() + " --reader own", out, error), 2);
        EXPECT_NE(error.find("this format is read by assimp only"), std::string::npos) << error;
    }
}

TEST(ImportFormats, ARoundingThatMattersIsRefusedAndOneThatDoesNotIsStated)
{
    const TemporaryFolder folder;
    std::vector<importers::PlacedSurface> stones = stones_in(1);
    std::string out, error;
    ASSERT_EQ(
        import(folder, folder.write("near.x3d", importers::to_x3d(stones)).string() + " --json -", out, error), 0);
    EXPECT_NE(json::parse(out)[0]["repairs"][0].get<std::string>().find("rounded by up to 7"), std::string::npos)
        << out;
    for (importers::PlacedSurface& stone : stones)
        stone.placement.pretranslate(Eigen::Vector3d(500000, 4600000, 0));
    EXPECT_EQ(import(folder, folder.write("far.x3d", importers::to_x3d(stones)).string(), out, error), 2);
    EXPECT_NE(error.find("rounds its coordinates by up to 0.55"), std::string::npos) << error;
    EXPECT_NE(error.find("move the stones nearer to the origin"), std::string::npos) << error;
}

TEST(ImportFormats, ThatAreCutOffAreRefusedInWordsOrRead)
{
    const TemporaryFolder folder;
    for (const Format& format : formats())
        for (const std::size_t share : {3U, 6U}) {  // at 9, OpenGEX is read until the limit of 30 s
            std::string out, error;
            const fs::path file =
                folder.write(format.name, format.bytes.substr(0, format.bytes.size() * share / 10));
            const int code = import(folder, file.string() + " --json -", out, error);
            EXPECT_TRUE(code == 0 || (code == 2 && !error.empty())) << format.name << " " << share << ": " << code;
        }
}

TEST(ImportFormats, AssimpReadsWhatWeReadOurselvesWhenAsked)
{
    const TemporaryFolder folder;
    const importers::mesh::PolygonSurface cube = importers::unit_cube();
    std::string out, error;
    const std::string file = folder.write("a.obj", importers::mesh::to_obj({cube}, {})).string();
    ASSERT_EQ(import(folder, file + " --reader assimp --json -", out, error), 0) << error;
    EXPECT_NE(out.find("32-bit"), std::string::npos);
    ASSERT_EQ(import(folder, file + " --json -", out, error), 0) << error;
    EXPECT_EQ(out.find("32-bit"), std::string::npos);
    EXPECT_EQ(import(folder, folder.write("a.json", "{\"vertex\": {}}").string() + " --reader assimp", out, error),
              2);
    EXPECT_NE(error.find("assimp does not read this format"), std::string::npos) << error;
    EXPECT_EQ(import(folder, file + " --reader nobody", out, error), 2);
    EXPECT_EQ(import(folder, "", out, error), 2) << "no file";
}

TEST(ImportFormats, AreListedWithTheirReaders)
{
    const TemporaryFolder folder;
    std::string out, error;
    ASSERT_EQ(import(folder, "--formats --json -", out, error), 0) << error;
    std::map<std::string, std::string> reader;
    for (const json& format : json::parse(out))
        for (const json& extension : format["extensions"]) {
            EXPECT_TRUE(reader.emplace(extension.get<std::string>(), format["reader"].get<std::string>()).second)
                << extension << " is listed twice";
            EXPECT_NE(format["name"].get<std::string>(), "");
        }
    for (const char* own : {"obj", "ply", "off", "stl", "3mf", "gltf", "glb", "dae", "dxf", "json"})
        EXPECT_EQ(reader[own], "voussoir") << own;
    for (const char* other : {"fbx", "x3d", "lwo", "ogex", "3ds", "amf", "ifc", "blend", "x", "ase", "ac"})
        EXPECT_EQ(reader[other], "assimp") << other;
    ASSERT_EQ(import(folder, "--formats", out, error), 0);
    EXPECT_NE(out.find("Autodesk FBX"), std::string::npos);
}

}  // namespace
}  // namespace voussoir::app::commands
