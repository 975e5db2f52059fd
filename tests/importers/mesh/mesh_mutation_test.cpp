// Mesh files damaged at random with a fixed seed: refused in words or read as sound surfaces, without more memory
// than the file deserves. scripts/fuzz does the same for hours. Our own readers only: assimp does not survive
// damage, which is what the helper is for (helper_mutation_test.cpp).
#include <gtest/gtest.h>

#include <cstdio>

#include "importers/mesh/read_mesh.h"
#include "libdda/errors.h"
#include "tests/damage.h"
#include "tests/fuzz/accepted_mesh.h"
#include "tests/limited_requests.h"
#include "tests/temporary_folder.h"

namespace voussoir::importers
{

namespace
{

constexpr std::size_t max_memory = 20'000'000;  // bytes at once; the files have less than 2 kB

bool accepts(const std::filesystem::path& file, const std::string& content)
{
    std::ofstream(file, std::ios::binary) << content;
    std::string wrong;
    try {
        const LimitedRequests limit(max_memory);
        check_accepted(mesh::read_mesh(file, {mesh::StonesBy::detect, mesh::MeshReader::own}));
        return true;
    } catch (const InputError& error) {
        if (error.faults.empty() || error.faults.front().found.empty()) wrong = "refused without a word";
    } catch (const std::exception& error) {
        wrong = error.what();
    }
    EXPECT_EQ(wrong, "") << file.filename();
    return false;
}

}  // namespace

TEST(DamagedMeshes, AreRefusedInWordsOrReadAsSoundSurfaces)
{
    const TemporaryFolder folder;
    Damage damage(1914);
    std::size_t accepted = 0, tried = 0;
    for (const std::filesystem::path& seed : files_in(VOUSSOIR_MESH_SEEDS)) {
        const std::string sound = content_of(seed);
        const std::filesystem::path file = folder.path() / seed.filename();
        EXPECT_TRUE(accepts(file, sound)) << "the seed is worth damaging";
        for (int i = 0; i < 200 && !HasFailure(); ++i, ++tried) accepted += accepts(file, damage(sound));
    }
    std::printf("%zu damaged meshes, %zu of them still meshes\n", tried, accepted);
    EXPECT_GE(tried, 3000U);
    EXPECT_GT(accepted, tried / 50);
    EXPECT_LT(accepted, tried);
}

TEST(DamagedMeshes, HeadersThatAnnounceThousandsOfMillions)
{
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& name, const std::string& content) {
        return !accepts(folder.path() / name, content);
    };
    EXPECT_TRUE(refused("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n"));
    EXPECT_TRUE(refused("a.ply",
                        "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"
                        "property float y\nproperty float z\nend_header\n0 0 0\n"));
    EXPECT_TRUE(refused("b.ply",
                        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty list int double x\n"
                        "end_header\n\xff\xff\xff\x7f"));
    EXPECT_TRUE(refused("c.ply", "ply\nformat ascii 1.0\nelement nothing 4000000000\nend_header\n"));
    EXPECT_TRUE(refused("a.stl", std::string(80, ' ') + "\xff\xff\xff\xff"));
    EXPECT_TRUE(refused("a.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":)"
                                  R"([{"attributes":{"POSITION":0}}]}],"accessors":[{"componentType":5126,)"
                                  R"("count":4000000000,"type":"VEC3"}]})"));
}

// Twenty objects, each twice the one before: a million stones in two kilobytes.
TEST(DamagedMeshes, PartsOfPartsOfParts)
{
    const TemporaryFolder folder;
    std::string nodes, amf = "<?xml version=\"1.0\"?><amf><object id=\"0\"><mesh><vertices>";
    for (const char* z : {"0", "1", "2"})
        amf += std::string("<vertex><coordinates><x>0</x><y>1</y><z>") + z + "</z></coordinates></vertex>";
    amf += "</vertices><volume><triangle><v1>0</v1><v2>1</v2><v3>2</v3></triangle></volume></mesh></object>";
    for (int i = 1; i <= 40; ++i) {
        const std::string before = std::to_string(i - 1), last = std::to_string(i);
        amf += "<constellation id=\"" + last + "\"><instance objectid=\"" + before + "\"/><instance objectid=\"" +
               before + "\"/></constellation>";
    }
    const std::filesystem::path file = folder.path() / "laughs.amf";
    std::ofstream(file) << amf << "</amf>";
    EXPECT_THROW(mesh::read_mesh(file), InputError);
}

}  // namespace voussoir::importers
