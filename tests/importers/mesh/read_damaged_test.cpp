// Damaged files: every one is read or refused in words, never anything else.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/importers/mesh/read_shapes.h"

namespace voussoir::importers
{
namespace
{

/// Reads; anything but success or a sentence fails the test. @returns whether it was refused
bool refused_in_words(const std::filesystem::path& file, const std::string& what)
{
    try {
        const mesh::MeshFile read = mesh::read_mesh(file, {mesh::StonesBy::detect, mesh::MeshReader::own});
        EXPECT_FALSE(read.surfaces.empty()) << what;
        return false;
    } catch (const InputError& error) {
        EXPECT_FALSE(error.faults.empty()) << what;
    } catch (const std::exception& error) {
        ADD_FAILURE() << what << ": " << error.what();
    }
    return true;
}

void damage(const std::string& name, const std::string& bytes, const TemporaryFolder& folder)
{
    std::mt19937 random(12345);
    for (std::size_t i = 0; i < 20; ++i)
        refused_in_words(folder.write(name, bytes.substr(0, bytes.size() * i / 20)),
                         name + " cut off at " + std::to_string(i) + "/20");
    for (int i = 0; i < 50; ++i) {
        std::string flipped = bytes;
        flipped[random() % flipped.size()] ^= static_cast<char>(1 << random() % 8);
        refused_in_words(folder.write(name, flipped), name + " with flipped bit " + std::to_string(i));
        flipped[random() % flipped.size()] = static_cast<char>(random());
        flipped[random() % flipped.size()] = static_cast<char>(random());
        refused_in_words(folder.write(name, flipped), name + " with other bytes " + std::to_string(i));
    }
}

TEST(ReadDamaged, OwnFilesOfTheDoubleFormats)
{
    const TemporaryFolder folder;
    const mesh::PolygonSurface cube = triangulated(unit_cube());
    damage("a.obj", mesh::to_obj({cube}, {}), folder);
    damage("a.off", to_off(cube), folder);
    damage("a.stl", to_ascii_stl(cube, "a"), folder);
    damage("b.stl", to_binary_stl(cube, "solid b"), folder);
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
        damage("a.ply", to_ply(cube, format), folder);
}

TEST(ReadDamaged, CutFilesWhoseLengthIsAnnouncedAreRefused)
{
    const TemporaryFolder folder;
    const mesh::PolygonSurface cube = triangulated(unit_cube());
    for (const auto& [name, bytes] :
         std::vector<std::pair<std::string, std::string>>{{"a.off", to_off(cube)},
                                                          {"a.stl", to_ascii_stl(cube, "a")},
                                                          {"b.stl", to_binary_stl(cube, "b")},
                                                          {"a.ply", to_ply(cube, "ascii")},
                                                          {"b.ply", to_ply(cube, "binary_big_endian")}})
        for (std::size_t i = 1; i < 20; ++i)
            EXPECT_TRUE(refused_in_words(folder.write(name, bytes.substr(0, bytes.size() * i / 20)), name))
                << name << " cut off at " << i << "/20 was read";
}

TEST(ReadDamaged, DeepNestingIsNoCrash)
{
    const TemporaryFolder folder;
    std::string open, close, xml, end;
    for (int i = 0; i < 200000; ++i) {
        open += "[";
        close += "]";
        xml += "<node>";
        end += "</node>";
    }
    refused_in_words(folder.write("deep.json", open + close), "nested lists");
    for (const std::string& start : {std::string("{\"a\":"), std::string("{\"node\":{\"a\":")}) {
        std::string text;
        for (int i = 0; i < 100000; ++i) text += start;
        text +=
            "1" + std::string(100000 * static_cast<std::size_t>(std::count(start.begin(), start.end(), '{')), '}');
        refused_in_words(folder.write("deep.json", text), "nested dictionaries");
    }
    const std::string scene =
        "<library_visual_scenes><visual_scene>" + xml + end + "</visual_scene></library_visual_scenes>";
    refused_in_words(folder.write("deep.dae", "<COLLADA>" + scene + "</COLLADA>"), "nested nodes");
}

/// By our own readers; assimp runs in a child process (importers/helper, helper_mutation_test.cpp).
TEST(ReadDamaged, RealFilesOfEveryFormat)
{
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    if (!std::filesystem::exists(data / "meshes")) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    const TemporaryFolder folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data / "meshes")) {
        const std::string name = entry.path().filename();
        if (!entry.is_regular_file()) continue;
        std::ifstream stream(entry.path(), std::ios::binary);
        damage(name, {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}, folder);
    }
}

}  // namespace
}  // namespace voussoir::importers
