// OBJ, STL, PLY, OFF: every digit, every dialect, the place of every fault.
#include <gtest/gtest.h>

#include "tests/importers/mesh/read_shapes.h"

namespace voussoir::importers
{
namespace
{

class FarAway : public testing::Test
{
 protected:
    FarAway()
    {
        cube_ = triangulated(unit_cube());
        for (Eigen::Vector3d& x : cube_.vertices)
            x = 1.7 / 3 * x + Eigen::Vector3d(5e5 + 1. / 7, 4.6e6 + 2. / 11, 800 + 1. / 3);
    }
    /// Corner by corner, bit by bit.
    void expect_same(const mesh::MeshFile& read) const
    {
        ASSERT_EQ(read.surfaces.size(), 1U);
        EXPECT_EQ(read.rounding, 0);
        ASSERT_EQ(read.surfaces[0].faces.size(), cube_.faces.size());
        for (std::size_t f = 0; f < cube_.faces.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(read.surfaces[0].vertices[read.surfaces[0].faces[f][i]],
                          cube_.vertices[cube_.faces[f][i]]);
    }
    mesh::PolygonSurface cube_;
    TemporaryFolder folder_;
};

TEST_F(FarAway, ObjKeepsEveryBit)
{
    expect_same(mesh::read_mesh(folder_.write("far.obj", mesh::to_obj({cube_}, {}))));
}

TEST_F(FarAway, OffKeepsEveryBit)
{
    expect_same(mesh::read_mesh(folder_.write("far.off", to_off(cube_))));
}

TEST_F(FarAway, AsciiStlKeepsEveryBit)
{
    expect_same(mesh::read_mesh(folder_.write("far.stl", to_ascii_stl(cube_, "far"))));
}

TEST_F(FarAway, PlyKeepsEveryBitInAllItsEncodings)
{
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
        expect_same(mesh::read_mesh(folder_.write("far.ply", to_ply(cube_, format))));
}

TEST(ReadStl, BinaryWhoseHeaderBeginsWithSolidIsBinary)
{
    const TemporaryFolder folder;
    const mesh::PolygonSurface cube = triangulated(unit_cube());
    const mesh::MeshFile read =
        mesh::read_mesh(folder.write("liar.stl", to_binary_stl(cube, "solid facet normal liar")));
    ASSERT_EQ(read.surfaces.size(), 1U);
    EXPECT_EQ(read.surfaces[0].name, "liar");
    EXPECT_EQ(read.surfaces[0].faces.size(), 12U);
    EXPECT_EQ(refusal(folder.write("long.stl", to_binary_stl(cube, "solid") + "tail")), "");
    const std::string cut = to_binary_stl(cube, "solid").substr(0, 400);
    EXPECT_NE(refusal(folder.write("cut.stl", cut)).find("announces 12 facets"), std::string::npos);
}

TEST(ReadStl, EverySolidIsAStone)
{
    const TemporaryFolder folder;
    const mesh::PolygonSurface cube = triangulated(unit_cube());
    const mesh::MeshFile read = mesh::read_mesh(folder.write(
        "two.stl", to_ascii_stl(cube, "left stone") + to_ascii_stl(cube, "right stone") + to_ascii_stl(cube, "")));
    ASSERT_EQ(read.surfaces.size(), 3U);
    EXPECT_EQ(read.surfaces[0].name, "left stone");
    EXPECT_EQ(read.surfaces[1].name, "right stone");
    EXPECT_EQ(read.surfaces[2].name, "two");
    const mesh::MeshFile whole = mesh::read_mesh(folder.path() / "two.stl", {mesh::StonesBy::file});
    ASSERT_EQ(whole.surfaces.size(), 1U);
    EXPECT_EQ(whole.surfaces[0].faces.size(), 36U);
}

TEST(ReadStl, FaultsNameTheirLine)
{
    const TemporaryFolder folder;
    const std::string head = "solid a\n facet normal nan nan nan\n  outer loop\n";
    EXPECT_NE(refusal(folder.write("a.stl", head + "vertex 0 0 inf\n")).find("a.stl:4"), std::string::npos);
    EXPECT_NE(refusal(folder.write("b.stl", head + "vertex 0 0 1\nendloop\n")).find("1 corners"),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("c.stl", head + "vertex 0 0 1\n")).find("ends within"), std::string::npos);
}

TEST(ReadPly, TakesTriangleStripsAndPassesOverOtherElements)
{
    const TemporaryFolder folder;
    const mesh::MeshFile read = mesh::read_mesh(folder.write(
        "strip.ply",
        "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty double x\nproperty list uchar "
        "int "
        "tags\nproperty double y\nproperty double z\nelement tristrips 1\nproperty list int int vertex_indices\n"
        "element edge 1\nproperty int a\nend_header\n0 2 7 7 0 0\n1 0 0 0\n0 0 1 0\n1 1 9 1 0\n8 0 1 2 3 -1 0 2 "
        "1\n5\n"));
    ASSERT_EQ(read.surfaces.size(), 1U);
    EXPECT_EQ(read.surfaces[0].vertices[3], Eigen::Vector3d(1, 1, 0));
    EXPECT_EQ(read.surfaces[0].faces, (std::vector<std::vector<int>>{{0, 1, 2}, {2, 1, 3}, {0, 2, 1}}));
}

TEST(ReadPly, RefusesCountsThatTheFileCannotHold)
{
    const TemporaryFolder folder;
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        const std::string text = std::string("ply\nformat ") + format +
                                 " 1.0\nelement vertex 350000000000\nproperty float x\nproperty float y\n"
                                 "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                                 "end_header\n0 0 0\n";
        EXPECT_NE(refusal(folder.write("huge.ply", text)).find("announces 350000000000"), std::string::npos);
    }
    std::string list = to_ply(triangulated(unit_cube()), "binary_little_endian");
    list.replace(list.find("list uchar"), 10, "list uint ");  // the first face now counts in billions
    EXPECT_NE(refusal(folder.write("list.ply", list)).find("file ends before"), std::string::npos);
}

TEST(ReadPly, FaultsNameTheirLine)
{
    const TemporaryFolder folder;
    const std::string good = to_ply(triangulated(unit_cube()), "ascii");
    std::string bad = good;
    bad.replace(bad.find("3 0"), 3, "3 x");
    EXPECT_NE(refusal(folder.write("bad.ply", bad)).find("bad.ply:18: \"x\" is not a number"), std::string::npos)
        << refusal(folder.path() / "bad.ply");
    EXPECT_NE(refusal(folder.write("odd.ply", "ply\nformat ascii 1.0\nelement vertex many\nend_header\n"))
                  .find("odd.ply:3"),
              std::string::npos);
}

TEST(ReadOff, TakesEveryHeader)
{
    const TemporaryFolder folder;
    const std::string faces = "3 0 1 2\n3 0 1 3 255 0 0\n3 0 2 3 0.5 0 0 1\n3 1 2 3\n";
    for (const std::string& text :
         {"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces, "OFF 4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces,
          "# first\nOFF # keyword\n\n4 4\n# counts without edges\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces,
          "4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces,
          "COFF\r\n4 4 0\r\n0 0 0 255 0 0 255\r\n1 0 0 1 1 1 1\r\n0 1 0 0 0 0 1\r\n0 0 1 0 0 0 1\r\n" + faces,
          "NOFF\n4 4 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n" + faces,
          "STCNOFF\n4 4 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0\n0 1 0\n0 0 1\n" + faces}) {
        const mesh::MeshFile read = mesh::read_mesh(folder.write("t.off", text));
        ASSERT_EQ(read.surfaces.size(), 1U) << text;
        EXPECT_EQ(read.surfaces[0].vertices[1], Eigen::Vector3d(1, 0, 0)) << text;
        EXPECT_EQ(read.surfaces[0].faces.size(), 4U) << text;
    }
    EXPECT_NE(refusal(folder.write("four.off", "4OFF\n1 1 0\n0 0 0 1\n")).find("three dimensions"),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("huge.off", "OFF\n350000000000 1 0\n0 0 0\n")).find("announces 350000000000"),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("cut.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n")).find("ends after 2 vertices"),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")).find("index.off:6"),
              std::string::npos);
}

