// glTF, COLLADA, DXF, COMPAS: nodes, instances, mirrored transforms, circles.
#include <gtest/gtest.h>

#include "tests/importers/mesh/read_shapes.h"

namespace voussoir::importers
{
namespace
{

bool mentions(const mesh::MeshFile& read, const std::string& words)
{
    return std::any_of(read.repairs.begin(), read.repairs.end(),
                       [&](const std::string& repair) { return repair.find(words) != std::string::npos; });
}

std::string chunk(std::uint32_t kind, std::string content, char filler)
{
    while (content.size() % 4 != 0) content.push_back(filler);
    return bytes_of(static_cast<std::uint32_t>(content.size())) + bytes_of(kind) + content;
}

/// A GLB file with one cube, 1 wide with its lowest corner at the origin, and the nodes given.
std::string to_glb(const std::string& nodes, const std::string& roots)
{
    const mesh::PolygonSurface cube = triangulated(unit_cube());
    std::string binary;
    for (const Eigen::Vector3d& x : cube.vertices)
        for (int i = 0; i < 3; ++i) binary += bytes_of(static_cast<float>(x[i]));
    for (const std::vector<int>& face : cube.faces)
        for (const int v : face) binary += bytes_of(static_cast<std::uint16_t>(v));
    const std::string json =
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + roots + R"(}],"nodes":)" + nodes +
        R"(,"meshes":[{"name":"stone","primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3"},)"
        R"({"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],)"
        R"("buffers":[{"byteLength":168}]})";
    const std::string chunks = chunk(0x4E4F534A, json, ' ') + chunk(0x004E4942, binary, '\0');
    return "glTF" + bytes_of(std::uint32_t{2}) + bytes_of(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

TEST(ReadGltf, AppliesNestedTransformsAndMakesEveryInstanceAStone)
{
    const TemporaryFolder folder;
    const std::string nodes =
        R"([{"translation":[4600000.5,0,0],"rotation":[0,0,0.7071067811865476,0.7071067811865476],"children":[1,2]},)"
        R"({"name":"clé","mesh":0,"scale":[2,3,4]},{"name":"clé","mesh":0,"translation":[10,0,0]}])";
    const mesh::MeshFile read = mesh::read_mesh(folder.write("nested.glb", to_glb(nodes, "[0]")));
    ASSERT_EQ(read.surfaces.size(), 2U);
    EXPECT_EQ(read.surfaces[0].name, "clé");
    EXPECT_EQ(read.surfaces[1].name, "clé (2)");
    EXPECT_NEAR(volume_of(read.surfaces[0]), 24, 1e-6);
    EXPECT_TRUE(lowest_of(read.surfaces[0]).isApprox(Eigen::Vector3d(4600000.5 - 3, 0, 0), 1e-12));
    EXPECT_TRUE(lowest_of(read.surfaces[1]).isApprox(Eigen::Vector3d(4600000.5 - 1, 10, 0), 1e-12));
    EXPECT_EQ(read.metres_per_unit, 1);
    EXPECT_EQ(read.up, 'y');
}

TEST(ReadGltf, TurnsTheFacesOfMirroredNodes)
{
    const TemporaryFolder folder;
    const mesh::MeshFile read = mesh::read_mesh(
        folder.write("mirror.glb", to_glb(R"([{"mesh":0,"matrix":[-2,0,0,0,0,1,0,0,0,0,1,0,5,0,0,1]}])", "[0]")));
    EXPECT_NEAR(volume_of(read.surfaces.at(0)), 2, 1e-12);
    EXPECT_EQ(lowest_of(read.surfaces[0]), Eigen::Vector3d(3, 0, 0));
    EXPECT_TRUE(mentions(read, "mirrors"));
}

TEST(ReadGltf, RefusesCirclesAndNumbersBeyondTheBuffer)
{
    const TemporaryFolder folder;
    const auto circle = to_glb(R"([{"children":[1]},{"mesh":0,"children":[0]}])", "[0]");
    EXPECT_NE(refusal(folder.write("circle.glb", circle)).find("its own ancestor"), std::string::npos);
    EXPECT_NE(refusal(folder.write("none.glb", to_glb(R"([{"mesh":7}])", "[0]"))).find("entry 7"),
              std::string::npos);
    std::string beyond = to_glb(R"([{"mesh":0}])", "[0]");
    beyond.replace(beyond.find("\"count\":8"), 9, "\"count\":9");
    EXPECT_NE(refusal(folder.write("beyond.glb", beyond)).find("reaches beyond its buffer"), std::string::npos);
}

TEST(ReadGltf, TakesBuffersFromBase64AndFromFilesBesideIt)
{
    const TemporaryFolder folder;
    std::string points;
    for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) points += bytes_of(x);
    folder.write("a point.bin", points);
    for (const std::string uri : {"a%20point.bin",
                                  "data:application/octet-stream;base64,"
                                  "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}) {
        const mesh::MeshFile read = mesh::read_mesh(folder.write(
            "t.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
                      R"({"POSITION":0},"mode":5}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,)"
                      R"("type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"uri":")" +
                          uri + R"(","byteLength":36}]})"));
        EXPECT_EQ(read.surfaces.at(0).vertices.at(2), Eigen::Vector3d(0, 1, 0));
    }
    EXPECT_NE(refusal(folder.write("up.gltf", R"({"asset":{"version":"2.0"},"nodes":[],"meshes":[],)"
                                              R"("buffers":[{"uri":"../secret.bin","byteLength":1}]})"))
                  .find("beside"),
              std::string::npos);
}

