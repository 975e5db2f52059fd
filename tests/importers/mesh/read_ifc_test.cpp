// IFC goes through a reader that is not ours and does not survive damage: what it is given must be whole.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/importers/mesh/read_shapes.h"

namespace voussoir::importers
{
namespace
{

std::string step(const std::string& data)
{
    return "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n" + data +
           "ENDSEC;\nEND-ISO-10303-21;\n";
}

TEST(ReadIfc, RefusesWhatIsNotWholeWithTheLine)
{
    const TemporaryFolder folder;
    const auto said = [&](const std::string& text) { return refusal(folder.write("a.ifc", text)); };
    EXPECT_NE(said(step("#1=IFCWALL(#2,'it''s; (');\n/* #9 */ #2=IFCTEXT($);\n"))
                  .find("reads no meshes from this IFC file"),
              std::string::npos)
        << "whole, but without solids";
    EXPECT_NE(said(step("#1=IFCWALL(#2);\n")).find("a.ifc:6: it names #2"), std::string::npos);
    EXPECT_NE(said(step("#1=IFCWALL($);\n#1=IFCWALL($);\n")).find("a.ifc:7: #1 is defined twice"),
              std::string::npos);
    EXPECT_NE(said(step("#1=IFCWALL($;\n#2=IFCWALL($);\n")).find("a.ifc:6: statement #1 is not whole"),
              std::string::npos);
    EXPECT_NE(
        said(step("#3=IFCTEXT($);\n#1=IFCWALL(#2);\n#2=IFCWALL((#1));\n")).find("a.ifc:7: what is defined here"),
        std::string::npos);
    EXPECT_NE(said(step("#1=IFCWALL($);\n").substr(0, 70)).find("cut off"), std::string::npos);
}

TEST(ReadIfc, EveryCutOffFileIsRefusedInWords)
{
    const char* variable = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = variable != nullptr ? variable : VOUSSOIR_DEFAULT_DATA;
    std::ifstream stream(data / "meshes/building/wall-with-opening-and-window.ifc", std::ios::binary);
    if (!stream) GTEST_SKIP() << "no data: set VOUSSOIR_DATA";
    const std::string whole{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const TemporaryFolder folder;
    for (std::size_t i = 1; i < 20; ++i)
        EXPECT_NE(refusal(folder.write("cut.ifc", whole.substr(0, whole.size() * i / 20))), "") << i;
    const mesh::MeshFile read = mesh::read_mesh(folder.write("whole.ifc", whole));
    ASSERT_EQ(read.surfaces.size(), 2U);
    // The wall is 3000 x 300 x 2000 mm, its window 1000 x 200 x 1000 mm.
    EXPECT_NEAR(volume_of(read.surfaces[1]), 1000. * 200 * 1000, 1e3);
    EXPECT_GT(read.rounding, 0);
    EXPECT_LT(read.rounding, 1e-3);
    EXPECT_EQ(lowest_of(read.surfaces[0]), Eigen::Vector3d(0, 0, 0)) << "assimp's turn to y up is taken back";
}

}  // namespace
}  // namespace voussoir::importers
