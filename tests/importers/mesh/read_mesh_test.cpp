#include "importers/mesh/read_mesh.h"

#include <gtest/gtest.h>

#include "tests/importers/mesh/read_shapes.h"

namespace voussoir::importers
{
namespace
{

TEST(ReadMesh, KeepsEveryDigitOfAnObjFileAtNationalGridCoordinates)
{
    const TemporaryFolder folder;
    mesh::PolygonSurface cube = unit_cube();
    for (Eigen::Vector3d& x : cube.vertices) x += Eigen::Vector3d(500000.123456789, 4600000.987654321, 1. / 3);
    const mesh::MeshFile read = mesh::read_mesh(folder.write("far.obj", mesh::to_obj({cube}, {})));
    ASSERT_EQ(read.surfaces.size(), 1U);
    EXPECT_EQ(read.rounding, 0);
    ASSERT_EQ(read.surfaces[0].faces.size(), cube.faces.size());
    for (std::size_t f = 0; f < cube.faces.size(); ++f)
        for (std::size_t i = 0; i < cube.faces[f].size(); ++i)
            EXPECT_EQ(read.surfaces[0].vertices[read.surfaces[0].faces[f][i]], cube.vertices[cube.faces[f][i]]);
}

TEST(ReadMesh, KeepsObjectNamesWithSpacesAndRenamesEqualOnes)
{
    const TemporaryFolder folder;
    std::vector<mesh::PolygonSurface> cubes(4, unit_cube());
    cubes[0].name = "Mesh 0";
    cubes[1].name = "Mesh 1";
    cubes[2].name = "Mesh 1";
    cubes[3].name = "clé de voûte";
    const mesh::MeshFile read = mesh::read_mesh(folder.write("names.obj", mesh::to_obj(cubes, {})));
    ASSERT_EQ(read.surfaces.size(), 4U);
    EXPECT_EQ(read.surfaces[0].name, "Mesh 0");
    EXPECT_EQ(read.surfaces[1].name, "Mesh 1");
    EXPECT_EQ(read.surfaces[2].name, "Mesh 1 (2)");
    EXPECT_EQ(read.surfaces[3].name, "clé de voûte");
    EXPECT_EQ(read.repairs.size(), 1U);
}

TEST(ReadMesh, TakesGroupsForStonesWhenThereAreNoObjects)
{
    const TemporaryFolder folder;
    const std::string text =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng a\nf 1 2 3\ng b\nf 1 2 4\ng a\nusemtl red\nf 2 3 4\n";
    const mesh::MeshFile read = mesh::read_mesh(folder.write("groups.obj", text));
    ASSERT_EQ(read.surfaces.size(), 2U);
    EXPECT_EQ(read.surfaces[0].faces.size(), 2U) << "a group that comes back is the same stone";
    EXPECT_EQ(read.surfaces[1].name, "b");
}

TEST(ReadMesh, ReadsContinuedLinesTexturesAndRelativeIndices)
{
    const TemporaryFolder folder;
    const std::string text =
        "\xEF\xBB\xBFv 0 0 0\r\nv +1 0 0 # a corner\r\nv 0 1e0 \\\r\n 0\r\nv 0 0 1\r\nvt 0 0\r\nf -4/1 2/1 "
        "-2/1\r\nf 1// 2// 4//\r\n";
    const mesh::MeshFile read = mesh::read_mesh(folder.write("odd.obj", text));
    ASSERT_EQ(read.surfaces.size(), 1U);
    EXPECT_EQ(read.surfaces[0].name, "odd");
    ASSERT_EQ(read.surfaces[0].faces.size(), 2U);
    EXPECT_EQ(read.surfaces[0].vertices[read.surfaces[0].faces[0][2]], Eigen::Vector3d(0, 1, 0));
}

TEST(ReadMesh, RefusesWhatIsNoMeshWithASentence)
{
    const TemporaryFolder folder;
    std::string noise;
    for (unsigned i = 0, x = 12345; i < 20000; ++i)
        noise.push_back(static_cast<char>((x = x * 1664525U + 1013904223U) >> 24));
    EXPECT_NE(refusal(folder.path() / "none.obj").find("there is no such file"), std::string::npos);
    EXPECT_NE(refusal(folder.path()).find("this is not a file"), std::string::npos);
    EXPECT_NE(refusal(folder.write("empty.obj", "")).find("the file is empty"), std::string::npos);
    EXPECT_NE(refusal(folder.write("points.obj", "v 0 0 0\nv 1 0 0\n")).find("no faces"), std::string::npos);
    EXPECT_NE(refusal(folder.write("a.step", "ISO-10303-21;")).find("STEP files are not read"), std::string::npos);
    for (const char* name : {"noise.obj", "noise.stl", "noise.ply", "noise.off"})
        EXPECT_NE(refusal(folder.write(name, noise)), "") << name;
}

TEST(ReadMesh, ListsAllFaultsOfAnObjFileWithTheirLines)
{
    const TemporaryFolder folder;
    const auto file =
        folder.write("bad.obj", "v 0 0 0\nv 1 nan 0\nv 0 1\nv 0 0 1\nf 1 2\nf 1 2 0\nf 1 2 9\nf 1 2 -7\n");
    try {
        mesh::read_mesh(file);
        FAIL() << "accepted";
    } catch (const InputError& error) {
        ASSERT_EQ(error.faults.size(), 6U) << error.what();
        for (const char* line : {":2", ":3", ":5", ":6", ":7", ":8"})
            EXPECT_NE(std::string(error.what()).find(file.string() + line), std::string::npos) << line;
    }
}

}  // namespace
}  // namespace voussoir::importers