std::string collada(const std::string& asset, const std::string& scene)
{
    return "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\"><asset>" + asset +
           "</asset><library_geometries><geometry id=\"g\" name=\"block\"><mesh>\n<source id=\"p\"><float_array "
           "id=\"a\" count=\"12\">0 0 0 4600000.123456789 0 0 0 1 0 0 0 "
           "1</float_array><technique_common><accessor "
           "source=\"#a\" count=\"4\" stride=\"3\"/></technique_common></source><vertices id=\"v\"><input "
           "semantic=\"POSITION\" source=\"#p\"/></vertices>\n<polylist count=\"2\" material=\"red\"><input "
           "semantic=\"VERTEX\" source=\"#v\" offset=\"1\"/><vcount>3 3</vcount><p>9 0 9 2 9 1 9 0 9 1 9 "
           "3</p></polylist>\n<triangles count=\"2\" material=\"blue\"><input semantic=\"VERTEX\" source=\"#v\" "
           "offset=\"0\"/><p>1 2 3 0 3 2</p></triangles></mesh></geometry></library_geometries>\n" +
           scene + "</COLLADA>";
}

TEST(ReadCollada, KeepsDigitsMaterialsOfOneStoneTogetherAndInstancesApart)
{
    const TemporaryFolder folder;
    const std::string scene =
        "<library_nodes><node id=\"pair\"><instance_geometry url=\"#g\"/></node></library_nodes>"
        "<library_visual_scenes><visual_scene id=\"s\"><node name=\"日本\"><instance_geometry url=\"#g\"/></node>"
        "<node name=\"moved\"><translate>1 2 3</translate><rotate>0 0 1 90</rotate><scale>1 -1 1</scale>"
        "<instance_node url=\"#pair\"/></node></visual_scene></library_visual_scenes>"
        "<scene><instance_visual_scene url=\"#s\"/></scene>";
    const mesh::MeshFile read = mesh::read_mesh(
        folder.write("two.dae", collada("<unit name=\"inch\" meter=\"0.0254\"/><up_axis>Z_UP</up_axis>", scene)));
    ASSERT_EQ(read.surfaces.size(), 2U);
    EXPECT_EQ(read.surfaces[0].name, "日本");
    EXPECT_EQ(read.surfaces[0].faces.size(), 4U);
    EXPECT_EQ(read.surfaces[0].vertices[1].x(), 4600000.123456789);
    EXPECT_NEAR(volume_of(read.surfaces[0]), 4600000.123456789 / 6, 1e-3);
    EXPECT_NEAR(volume_of(read.surfaces[1]), 4600000.123456789 / 6, 1e-3) << "mirrored: its faces are turned";
    EXPECT_TRUE(read.surfaces[1].vertices[0].isApprox(Eigen::Vector3d(1, 2, 3)));
    EXPECT_EQ(read.metres_per_unit, 0.0254);
    EXPECT_EQ(read.up, 'z');
    EXPECT_TRUE(mentions(read, "mirrors"));
}