TEST(ReadObj, IsReadByObjectOrGroupAsAsked)
{
    const TemporaryFolder folder;
    const auto file = folder.write("levels.obj",
                                   "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no left\ng low\nf 1 2 3\ng high\nf 1 2 4\n"
                                   "o right\ng low\nf -4 -3 \\\n -1\nl 1 2\n");
    EXPECT_EQ(mesh::read_mesh(file).surfaces.size(), 2U);
    EXPECT_EQ(mesh::read_mesh(file, {mesh::StonesBy::object}).surfaces[1].name, "right");
    const mesh::MeshFile groups = mesh::read_mesh(file, {mesh::StonesBy::group});
    ASSERT_EQ(groups.surfaces.size(), 2U);
    EXPECT_EQ(groups.surfaces[0].name, "low");
    EXPECT_EQ(groups.surfaces[0].faces.size(), 2U);
    EXPECT_EQ(mesh::read_mesh(file, {mesh::StonesBy::file}).surfaces.size(), 1U);
    ASSERT_EQ(groups.repairs.size(), 1U);
    EXPECT_NE(groups.repairs[0].find("1 lines"), std::string::npos);
}

TEST(ReadMesh, JudgesByContentNotByName)
{
    const TemporaryFolder folder;
    const mesh::PolygonSurface cube = triangulated(unit_cube());
    for (const auto& [name, content] :
         std::vector<std::pair<std::string, std::string>>{{"a.ply", to_ascii_stl(cube, "a")},
                                                          {"b.obj", to_binary_stl(cube, "b")},
                                                          {"c.stl", mesh::to_obj({cube}, {"a comment"})},
                                                          {"d.txt", to_ply(cube, "binary_big_endian")},
                                                          {"e", to_off(cube)}}) {
        const mesh::MeshFile read = mesh::read_mesh(folder.write(name, content));
        EXPECT_EQ(read.surfaces.at(0).faces.size(), 12U) << name;
        EXPECT_EQ(read.repairs.empty(), name[0] > 'c') << name;
    }
}

