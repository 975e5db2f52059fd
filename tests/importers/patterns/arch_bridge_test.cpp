#include "importers/patterns/arch_bridge.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "importers/helper/import_meshes.h"
#include "libdda/errors.h"
#include "tests/importers/shapes.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Vector3d;

std::string read(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool has_vertex(const mesh::PolygonSurface& stone, const Vector3d& x)
{
    return std::find(stone.vertices.begin(), stone.vertices.end(), x) != stone.vertices.end();
}

/// Corners of the near side of voussoir i: left intrados, left extrados, right extrados, right intrados.
std::array<Vector3d, 4> corners(const mesh::PolygonSurface& voussoir)
{
    return {voussoir.vertices[0], voussoir.vertices[1], voussoir.vertices[2], voussoir.vertices[3]};
}

TEST(ArchBridge, HasTheSpanRiseAndThicknessThatWereAsked)
{
    patterns::ArchBridge bridge;
    bridge.rise = 1.5;
    bridge.voussoirs = 92;  // even: there is a joint in the crown
    const std::vector<mesh::PolygonSurface> stones = patterns::arch_bridge(bridge);
    ASSERT_EQ(stones.size(), 94U);
    EXPECT_EQ(stones[1].name, "voussoir_01");
    EXPECT_EQ(stones[92].name, "voussoir_92");
    const auto first = corners(stones[1]), middle = corners(stones[46]);
    EXPECT_EQ(first[0].x(), -22.5);
    EXPECT_EQ(first[0].z(), 0);
    EXPECT_NEAR((first[1] - first[0]).norm(), 2, 1e-9);
    EXPECT_EQ(middle[3].x(), 0);
    EXPECT_NEAR(middle[3].z(), 1.5, 1e-9);
    EXPECT_NEAR(middle[2].z() - middle[3].z(), 1.5, 1e-9);
    EXPECT_EQ(first[0].y(), -6);
}

TEST(ArchBridge, HasRadialJointsAtEqualAnglesOnTheCircle)
{
    const patterns::ArchBridge bridge;
    const std::vector<mesh::PolygonSurface> stones = patterns::arch_bridge(bridge);
    const double radius = (22.5 * 22.5 + 5.5 * 5.5) / 11;
    const Vector3d centre(0, -6, 5.5 - radius);
    const double step = 2 * std::asin(22.5 / radius) / 93;
    for (int i = 1; i <= 93; ++i) {
        const auto c = corners(stones[i]);
        const Vector3d left = c[0] - centre, right = c[3] - centre;
        EXPECT_NEAR(left.norm(), radius, 2e-9);
        EXPECT_NEAR(std::acos(left.dot(right) / left.norm() / right.norm()), step, 1e-8);
        EXPECT_NEAR(left.cross(c[1] - c[0]).norm() / left.norm(), 0, 3e-9);
    }
}

TEST(ArchBridge, NeighboursShareTheirJointAndTheMeshIsSymmetricToTheLastBit)
{
    for (const double rise : {1.5, 5.5, 15.}) {
        patterns::ArchBridge bridge;
        bridge.rise = rise;
        const std::vector<mesh::PolygonSurface> stones = patterns::arch_bridge(bridge);
        for (std::size_t i = 0; i + 1 < stones.size(); ++i) {
            int shared = 0;
            for (const Vector3d& x : stones[i].vertices) shared += has_vertex(stones[i + 1], x);
            EXPECT_EQ(shared, 4) << stones[i].name;
        }
        for (std::size_t i = 0; i < stones.size(); ++i)
            for (const Vector3d& x : stones[i].vertices) {
                EXPECT_TRUE(has_vertex(stones[stones.size() - 1 - i], {-x.x(), x.y(), x.z()}));
                EXPECT_TRUE(has_vertex(stones[i], {x.x(), -x.y(), x.z()}));
            }
    }
}

TEST(ArchBridge, NamesEveryParameterThatMakesNoBridge)
{
    patterns::ArchBridge bridge;
    bridge.rise = 30;
    bridge.voussoirs = 1;
    bridge.width = std::nan("");
    bridge.abutment_length = 1;
    try {
        patterns::arch_bridge(bridge);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        EXPECT_EQ(error.faults.size(), 4U) << error.what();
    }
}

class CaseMeshes : public testing::TestWithParam<const char*>
{
};

TEST_P(CaseMeshes, AreCertifiedWithoutRepairOrOverlap)
{
    const helper::Geometry geometry =
        helper::import_meshes({{.file = std::filesystem::path(VOUSSOIR_CASE_MESHES) / GetParam()}});
    const helper::ImportedMesh& mesh = geometry.meshes[0];
    EXPECT_TRUE(mesh.accepted) << mesh.reason;
    EXPECT_TRUE(mesh.repairs.empty());
    EXPECT_TRUE(geometry.overlaps.empty());
    EXPECT_EQ(geometry.origin, Vector3d::Zero());
    ASSERT_EQ(mesh.stones.size(), 95U);
    EXPECT_EQ(mesh.stones.front().name, "abutment_left");
    EXPECT_EQ(mesh.stones[47].name, "voussoir_47");
    EXPECT_EQ(mesh.stones.back().name, "abutment_right");
    for (const helper::Stone& stone : mesh.stones) {
        EXPECT_TRUE(stone.repairs.empty());
        EXPECT_EQ(stone.parts[0].faces.size(), stone.name.starts_with("abutment") ? 7U : 6U) << stone.name;
    }
    EXPECT_NEAR(mesh.stones[47].moments.centroid.x(), 0, 1e-14);
    EXPECT_NEAR(mesh.stones[0].moments.volume, mesh.stones[94].moments.volume, 1e-11);
}

class ShippedMeshes : public testing::TestWithParam<const char*>
{
};

/// The first line of each mesh is the command that made it.
TEST_P(ShippedMeshes, AreMadeAgainByTheCommandTheyName)
{
    const TemporaryFolder folder;
    const std::string committed = read(std::filesystem::path(VOUSSOIR_CASE_MESHES) / GetParam());
    ASSERT_TRUE(committed.starts_with("# voussoir-generate "));
    const std::string command = "cd '" + folder.path().string() + "' && '" + VOUSSOIR_BINARIES + "'/" +
                                committed.substr(2, committed.find('\n') - 2);
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    EXPECT_TRUE(read(folder.path() / GetParam()) == committed) << "not the same, byte for byte";
}

INSTANTIATE_TEST_SUITE_P(Each, CaseMeshes,
                         testing::Values("mosca_bridge.obj", "mosca_bridge_paper.obj",
                                         "mosca_bridge_paper_large.obj"));
INSTANTIATE_TEST_SUITE_P(Each, ShippedMeshes,
                         testing::Values("mosca_bridge.obj", "mosca_bridge_paper.obj",
                                         "mosca_bridge_paper_large.obj", "surveyed_dome.obj"));

}  // namespace
}  // namespace voussoir::importers