TEST(ReadCollada, RefusesCirclesWrongIndicesAndMissingParts)
{
    const TemporaryFolder folder;
    const std::string begin = "<library_visual_scenes><visual_scene id=\"s\">",
                      end = "</visual_scene></library_visual_scenes>";
    const std::string circle = begin + "<node id=\"n\"><instance_node url=\"#n\"/></node>" + end;
    EXPECT_NE(refusal(folder.write("circle.dae", collada("", circle))).find("part of itself"), std::string::npos);
    const std::string missing = begin + "<node><instance_geometry url=\"#nowhere\"/></node>" + end;
    EXPECT_NE(refusal(folder.write("missing.dae", collada("", missing))).find("missing.dae:6"), std::string::npos);
    std::string index = collada("", begin + "<node><instance_geometry url=\"#g\"/></node>" + end);
    index.replace(index.find("1 2 3 0 3 2"), 11, "1 2 3 0 3 8");
    EXPECT_NE(refusal(folder.write("index.dae", index)).find("index.dae:5: a face names vertex 8"),
              std::string::npos)
        << refusal(folder.path() / "index.dae");
}

/// Pairs as "code value", one a line, as a DXF file writes them on two.
std::string dxf(const std::string& pairs)
{
    std::string text;
    for (std::size_t at = 0; at < pairs.size();) {
        const std::size_t space = pairs.find(' ', at), end = std::min(pairs.find('\n', at), pairs.size());
        text += " " + pairs.substr(at, space - at) + "\r\n" + pairs.substr(space + 1, end - space - 1) + "\r\n";
        at = end + 1;
    }
    return text;
}

std::string polyface(const std::string& layer)
{
    std::string text = "0 POLYLINE\n8 " + layer + "\n70 64\n71 8\n72 6\n";
    const mesh::PolygonSurface cube = unit_cube();
    for (const Eigen::Vector3d& x : cube.vertices)
        text += "0 VERTEX\n8 0\n70 192\n10 " + digits(x.x()) + "\n20 " + digits(x.y()) + "\n30 " + digits(x.z()) +
                "\n";
    for (const std::vector<int>& face : cube.faces) {
        text += "0 VERTEX\n8 0\n70 128\n10 0\n20 0\n30 0\n";
        for (std::size_t i = 0; i < face.size(); ++i)
            text += std::to_string(71 + i) + (i % 2 == 0 ? " -" : " ") + std::to_string(face[i] + 1) + "\n";
    }
    return text + "0 SEQEND\n";
}

