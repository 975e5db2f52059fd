// Real meshes with known volumes, where they are present (VOUSSOIR_DATA).
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "importers/helper/geometry.h"

namespace voussoir::importers
{
namespace
{

class RealMeshes : public testing::TestWithParam<const char*>
{
 protected:
    void SetUp() override
    {
        setenv("VOUSSOIR_BIN_DIR", VOUSSOIR_BINARIES, 1);
        const char* folder = std::getenv("VOUSSOIR_DATA");
        data_ = folder != nullptr ? folder : VOUSSOIR_DEFAULT_DATA;
        std::ifstream expected(data_ / "expected.json");
        if (!expected) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
        known_ = nlohmann::json::parse(expected).at("meshes").at(GetParam());
    }
    helper::ImportedMesh import() const
    {
        return helper::import_geometry({{.file = data_ / GetParam()}}, {}).meshes.front();
    }

    std::filesystem::path data_;
    nlohmann::json known_;
};

using ConvexMeshes = RealMeshes;
using AwkwardMeshes = RealMeshes;

TEST_P(ConvexMeshes, AreAcceptedWithTheKnownNamesAndVolumes)
{
    const helper::ImportedMesh mesh = import();
    EXPECT_TRUE(mesh.accepted) << mesh.reason;
    const auto& objects = known_.at("objects");
    ASSERT_EQ(mesh.stones.size(), objects.size());
    double sum = 0;
    for (std::size_t i = 0; i < mesh.stones.size(); ++i) {
        const double volume = std::abs(objects[i].at("volume").get<double>());  // signed as stored in the file
        EXPECT_NEAR(mesh.stones[i].moments.volume, volume, 2e-6 * volume);
        sum += mesh.stones[i].moments.volume;
    }
    EXPECT_NEAR(sum, std::abs(known_.at("volume").get<double>()), 2e-6 * sum);
}

INSTANTIATE_TEST_SUITE_P(Each, ConvexMeshes,
                         testing::Values("meshes/masonry/wall.obj", "meshes/awkward/box.obj",
                                         "meshes/awkward/box_UTF16BE.obj", "meshes/awkward/two_objects.obj",
                                         "meshes/awkward/joined_tetrahedra.obj",
                                         "meshes/awkward/negative_indices.obj", "meshes/awkward/nancolor.obj",
                                         "meshes/awkward/unit_cube.STL", "meshes/awkward/tet.ply",
                                         "meshes/awkward/cube_binary.ply", "meshes/awkward/chamfer-cube.off",
                                         "meshes/awkward/whitespace.off", "meshes/awkward/comments.off",
                                         "meshes/awkward/translated-cube.off", "meshes/awkward/cube_quad.off",
                                         "meshes/awkward/beam.off"));

TEST_P(AwkwardMeshes, AreRefusedWithAReason)
{
    const helper::ImportedMesh mesh = import();
    EXPECT_FALSE(mesh.accepted);
    EXPECT_FALSE(mesh.reason.empty());
    EXPECT_EQ(mesh.reason.find("the geometry helper gave no answer"), std::string::npos) << mesh.reason;
}

INSTANTIATE_TEST_SUITE_P(Each, AwkwardMeshes,
                         testing::Values("meshes/awkward/empty.obj", "meshes/awkward/malformed.obj",
                                         "meshes/awkward/index901.obj", "meshes/awkward/index0.obj",
                                         "meshes/awkward/number_formats.obj", "meshes/awkward/open_cube.off",
                                         "meshes/awkward/moebius.obj", "meshes/awkward/soup.stl",
                                         "meshes/awkward/empty.stl", "meshes/awkward/invalid.off",
                                         "meshes/awkward/issue623.ply", "meshes/awkward/nonmanifold.obj",
                                         "meshes/awkward/tetra_intersected_by_triangle.off"));

}  // namespace
}  // namespace voussoir::importers
