// Every mesh of the collection, from file to certificate, in the helper's child process (VOUSSOIR_DATA).
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "importers/exact/certify.h"
#include "importers/exact/stones_of.h"
#include "importers/helper/geometry.h"
#include "importers/mesh/read_mesh.h"

namespace voussoir::importers
{
namespace
{

using nlohmann::json;

/// Where the certificate differs from expected.json, and why. Everything else must agree.
struct Difference {
    const char* why;
    int closed = -1;    // closed stones, if their number differs
    double volume = 0;  // file units, if it differs
};
const std::map<std::string, Difference> differences{
    {"building/wall-with-opening-and-window.ifc",
     {"expected.json evaluates no solids; the window is a closed one, the wall with its opening is not", 1}},
    {"building/no_indices_3storybuilding.glb",
     {"six boxes in three objects that touch face to face and share edges: they are taken apart", 6, 15580.4524}},
    {"awkward/nearly-collinear.off",
     {"concave faces that are not flat: fans from their first corners cross, the triangles taken here do not", 1,
      269.875587}},
    {"awkward/hourglass_ico.obj", {"two balls that touch in one vertex are two stones", 2}},
};

/// Files that hold no stones to certify: what the refusal says.
const std::map<std::string, std::string> unreadable{
    {"awkward/index0.obj", "index0.obj:9"},
    {"awkward/index901.obj", "index901.obj:11"},
    {"awkward/empty.stl", "no faces"},
    {"awkward/empty.obj", "no faces"},
    {"awkward/notenoughindices.obj", "fewer than three corners"},
    {"awkward/number_formats.obj", "not three finite numbers"},
    {"awkward/issue623.ply", "cloud of points"},
    {"awkward/invalid.off", "invalid.off:6"},
    {"awkward/BoxWithInfinites.glb", "not finite"},
    {"awkward/IndexOutOfRange.gltf", "vertex 255"},
    {"awkward/malformed.obj", "malformed.obj:28"},
    {"awkward/sphere.dxf", "3DSOLID"},
};

double volume_in_file_units(const helper::ImportedMesh& mesh)
{
    double volume = 0;
    for (const helper::Stone& stone : mesh.stones)
        volume += stone.moments.volume / std::pow(mesh.metres_per_unit, 3);
    return volume;
}

void compare(const std::string& file, const helper::ImportedMesh& mesh, const json& known)
{
    const auto other = differences.find(file);
    int closed = 0;
    for (const helper::Stone& stone : mesh.stones) {
        closed += stone.closed;
        EXPECT_EQ(stone.reason.empty(), !stone.parts.empty()) << stone.name;
        EXPECT_GE(stone.volume_error, -2e-5) << stone.name;
        EXPECT_LE(stone.volume_error, 0.01) << stone.name;
        if (stone.parts.empty()) continue;
        const double fitted = stone.moments.volume * (1 + stone.fit_volume_change);
        EXPECT_NEAR(moments_of(stone.parts).volume, fitted * (1 + stone.volume_error), 1e-9 * fitted)
            << stone.name;
    }
    const bool differs = other != differences.end();
    EXPECT_EQ(closed,
              differs && other->second.closed >= 0 ? other->second.closed : known.at("n_closed").get<int>());
    const json volume = known.value("volume", json());
    double expected = volume.is_number() ? std::abs(volume.get<double>()) : 0;
    if (differs && other->second.volume > 0) expected = other->second.volume;
    if (expected > 0) {
        EXPECT_NEAR(volume_in_file_units(mesh), expected, 1e-6 * expected);
    }
    EXPECT_EQ(mesh.accepted, mesh.reason.empty());
}

TEST(AllMeshes, AreCertifiedOrRefusedWithTheReasonWithinTimeAndMemory)
{
    setenv("VOUSSOIR_BIN_DIR", VOUSSOIR_BINARIES, 1);
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    std::ifstream stream(data / "expected.json");
    if (!stream) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    const json known = json::parse(stream).at("meshes");
    helper::GeometryLimits limits;
#if defined(__SANITIZE_ADDRESS__)
    limits.seconds *= 8;
#endif
    int accepted = 0, refused = 0;
    for (const auto& [path, expected] : known.items()) {
        const std::string file = path.substr(std::string("meshes/").size());
        SCOPED_TRACE(file);
        const auto start = std::chrono::steady_clock::now();
        const helper::ImportedMesh mesh = helper::import_geometry({{.file = data / path}}, limits).meshes.at(0);
        EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), limits.seconds);
        ++(mesh.accepted ? accepted : refused);
        // A child that died is a refusal without these words: none of these files kills it.
        EXPECT_EQ(mesh.reason.find("gave no answer"), std::string::npos) << mesh.reason;
        const auto words = unreadable.find(file);
        if (words == unreadable.end()) {
            compare(file, mesh, expected);
        } else {
            EXPECT_NE(mesh.reason.find(words->second), std::string::npos) << mesh.reason;
        }
    }
    EXPECT_GE(accepted + refused, 118);
    EXPECT_GE(accepted, 79);
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    EXPECT_LT(children.ru_maxrss, 2 << 20) << "KiB";
}

TEST(AllMeshes, AVaultInOneHeapOfTrianglesIsTakenApartIntoItsStones)
{
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    const std::filesystem::path file = data / "meshes/masonry/crossvault.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    mesh::PolygonSurface heap{"vault", {}, {}};  // as STL has it: every triangle with corners of its own
    for (const mesh::PolygonSurface& stone : mesh::read_mesh(file).surfaces)
        for (const std::vector<int>& face : stone.faces)
            for (std::size_t i = 1; i + 1 < face.size(); ++i) {
                const int first = static_cast<int>(heap.vertices.size());
                for (const int v : {face[0], face[i], face[i + 1]}) heap.vertices.push_back(stone.vertices[v]);
                heap.faces.push_back({first, first + 1, first + 2});
            }
    const exact::SeparatedStones separated = exact::separate_stones(heap, 1e-6);
    ASSERT_EQ(separated.stones.size(), 184U);
    double volume = 0;
    for (const mesh::PolygonSurface& stone : separated.stones) {
        const exact::Certificate certificate = exact::certify(stone);
        EXPECT_EQ(certificate.reason, "") << stone.name;
        volume += certificate.moments.volume;
    }
    EXPECT_NEAR(volume, 3524253.1, 0.1);
}

TEST(AllMeshes, RubbleStoneOneHasItsVolumeWhateverTheOrigin)
{
    setenv("VOUSSOIR_BIN_DIR", VOUSSOIR_BINARIES, 1);
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    const std::filesystem::path file = data / "meshes/masonry_stones/stone_1.ply";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    const helper::ImportedMesh mesh = helper::import_geometry({{.file = file}}, {}).meshes.at(0);
    ASSERT_TRUE(mesh.accepted) << mesh.reason;
    EXPECT_NEAR(mesh.stones[0].moments.volume, 0.005865, 5e-7);
}

}  // namespace
}  // namespace voussoir::importers