TEST(ReadDxf, ReadsPolyfaceMeshesBlocksFacesByLayerAndTheUnit)
{
    const TemporaryFolder folder;
    const std::string face =
        "0 3DFACE\n8 wall\n10 0\n20 0\n30 0\n11 1\n21 0\n31 0\n12 1\n22 1\n32 0\n13 0\n23 1\n33 0\n";
    const mesh::MeshFile read = mesh::read_mesh(
        folder.write("site.dxf", dxf("0 SECTION\n2 HEADER\n9 $INSUNITS\n70 5\n0 ENDSEC\n0 SECTION\n2 "
                                     "BLOCKS\n0 BLOCK\n2 unit\n10 1\n20 0\n30 "
                                     "0\n" +
                                     polyface("0") + "0 ENDBLK\n0 ENDSEC\n0 SECTION\n2 ENTITIES\n" + face +
                                     polyface("key \\U+65E5\\U+672C \\U+") + face +
                                     "0 INSERT\n2 unit\n10 500000.123456789\n20 4600000\n30 0\n41 "
                                     "-2\n50 90\n0 LINE\n10 0\n0 ENDSEC\n0 EOF\n")));
    ASSERT_EQ(read.surfaces.size(), 3U);
    EXPECT_EQ(read.surfaces[0].name, "key 日本 \\U+");
    EXPECT_NEAR(volume_of(read.surfaces[0]), 1, 1e-12);
    EXPECT_NEAR(volume_of(read.surfaces[1]), 2, 1e-8) << "mirrored: its faces are turned";
    EXPECT_TRUE(lowest_of(read.surfaces[1]).isApprox(Eigen::Vector3d(500000.123456789 - 1, 4600000, 0), 1e-15));
    EXPECT_EQ(read.surfaces[2].name, "wall");
    EXPECT_EQ(read.surfaces[2].faces.size(), 2U);
    EXPECT_EQ(read.metres_per_unit, 0.01);
    EXPECT_TRUE(mentions(read, "1 LINE"));
    EXPECT_EQ(mesh::read_mesh(folder.path() / "site.dxf", {mesh::StonesBy::group}).surfaces.size(), 3U);
}

TEST(ReadDxf, ReadsMeshesAndGrids)
{
    const TemporaryFolder folder;
    std::string mesh = "0 MESH\n8 m\n71 2\n72 0\n91 0\n92 4\n";
    std::string grid = "0 POLYLINE\n8 g\n70 49\n71 3\n72 3\n";
    for (const char* x : {"10 0\n20 0\n30 0\n", "10 1\n20 0\n30 0\n", "10 0\n20 1\n30 0\n", "10 0\n20 0\n30 1\n"})
        mesh += x;
    mesh +=
        "93 16\n90 3\n90 0\n90 2\n90 1\n90 3\n90 0\n90 1\n90 3\n90 3\n90 1\n90 2\n90 3\n90 3\n90 0\n90 3\n90 "
        "2\n94 1\n90 0\n90 1\n95 0\n";
    for (int i = 0; i < 9; ++i)
        grid += "0 VERTEX\n70 64\n10 " + std::to_string(i) + "\n20 " + std::to_string(i % 3) + "\n30 0\n";
    const mesh::MeshFile read = mesh::read_mesh(
        folder.write("m.dxf", dxf("0 SECTION\n2 ENTITIES\n" + mesh + grid + "0 SEQEND\n0 ENDSEC\n0 EOF\n")));
    ASSERT_EQ(read.surfaces.size(), 2U);
    EXPECT_NEAR(volume_of(read.surfaces[0]), 1. / 6, 1e-15);
    EXPECT_EQ(read.surfaces[1].faces.size(), 9U) << "closed in both directions";
    EXPECT_FALSE(read.metres_per_unit);
}

TEST(ReadDxf, RefusesCirclesCutFilesAndBinary)
{
    const TemporaryFolder folder;
    const std::string circle =
        dxf("0 SECTION\n2 BLOCKS\n0 BLOCK\n2 a\n0 INSERT\n2 a\n0 ENDBLK\n0 ENDSEC\n"
            "0 SECTION\n2 ENTITIES\n0 INSERT\n2 a\n0 ENDSEC\n0 EOF\n");
    EXPECT_NE(refusal(folder.write("circle.dxf", circle)).find("part of itself"), std::string::npos);
    EXPECT_NE(refusal(folder.write("cut.dxf", dxf("0 SECTION\n2 ENTITIES\n" + polyface("a")))).find("cut off"),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("b.dxf", "AutoCAD Binary DXF\r\n\x1A")).find("binary DXF"), std::string::npos);
}

