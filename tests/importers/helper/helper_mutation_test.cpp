// What the program makes of a helper that dies or lies: the files it reads are not trusted, so neither is its
// answer.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "importers/helper/geometry.h"
#include "importers/helper/wire.h"
#include "libdda/errors.h"
#include "tests/damage.h"
#include "tests/fuzz/accepted_geometry.h"
#include "tests/temporary_folder.h"

namespace voussoir::importers
{

namespace fs = std::filesystem;

TEST(DamagedAnswers, AreNotBelievedOrHold)
{
    Damage damage(1755);
    std::size_t believed = 0, tried = 0;
    for (const fs::path& seed : files_in(fs::path(VOUSSOIR_MESH_SEEDS).parent_path() / "answer")) {
        const std::string sound = content_of(seed);
        EXPECT_NO_THROW(check_accepted(helper::geometry_from_json(sound))) << seed;
        for (int i = 0; i < 2000; ++i, ++tried) {
            helper::Geometry geometry;
            try {
                geometry = helper::geometry_from_json(damage(sound));
            } catch (const std::exception&) {
                continue;
            }
            ++believed;
            EXPECT_NO_THROW(check_accepted(geometry));
        }
    }
    std::printf("%zu damaged answers, %zu of them believed\n", tried, believed);
    EXPECT_GT(believed, 0U);
    EXPECT_LT(believed, tried);
}

TEST(DamagedRequests, ThatNameNoReader)
{
    helper::MeshRequest wanted;
    wanted.file = "a.obj";
    wanted.reader = mesh::MeshReader::assimp;
    const std::string sound = helper::to_json(helper::HelperRequest{{wanted}, {}});
    EXPECT_EQ(helper::request_from_json(sound).meshes.at(0).reader, mesh::MeshReader::assimp);
    const std::size_t place = sound.find("\"assimp\"");
    ASSERT_NE(place, std::string::npos);
    for (const char* bad : {"\"asimp\"", "\"\"", "2", "-1", "true", "null"}) {
        std::string request = sound;
        EXPECT_THROW(helper::request_from_json(request.replace(place, 8, bad)), std::exception) << bad;
    }
}

// Pictures draw the surfaces of refused stones by these numbers.
TEST(DamagedAnswers, CornersThatAreNotThere)
{
    const std::string sound = content_of(fs::path(VOUSSOIR_MESH_SEEDS).parent_path() / "answer/two_stones.json");
    // Of the surface of the refused stone, and of the polyhedron of the other; json takes any number for an int.
    for (const std::string good : {"\"faces\":[[0,1,2],[0,2,3],[2,1,3]]", "\"faces\":[[0,1,2],[0,2,3],[1,3,2]"}) {
        const std::size_t place = sound.find(good), corner = place + std::string("\"faces\":[[0,1,").size();
        ASSERT_NE(place, std::string::npos);
        for (const char* bad : {"9", "-1", "2.5", "true", "6e63", "4294967298", "18446744073709551615"}) {
            std::string answer = sound;
            EXPECT_THROW(helper::geometry_from_json(answer.replace(corner, 1, bad)), InputError) << bad;
        }
    }
}

/// The program itself must live whatever happens to the helper, and say something of every file.
TEST(DamagedMeshes, LeaveTheProgramAlive)
{
    setenv("VOUSSOIR_BIN_DIR", VOUSSOIR_BINARIES, 1);
    const TemporaryFolder folder;
    std::vector<fs::path> seeds = files_in(VOUSSOIR_MESH_SEEDS);
    const std::vector<fs::path> of_assimp = files_in(fs::path(VOUSSOIR_MESH_SEEDS).parent_path() / "assimp");
    ASSERT_GE(of_assimp.size(), 7U);
    seeds.insert(seeds.end(), of_assimp.begin(), of_assimp.end());
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const fs::path ifc = fs::path(variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA) /
                         "meshes/building/wall-with-opening-and-window.ifc";
    if (fs::exists(ifc)) seeds.insert(seeds.end(), 4, ifc);
    Damage damage(1980);
    int accepted = 0, refused = 0;
    for (int round = 0; round < 3; ++round) {
        std::vector<helper::MeshRequest> requests;
        for (const fs::path& seed : seeds) {
            const fs::path file = folder.path() / (std::to_string(requests.size()) + seed.extension().string());
            std::ofstream(file, std::ios::binary) << damage(content_of(seed));
            requests.push_back({.file = file});
        }
        const helper::Geometry geometry =
            helper::import_geometry(requests, {.seconds = 5, .bytes = std::size_t{1} << 30});
        ASSERT_EQ(geometry.meshes.size(), requests.size());
        for (const helper::ImportedMesh& mesh : geometry.meshes) {
            ++(mesh.accepted ? accepted : refused);
            EXPECT_TRUE(mesh.accepted || !mesh.reason.empty()) << mesh.file;
        }
        check_accepted(geometry);
    }
    std::printf("%d damaged meshes accepted, %d refused with a reason\n", accepted, refused);
    EXPECT_GT(refused, 0);
}

}  // namespace voussoir::importers
