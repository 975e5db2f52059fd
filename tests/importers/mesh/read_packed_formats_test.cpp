// 3MF: units, transforms, components.
#include <gtest/gtest.h>

#include "tests/importers/mesh/read_shapes.h"

namespace voussoir::importers
{
namespace
{

std::string mesh_3mf()
{
    const mesh::PolygonSurface cube = triangulated(unit_cube());
    std::string text = "<mesh><vertices>";
    for (const Eigen::Vector3d& x : cube.vertices)
        text += "<vertex x=\"" + digits(x.x()) + "\" y=\"" + digits(x.y()) + "\" z=\"" + digits(x.z()) + "\"/>";
    text += "</vertices>\n<triangles>";
    for (const std::vector<int>& face : cube.faces)
        text += "<triangle v1=\"" + std::to_string(face[0]) + "\" v2=\"" + std::to_string(face[1]) + "\" v3=\"" +
                std::to_string(face[2]) + "\"/>";
    return text + "</triangles></mesh>";
}

std::string to_3mf(const std::string& unit, const std::string& objects, const std::string& items)
{
    return to_zip({{"[Content_Types].xml", "<Types/>"},
                   {"3D/3dmodel.model", "<?xml version=\"1.0\"?>\n<model unit=\"" + unit +
                                            "\" xmlns:p=\"production\"><resources>" + objects +
                                            "</resources><build>" + items + "</build></model>"},
                   {"3D/other.model", "<model><resources><object id=\"9\" name=\"afar\">" + mesh_3mf() +
                                          "</object></resources><build/></model>"}});
}

TEST(Read3mf, AppliesBuildTransformsAndComponents)
{
    const TemporaryFolder folder;
    const mesh::MeshFile read = mesh::read_mesh(folder.write(
        "plate.3mf",
        to_3mf("inch",
               "<object id=\"1\" name=\"unit\">" + mesh_3mf() +
                   "</object><object id=\"2\" name=\"pair\"><components><component objectid=\"1\"/><component "
                   "objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 3 0 0\"/></components></object><object id=\"3\" "
                   "type=\"support\">" +
                   mesh_3mf() + "</object>",
               "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 2 500000.123456789 0 7\"/><item objectid=\"3\"/>"
               "<item objectid=\"9\" p:path=\"/3D/other.model\"/>")));
    ASSERT_EQ(read.surfaces.size(), 3U);
    EXPECT_EQ(read.surfaces[1].name, "unit (2)");
    EXPECT_EQ(read.surfaces[2].name, "afar");
    EXPECT_NEAR(volume_of(read.surfaces[0]), 2, 1e-9);
    EXPECT_NEAR(volume_of(read.surfaces[1]), 2, 1e-9) << "mirrored: its faces are turned";
    EXPECT_EQ(lowest_of(read.surfaces[0]), Eigen::Vector3d(500000.123456789 - 1, 0, 7)) << "x goes to y, y to -x";
    EXPECT_EQ(lowest_of(read.surfaces[1]), Eigen::Vector3d(500000.123456789 - 1, 2, 7));
    EXPECT_EQ(read.metres_per_unit, 0.0254);
    EXPECT_EQ(read.up, 'z');
    EXPECT_EQ(read.repairs.size(), 3U) << "a renamed object, a mirrored one, a support left out";
}

TEST(Read3mf, RefusesCirclesMissingObjectsAndDamage)
{
    const TemporaryFolder folder;
    const std::string circle = "<object id=\"1\"><components><component objectid=\"1\"/></components></object>";
    EXPECT_NE(refusal(folder.write("circle.3mf", to_3mf("meter", circle, "<item objectid=\"1\"/>")))
                  .find("a part of itself"),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("none.3mf", to_3mf("meter", circle, "<item objectid=\"5\"/>")))
                  .find(":2: object \"5\" is placed"),
              std::string::npos);
    EXPECT_NE(refusal(folder.write("unit.3mf", to_3mf("mile", circle, ""))).find("\"mile\""), std::string::npos);
    EXPECT_NE(refusal(folder.write("zip.3mf", to_zip({{"a.txt", "no model"}}))).find("no 3D model"),
              std::string::npos);
    const std::string good =
        to_3mf("meter", "<object id=\"1\">" + mesh_3mf() + "</object>", "<item objectid=\"1\"/>");
    EXPECT_EQ(refusal(folder.write("good.3mf", good)), "");
    EXPECT_NE(refusal(folder.write("cut.3mf", good.substr(0, 1000))).find("cut off"), std::string::npos);
}

}  // namespace
}  // namespace voussoir::importers
