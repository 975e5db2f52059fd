// What is done around assimp: names, units and places that it loses, files that it may open. Sound files only: it
// is not for this process to read others by it.
#include <gtest/gtest.h>

#include "tests/importers/mesh/assimp_files.h"

namespace voussoir::importers
{
namespace
{

TEST(ReadAssimp, OpensFilesBesideTheFileAndNoOthers)
{
    const TemporaryFolder folder;
    std::string points;
    for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) points += bytes_of(x);
    folder.write("points.bin", points);
    std::filesystem::create_directory(folder.path() / "inner");
    const auto gltf = [&](const std::string& name, const std::string& uri) {
        return folder.write(
            name, R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
                  R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":)"
                  R"([{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":)"
                  R"([{"buffer":0,"byteLength":36}],"buffers":[{"uri":")" +
                      uri + R"(","byteLength":36}]})");
    };
    const mesh::ReadOptions by_assimp{mesh::StonesBy::detect, mesh::MeshReader::assimp};
    EXPECT_EQ(mesh::read_mesh(gltf("beside.gltf", "points.bin"), by_assimp).surfaces.at(0).vertices.size(), 3U);
    EXPECT_THROW(mesh::read_mesh(gltf("inner/up.gltf", "../points.bin"), by_assimp), InputError);
    EXPECT_THROW(mesh::read_mesh(gltf("inner/far.gltf", (folder.path() / "points.bin").string()), by_assimp),
                 InputError);
}

TEST(Read3ds, ReadsEveryObjectByItsNameWhereItsCoordinatesAre)
{
    const TemporaryFolder folder;
    PlacedSurface left{unit_cube()}, right{unit_cube()};
    left.surface.name = "left";
    right.surface.name = "right";
    std::string file = to_3ds({left, right});
    const mesh::MeshFile read = mesh::read_mesh(folder.write("two.3ds", file));
    ASSERT_EQ(read.surfaces.size(), 2U);
    EXPECT_EQ(read.surfaces[1].name, "right");
    EXPECT_EQ(volume_of(read.surfaces[1]), 1);
    EXPECT_EQ(read.rounding, 0) << "the file itself holds 32-bit numbers";
    // Key frames that put the object "left" 5 higher: where it moves to is not where it stands.
    const std::string position =
        chunk_3ds(0xB020, std::string(10, '\0') + bytes_of(std::uint32_t{1}) + std::string(6, '\0') +
                              bytes_of(0.F) + bytes_of(0.F) + bytes_of(5.F));
    const std::string node = chunk_3ds(0xB010, std::string("left\0", 5) + std::string(4, '\0') + "\xFF\xFF");
    file += chunk_3ds(0xB000, chunk_3ds(0xB002, node + position));
    file.replace(2, 4, bytes_of(static_cast<std::uint32_t>(file.size())));
    const mesh::MeshFile moving = mesh::read_mesh(folder.write("moving.3ds", file));
    ASSERT_EQ(moving.surfaces.size(), 2U);
    EXPECT_EQ(moving.surfaces[0].name, "left");
    EXPECT_EQ(lowest_of(moving.surfaces[0]), Eigen::Vector3d(0, 0, 0));
}

TEST(ReadAmf, ReadsUnitsNamesAndConstellations)
{
    const TemporaryFolder folder;
    const std::string text =
        "<?xml version=\"1.0\"?>\n<amf unit=\"inch\"><object id=\"0\"><metadata type=\"name\">clé</metadata><mesh>"
        "<vertices><vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates></vertex><vertex><coordinates><x>1"
        "</x><y>0</y><z>0</z></coordinates></vertex><vertex><coordinates><x>0</x><y>1</y><z>0</z></coordinates>"
        "</vertex><vertex><coordinates><x>0</x><y>0</y><z>6</z></coordinates></vertex></vertices><volume>"
        "<triangle><v1>0</v1><v2>2</v2><v3>1</v3></triangle><triangle><v1>0</v1><v2>1</v2><v3>3"
        "</v3></triangle><triangle><v1>1</v1><v2>2</v2><v3>3</v3></triangle>"
        "<triangle><v1>0</v1><v2>3</v2><v3>2</v3></triangle></volume></mesh></object><constellation id=\"1\">"
        "<instance objectid=\"0\"><deltax>5</deltax></instance><instance objectid=\"0\"/>"
        "</constellation></amf>";
    for (const auto& file :
         {folder.write("plain.amf", text), folder.write("packed.amf", to_zip({{"a.amf", text}}))}) {
        const mesh::MeshFile read = mesh::read_mesh(file);
        ASSERT_EQ(read.surfaces.size(), 2U);
        EXPECT_EQ(read.surfaces[0].name, "clé");
        EXPECT_NEAR(volume_of(read.surfaces[0]), 1, 1e-12);
        EXPECT_TRUE(lowest_of(read.surfaces[0]).isApprox(Eigen::Vector3d(5, 0, 0)));
        EXPECT_EQ(read.metres_per_unit, 0.0254);
    }
    std::string turned = text;
    turned.replace(turned.find("</deltax>"), 9, "</deltax><rz>90</rz>");
    EXPECT_NE(refusal(folder.write("turned.amf", turned)).find("<rz> is not placed rightly"), std::string::npos);
    std::string circle = text;
    circle.replace(circle.find("objectid=\"0\""), 12, "objectid=\"1\"");
    EXPECT_NE(refusal(folder.write("circle.amf", circle)).find("does not stand before it"), std::string::npos);
    EXPECT_NE(refusal(folder.write("none.amf", to_zip({{"a.txt", "no model"}}))).find("holds no .amf"),
              std::string::npos);
}

TEST(ReadAmf, RefusesAMeshOfSeveralVolumes)
{
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "two.amf",
        "<amf><object id=\"0\"><mesh><vertices><vertex><coordinates><x>0</x><y>0</y><z>0</z></coordinates>"
        "</vertex></vertices>\n<volume/>\n<volume/></mesh></object></amf>");
    try {
        mesh::read_mesh(file);
        FAIL() << "assimp would keep the first volume alone";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("this mesh has 2 volumes"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace voussoir::importers
