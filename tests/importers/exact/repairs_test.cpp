#include "importers/exact/repairs.h"

#include <gtest/gtest.h>

#include "importers/exact/certify.h"
#include "tests/importers/shapes.h"

namespace voussoir::importers
{
namespace
{

void expect_mended_cube(const mesh::PolygonSurface& surface, const std::string& words)
{
    const exact::Certificate certificate = exact::certify(surface);
    ASSERT_EQ(certificate.parts.size(), 1U) << certificate.reason;
    EXPECT_NEAR(certificate.moments.volume, 1, 1e-14);
    EXPECT_EQ(certificate.parts[0].faces.size(), 6U);
    ASSERT_EQ(certificate.repairs.size(), 1U);
    EXPECT_NE(certificate.repairs[0].text.find(words), std::string::npos) << certificate.repairs[0].text;
}

TEST(Repairs, RepeatedFacesAreDroppedWhateverTheirDirection)
{
    mesh::PolygonSurface cube = unit_cube();
    cube.faces.push_back({cube.faces[0].rbegin(), cube.faces[0].rend()});
    cube.faces.push_back({cube.faces[1][2], cube.faces[1][3], cube.faces[1][0], cube.faces[1][1]});
    expect_mended_cube(cube, "2 faces that repeated another one were dropped");
}

TEST(Repairs, FacesThatMeetWithoutSharingTheirCornersAreJoined)
{
    mesh::PolygonSurface cube =
        unit_cube();  // one wall split in two: its middle corners lie on the edges of floor and roof
    cube.vertices.emplace_back(0.4, 0, 0);
    cube.vertices.emplace_back(0.4, 0, 1);
    cube.faces.erase(cube.faces.begin());  // the wall {0, 1, 5, 4}
    cube.faces.push_back({0, 8, 9, 4});
    cube.faces.push_back({8, 1, 5, 9});
    expect_mended_cube(cube, "2 corners were inserted into edges");
}

TEST(Repairs, TrianglesWithAllCornersOnALineAreDropped)
{
    mesh::PolygonSurface cube = triangulated(unit_cube());
    // The edge from vertex 4 to 5 gets a corner on one side only, and a triangle without area closes the gap.
    cube.vertices.emplace_back(0.5, 0, 1);
    for (std::vector<int>& face : cube.faces)
        if (face == std::vector<int>{0, 1, 5}) face = {0, 1, 5};
    std::vector<std::vector<int>> faces;
    for (const std::vector<int>& face : cube.faces) {
        if (face == std::vector<int>{0, 5, 4}) {
            faces.push_back({0, 5, 8});
            faces.push_back({0, 8, 4});
            faces.push_back({4, 8, 5});
        } else {
            faces.push_back(face);
        }
    }
    cube.faces = faces;
    expect_mended_cube(cube, "1 triangles with all corners on a line were dropped");
}

TEST(Repairs, AnOpenSurfaceIsNotClosedByGuessing)
{
    mesh::PolygonSurface cube = unit_cube();
    cube.faces.pop_back();
    EXPECT_EQ(exact::insert_corners_on_open_edges(cube, 1e-6), 0);
    const exact::Certificate certificate = exact::certify(cube);
    EXPECT_NE(certificate.reason.find("not closed: 4 edges"), std::string::npos);
    ASSERT_EQ(certificate.features.size(), 1U);
    EXPECT_EQ(certificate.features[0].lines.size(), 4U);
    EXPECT_EQ(certificate.surface.faces.size(), 5U);
}

}  // namespace
}  // namespace voussoir::importers
