// A wall of 10,000 blocks: generated, certified, and its contact graph built.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "importers/assembly/assembly.h"
#include "importers/helper/geometry.h"
#include "importers/mesh/write_obj.h"
#include "importers/patterns/wall.h"
#include "tests/importers/shapes.h"

namespace voussoir::importers
{
namespace
{

TEST(LargeWall, IsGeneratedCertifiedAndItsContactGraphBuiltWithinAMinute)
{
    setenv("VOUSSOIR_BIN_DIR", VOUSSOIR_BINARIES, 1);
    const auto start = std::chrono::steady_clock::now();
    const int courses = 100, whole = 100;  // even courses: 100 blocks; odd ones: two halves and 99
    patterns::Wall pattern;
    pattern.length = 0.5 * whole;
    pattern.height = 0.2 * courses;
    pattern.thickness = 0.4;
    pattern.block_length = 0.5;
    pattern.block_height = 0.2;
    std::vector<mesh::PolygonSurface> surfaces;
    for (const patterns::MasonryBlock& block : patterns::wall(pattern))
        surfaces.push_back(patterns::to_surface(block));
    const int blocks = courses / 2 * whole + courses / 2 * (whole + 1);
    ASSERT_EQ(static_cast<int>(surfaces.size()), blocks);
    const TemporaryFolder folder;
    const helper::Geometry geometry =
        helper::import_geometry({{.file = folder.write("wall.obj", mesh::to_obj(surfaces, {}))}}, {});
    const helper::ImportedMesh& mesh = geometry.meshes.at(0);
    ASSERT_TRUE(mesh.accepted) << mesh.reason;
    EXPECT_TRUE(geometry.overlaps.empty());
    std::vector<assembly::AssemblyStone> stones;
    for (const helper::Stone& stone : mesh.stones)
        stones.push_back({stone.name, stone.parts, stone.moments.volume, stone.volume_error, false});
    const assembly::Assembly assembly = assembly::examine_assembly(stones, {}, {});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(took.count(), 60);

    double bed = 0, head = 0;
    for (const assembly::StoneContact& contact : assembly.contacts)
        (std::abs(contact.normal.z()) > 0.5 ? bed : head) += contact.area;
    EXPECT_NEAR(bed, (courses - 1) * pattern.length * pattern.thickness, 1e-6 * bed);
    EXPECT_NEAR(head, (blocks - courses) * pattern.block_height * pattern.thickness, 1e-6 * head);
    const int head_joints = blocks - courses, bed_joints = (courses - 1) * 2 * whole;
    EXPECT_EQ(static_cast<int>(assembly.contacts.size()), head_joints + bed_joints);
    EXPECT_EQ(assembly.components.size(), 1U);
    EXPECT_TRUE(assembly.unsupported.empty() && assembly.gaps.empty());
}

}  // namespace
}  // namespace voussoir::importers