std::string compas_mesh(const std::string& type)
{
    const mesh::PolygonSurface cube = unit_cube();
    std::string vertices, faces;
    for (std::size_t v = 0; v < cube.vertices.size(); ++v) {
        const Eigen::Vector3d& x = cube.vertices[v];
        vertices += (v > 0 ? ",\"" : "\"") + std::to_string(3 * v) + "\":{\"x\":" + digits(x.x()) +
                    ",\"z\":" + digits(x.z()) + (x.y() != 0 ? ",\"y\":" + digits(x.y()) : "") + "}";
    }
    for (std::size_t f = 0; f < cube.faces.size(); ++f) {
        faces += (f > 0 ? ",\"" : "\"") + std::to_string(f) + "\":[";
        for (std::size_t i = 0; i < 4; ++i) faces += (i > 0 ? "," : "") + std::to_string(3 * cube.faces[f][i]);
        faces += "]";
    }
    return "{\"dtype\":\"" + type + R"(","data":{"default_vertex_attributes":{"y":0},"vertex":{)" + vertices +
           "},\"face\":{" + faces + "}}}";
}

TEST(ReadCompas, ReadsEveryDialect)
{
    const TemporaryFolder folder;
    const std::string mesh = compas_mesh("compas.datastructures/Mesh");
    const std::vector<std::pair<std::string, std::vector<std::string>>> dialects{
        {R"({"dtype":"compas_assembly.datastructures/Assembly","data":{"attributes":{"name":"Assembly"},"graph":)"
         R"({"data":{"node":{"10":{"block":)" +
             mesh + R"(},"clé":{"block":)" + mesh + R"(}},"edge":{"10":{"x":{"interfaces":[)" + mesh + "]}}}}}}}",
         {"10", "clé"}},
        {R"({"data":{"node":{"0":{"x":1}}},"blocks":{"b2":)" + mesh + R"(,"b1":)" + mesh + "}}", {"b2", "b1"}},
        {R"({"dtype":"compas_model.models/Model","data":{"name":"Model","elementlist":[{"dtype":)"
         R"("compas_model.elements/BlockElement","data":{"name":"north","transformation":{"dtype":"t","data":)"
         R"({"matrix":[[1,0,0,5],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}},"geometry":)" +
             mesh +
             R"(}},{"dtype":"compas_model.elements/BlockElement","data":{"name":"BlockElement","geometry":)" +
             mesh + "}}]}}",
         {"north", "block 1"}},
        {"[" + mesh + "," + mesh + "]", {"block 0", "block 1"}},
        {mesh, {"dialect"}},
        {R"({"dtype":"compas.geometry/Polyhedron","data":{"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,6]],)"
         R"("faces":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]]}})",
         {"dialect"}}};
    for (const auto& [text, names] : dialects) {
        const mesh::MeshFile read = mesh::read_mesh(folder.write("dialect.json", text));
        ASSERT_EQ(read.surfaces.size(), names.size()) << text.substr(0, 100);
        for (std::size_t i = 0; i < names.size(); ++i) {
            EXPECT_EQ(read.surfaces[i].name, names[i]) << text.substr(0, 100);
            EXPECT_NEAR(volume_of(read.surfaces[i]), 1, 1e-15);
        }
        EXPECT_EQ(lowest_of(read.surfaces[0]).x(), names[0] == "north" ? 5 : 0) << "its transformation";
    }
}

TEST(ReadCompas, SaysWhatIsMissing)
{
    const TemporaryFolder folder;
    EXPECT_NE(refusal(folder.write("a.json", R"({"type":"FeatureCollection"})")).find("\"vertex\" and \"face\""),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("b.json", "{\n\"vertex\": {\n")).find("b.json:3"), std::string::npos);
    EXPECT_NE(refusal(folder.write("c.json", R"({"vertex":{"0":{"x":0,"y":0,"z":0}},"face":{"0":[0,1,2]}})"))
                  .find("names vertex 1"),
              std::string::npos);
    EXPECT_NE(
        refusal(folder.write("d.json", R"({"vertex":{"0":{"x":0,"y":0}},"face":{}})")).find("no coordinates"),
        std::string::npos);
    EXPECT_NE(refusal(folder.write("f.json", "{\"vertex\":{\"0\":{\"x\":1e999}}}")).find("too large"),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("e.json", std::string(100000, '['))).find("not JSON"), std::string::npos);
}

}  // namespace
}  // namespace voussoir::importers
