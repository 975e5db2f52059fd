#include "importers/exact/stones_of.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "importers/exact/certify.h"
#include "importers/exact/shell.h"
#include "tests/importers/concave_shapes.h"

namespace voussoir::importers
{
namespace
{

void append(const mesh::PolygonSurface& from, mesh::PolygonSurface& to)
{
    const int first = static_cast<int>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
    for (std::vector<int> face : from.faces) {
        for (int& v : face) v += first;
        to.faces.push_back(face);
    }
}

/// Every triangle with corners of its own, as STL has them.
mesh::PolygonSurface soup(const mesh::PolygonSurface& surface)
{
    mesh::PolygonSurface result{surface.name, {}, {}};
    for (const std::vector<int>& face : triangulated(surface).faces) {
        const int first = static_cast<int>(result.vertices.size());
        for (const int v : face) result.vertices.push_back(surface.vertices[v]);
        result.faces.push_back({first, first + 1, first + 2});
    }
    return result;
}

double volume_of(const mesh::PolygonSurface& surface)
{
    const exact::Certificate certificate = exact::certify(surface);
    EXPECT_EQ(certificate.reason, "");
    return certificate.moments.volume;
}

TEST(SeparateStones, TakesBoxesThatTouchFaceToFaceApart)
{
    mesh::PolygonSurface row{"row", {}, {}};
    for (int i = 0; i < 4; ++i) append(box({1. * i, 0, 0}, {i + 1., 1, 1 + 0.1 * i}), row);
    append(box({0, 0, -1}, {2, 1, 0}), row);  // under two of them
    const exact::SeparatedStones separated = exact::separate_stones(soup(row), 1e-6);
    ASSERT_EQ(separated.stones.size(), 5U);
    EXPECT_EQ(separated.stones[0].name, "row.1");
    EXPECT_EQ(separated.stones[4].name, "row.5");
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(volume_of(separated.stones[i]), 1 + 0.1 * i, 1e-12);
    EXPECT_NEAR(volume_of(separated.stones[4]), 2, 1e-12);
    ASSERT_EQ(separated.repairs.size(), 1U);
    EXPECT_NE(separated.repairs[0].text.find("5 separate surfaces"), std::string::npos);
}

TEST(SeparateStones, TakesARunningBondApartWhereFourStonesMeetInAnEdge)
{
    mesh::PolygonSurface bond{"bond", {}, {}};
    for (int c = 0; c < 4; ++c)
        for (int b = 0; b < 5; ++b)
            for (int leaf = 0; leaf < 2; ++leaf)
                append(box({b + 0.5 * (c % 2), 1. * leaf, 1. * c}, {b + 1 + 0.5 * (c % 2), leaf + 1., c + 1.}),
                       bond);
    const exact::SeparatedStones separated = exact::separate_stones(soup(bond), 1e-6);
    ASSERT_EQ(separated.stones.size(), 40U);
    for (const mesh::PolygonSurface& stone : separated.stones) EXPECT_NEAR(volume_of(stone), 1, 1e-12);
}

TEST(SeparateStones, TakesStonesApartWhoseFacesAreRoundedAgainstEachOther)
{
    // Two boxes that share the edges of a face, one of which bulges by a thousandth into the other.
    mesh::PolygonSurface two = unit_cube();
    mesh::PolygonSurface bulging = box({1, 0, 0}, {2, 1, 1});
    bulging.faces.erase(std::find(bulging.faces.begin(), bulging.faces.end(), std::vector<int>{3, 0, 4, 7}));
    bulging.vertices.emplace_back(0.999, 0.5, 0.5);
    for (const auto& [a, b] : {std::pair{3, 0}, {0, 4}, {4, 7}, {7, 3}}) bulging.faces.push_back({a, b, 8});
    append(bulging, two);
    const exact::SeparatedStones separated = exact::separate_stones(soup(two), 1e-6);
    ASSERT_EQ(separated.stones.size(), 2U);
    EXPECT_NEAR(volume_of(separated.stones[0]), 1, 1e-12);
    EXPECT_NEAR(volume_of(separated.stones[1]), 1 + 0.001 / 3, 1e-12);
}

TEST(SeparateStones, LeavesStonesThatTouchInAnEdgeOnlyAsTheyAre)
{
    mesh::PolygonSurface two = unit_cube();
    append(box({1, 1, 0}, {2, 2, 1}), two);
    const exact::SeparatedStones separated = exact::separate_stones(soup(two), 1e-6);
    ASSERT_EQ(separated.stones.size(), 1U);
    EXPECT_NE(exact::certify(separated.stones[0]).reason.find("more than two faces meet in 1 edges"),
              std::string::npos);
}

TEST(SeparateStones, KeepsACavityWithItsStone)
{
    const exact::SeparatedStones separated = exact::separate_stones(hollow_cube(), 1e-6);
    ASSERT_EQ(separated.stones.size(), 1U);
    const exact::Certificate certificate = exact::certify(separated.stones[0]);
    ASSERT_EQ(certificate.reason, "");
    EXPECT_NEAR(certificate.moments.volume, 1 - 0.064, 1e-14);
    ASSERT_FALSE(certificate.repairs.empty());
    EXPECT_NE(certificate.repairs[0].text.find("cavities"), std::string::npos);
}

TEST(SeparateStones, AStoneInsideACavityIsAStoneWhateverTheOrder)
{
    const std::vector<mesh::PolygonSurface> shells{box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {3, 3, 3}),
                                                   box({1.5, 1.5, 1.5}, {2.5, 2.5, 2.5})};
    std::vector<int> order{0, 1, 2};
    do {
        mesh::PolygonSurface nest{"nest", {}, {}};
        for (const int shell : order) append(shells[shell], nest);
        const exact::SeparatedStones separated = exact::separate_stones(nest, 1e-6);
        ASSERT_EQ(separated.stones.size(), 2U);
        EXPECT_NEAR(volume_of(separated.stones[0]) + volume_of(separated.stones[1]), 57, 1e-12);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(SeparateStones, AStoneInANotchIsNoCavity)
{
    mesh::PolygonSurface two = u_shape();  // the notch is 1 m wide and 1.5 m deep; the key sits on its ground
    append(box({1, 0.5, 0.2}, {2, 1.5, 0.8}), two);
    const exact::SeparatedStones separated = exact::separate_stones(two, 1e-6);
    ASSERT_EQ(separated.stones.size(), 2U);
    EXPECT_NEAR(volume_of(separated.stones[0]), 4.5, 1e-12);
    EXPECT_NEAR(volume_of(separated.stones[1]), 0.6, 1e-12);
}

TEST(SeparateStones, ACavityIsFoundThoughTheOutsideIsMixedInDirection)
{
    mesh::PolygonSurface hollow = hollow_cube();
    for (const int face : {0, 3, 5}) std::reverse(hollow.faces[face].begin(), hollow.faces[face].end());
    const exact::SeparatedStones separated = exact::separate_stones(hollow, 1e-6);
    ASSERT_EQ(separated.stones.size(), 1U);
    EXPECT_NEAR(volume_of(separated.stones[0]), 1 - 0.064, 1e-14);
    EXPECT_NEAR(volume_of(hollow), 1 - 0.064, 1e-14) << "the same when the user says that it is one stone";
}

TEST(SeparateStones, LeavesASurfaceWithOneClosedShellAlone)
{
    mesh::PolygonSurface cube_and_sheet = unit_cube();
    append({"", {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}}}, cube_and_sheet);
    EXPECT_EQ(exact::separate_stones(cube_and_sheet, 1e-6).stones.size(), 1U);
    EXPECT_EQ(exact::separate_stones(unit_cube(), 1e-6).stones[0].name, unit_cube().name);
}

TEST(SeparateStones, WindingNumberTellsInsideFromOutside)
{
    const mesh::PolygonSurface shape = l_shape();
    EXPECT_NEAR(exact::winding_number(shape, {0.5, 0.5, 0.5}), 1, 1e-12);
    EXPECT_NEAR(exact::winding_number(shape, {1.5, 1.5, 0.5}), 0, 1e-12);
    EXPECT_NEAR(exact::winding_number(shape, {-3, 0.5, 0.5}), 0, 1e-12);
}

}  // namespace
}  // namespace voussoir::importers