TEST(ReadMesh, ReadsUtf16WithAndWithoutAMark)
{
    const TemporaryFolder folder;
    mesh::PolygonSurface cube = unit_cube();
    cube.name = "clé 日本 😀";
    const std::string text = mesh::to_obj({cube}, {});
    std::u16string wide = u"# a comment of plain characters at the beginning\no clé 日本 😀\n";
    for (const char c : text.substr(text.find("\nv ") + 1)) wide.push_back(static_cast<unsigned char>(c));
    for (const bool mark : {true, false})
        for (const bool big : {true, false}) {
            std::string bytes = mark ? (big ? "\xFE\xFF" : "\xFF\xFE") : "";
            for (const char16_t unit : wide) {
                const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
                bytes.append({big ? high : low, big ? low : high});
            }
            const mesh::MeshFile read = mesh::read_mesh(folder.write("wide.obj", bytes));
            ASSERT_EQ(read.surfaces.size(), 1U);
            EXPECT_EQ(read.surfaces[0].name, cube.name);
            EXPECT_EQ(read.surfaces[0].faces.size(), 6U);
            EXPECT_EQ(read.repairs.size(), 1U);
        }
}

TEST(ReadMesh, NamesThatAreNotUtf8AreTakenForLatin1)
{
    const TemporaryFolder folder;
    const mesh::MeshFile read =
        mesh::read_mesh(folder.write("l.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\no cl\xE9\nf 1 2 3\n"));
    EXPECT_EQ(read.surfaces[0].name, "clé");
    EXPECT_NE(refusal(folder.write("m.obj", "v 0 0 0\nf 1 2 \xE9\n")).find("é"), std::string::npos);
}

TEST(ReadMesh, RefusesCompressedFilesByTheirContent)
{
    const TemporaryFolder folder;
    EXPECT_NE(refusal(folder.write("a.obj", "\x1F\x8B\x08 and more")).find("gzip"), std::string::npos);
    EXPECT_NE(refusal(folder.write("a.bin", std::string(100, '\x01'))).find("not a mesh file"), std::string::npos);
}

}  // namespace
}  // namespace voussoir::importers
