#include "importers/exact/certify.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "libdda/geometry/moments.h"
#include "tests/importers/concave_shapes.h"

namespace voussoir::importers
{
namespace
{

void expect_refused(const exact::Certificate& certificate, const std::string& words)
{
    EXPECT_NE(certificate.reason.find(words), std::string::npos) << "reason: " << certificate.reason;
    EXPECT_TRUE(certificate.parts.empty());
    EXPECT_FALSE(certificate.convex);
}

TEST(Certify, AcceptsACubeWithoutRepairAndMergesItsTriangles)
{
    const exact::Certificate certificate = exact::certify(triangulated(unit_cube()));
    EXPECT_EQ(certificate.reason, "");
    EXPECT_TRUE(certificate.closed && certificate.convex);
    EXPECT_TRUE(certificate.repairs.empty());
    ASSERT_EQ(certificate.parts.size(), 1U);
    EXPECT_EQ(certificate.parts[0].faces.size(), 6U);
    EXPECT_EQ(certificate.parts[0].vertices.size(), 8U);
    EXPECT_NEAR(moments_of(certificate.parts[0]).volume, 1, 1e-15);
}

TEST(Certify, RefusesAnOpenSurfaceAndSaysWhere)
{
    mesh::PolygonSurface cube = unit_cube();
    cube.faces.pop_back();
    const exact::Certificate certificate = exact::certify(cube, {.origin = {100, 0, 0}});
    expect_refused(certificate, "not closed: 4 edges");
    EXPECT_FALSE(certificate.closed);
    EXPECT_NE(certificate.reason.find("(100, 0, 1)"), std::string::npos) << "places are in the user's coordinates";
}

TEST(Certify, TurnsASurfaceThatIsInsideOutAndReportsIt)
{
    mesh::PolygonSurface cube = unit_cube();
    for (std::vector<int>& face : cube.faces) std::reverse(face.begin(), face.end());
    const exact::Certificate certificate = exact::certify(cube);
    ASSERT_EQ(certificate.parts.size(), 1U) << certificate.reason;
    EXPECT_NEAR(moments_of(certificate.parts[0]).volume, 1, 1e-15);
    ASSERT_EQ(certificate.repairs.size(), 1U);
    EXPECT_NE(certificate.repairs[0].text.find("all 6 faces"), std::string::npos);
}

TEST(Certify, TurnsSingleFacesAndReportsHowMany)
{
    for (const std::size_t turned : {1U, 2U, 5U}) {
        mesh::PolygonSurface cube = unit_cube();
        for (std::size_t f = 0; f < turned; ++f) std::reverse(cube.faces[f].begin(), cube.faces[f].end());
        const exact::Certificate certificate = exact::certify(cube);
        ASSERT_EQ(certificate.parts.size(), 1U) << certificate.reason;
        EXPECT_NEAR(moments_of(certificate.parts[0]).volume, 1, 1e-15);
        ASSERT_EQ(certificate.repairs.size(), 1U);
        EXPECT_EQ(certificate.repairs[0].text.find(std::to_string(turned) + " of 6 faces"), 0U)
            << certificate.repairs[0].text;
    }
}

TEST(Certify, WeldsIdenticalVerticesSilentlyAndNearOnesWithAReport)
{
    mesh::PolygonSurface soup{"soup", {}, {}};
    for (const std::vector<int>& face : unit_cube().faces) {
        soup.faces.emplace_back();
        for (const int v : face) {
            soup.faces.back().push_back(static_cast<int>(soup.vertices.size()));
            soup.vertices.push_back(unit_cube().vertices[v]);
        }
    }
    EXPECT_TRUE(exact::certify(soup).repairs.empty());
    EXPECT_EQ(exact::certify(soup).reason, "");
    soup.vertices.back().x() += 1e-7;
    const exact::Certificate near = exact::certify(soup);
    EXPECT_EQ(near.reason, "");
    ASSERT_EQ(near.repairs.size(), 1U);
    EXPECT_NE(near.repairs[0].text.find("1 vertices up to 1e-07 m"), std::string::npos) << near.repairs[0].text;
    soup.vertices.back().x() += 1e-3;
    expect_refused(exact::certify(soup), "not closed");
}

TEST(Certify, CutsAConcaveStoneAndReportsIt)
{
    const exact::Certificate certificate = exact::certify(l_shape());
    EXPECT_EQ(certificate.reason, "");
    EXPECT_TRUE(certificate.closed);
    EXPECT_FALSE(certificate.convex);
    EXPECT_EQ(certificate.parts.size(), 2U);
    ASSERT_EQ(certificate.repairs.size(), 1U);
    EXPECT_EQ(certificate.repairs[0].text,
              "it is concave in 1 edges and became 2 convex parts glued together, without "
              "change of volume");
}

TEST(Certify, JudgesConvexityByItsStatedTolerance)
{
    mesh::PolygonSurface cube = triangulated(unit_cube());
    cube.vertices.emplace_back(0.5, 0.5, 1 - 1e-4);  // a dent in the roof: the first vertex of a fan of four
    std::erase_if(cube.faces, [](const auto& face) {
        return std::all_of(face.begin(), face.end(), [](int v) { return v >= 4; });
    });
    for (int i = 0; i < 4; ++i) cube.faces.push_back({8, 4 + i, 4 + (i + 1) % 4});
    EXPECT_GT(exact::certify(cube).parts.size(), 1U);
    const exact::Certificate flattened = exact::certify(cube, {.planarity_tolerance = 1e-3});
    EXPECT_EQ(flattened.reason, "");
    ASSERT_EQ(flattened.repairs.size(), 1U);
    EXPECT_NE(flattened.repairs[0].text.find("volume changed by 3.33e-05 m3"), std::string::npos)
        << flattened.repairs[0].text;
    // What is told is how far they bulge, not how far they may.
    EXPECT_NE(flattened.repairs[0].text.find("bulge by up to 0.0001 m"), std::string::npos)
        << flattened.repairs[0].text;
}

// A text of twelve digits far from the origin: no corner is off the plane of the others by more than its rounding.
TEST(Certify, FlatFacesAreFlatWithinTheDigitsOfTheirText)
{
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    const auto turned = [&](double digits) {
        mesh::PolygonSurface cube = unit_cube();
        for (Eigen::Vector3d& vertex : cube.vertices) {
            vertex = turn * vertex + Eigen::Vector3d(100, 1000, 0);
            for (double& x : vertex) {
                const double unit = x == 0 ? 1 : std::pow(10, std::floor(std::log10(std::abs(x))) + 1 - digits);
                x = std::round(x / unit) * unit;
            }
        }
        return exact::certify(cube);
    };
    const exact::Certificate fine = turned(12), coarse = turned(10);
    EXPECT_NE(fine.volume_error, 0);  // the rounding is seen, and no repair
    EXPECT_TRUE(fine.repairs.empty());
    EXPECT_EQ(coarse.reason, "");
    ASSERT_EQ(coarse.repairs.size(), 1U);
    const std::size_t at = coarse.repairs[0].text.find("up to ");
    ASSERT_NE(at, std::string::npos) << coarse.repairs[0].text;
    const double told = std::stod(coarse.repairs[0].text.substr(at + 6));
    EXPECT_GT(told, 1e-8);
    EXPECT_LT(told, 4e-6);
}

TEST(Certify, RefusesASurfaceThatCrossesItself)
{
    mesh::PolygonSurface cube = triangulated(unit_cube());
    cube.vertices[6] = {-0.5, -0.5, -0.5};  // the corner (1, 1, 1) pulled through the opposite one
    expect_refused(exact::certify(cube), "it intersects itself");
}

TEST(Certify, RefusesOneSidedBranchingAndSplitSurfaces)
{
    mesh::PolygonSurface one_sided{
        "projective plane", {}, {}};  // the hemi-icosahedron: closed, but with one side only
    for (int i = 0; i < 6; ++i)
        one_sided.vertices.emplace_back(std::cos(i), std::sin(i * i), std::cos(3. * i * i));
    one_sided.faces = {{0, 1, 2}, {0, 1, 3}, {0, 2, 4}, {0, 3, 5}, {0, 4, 5},
                       {1, 2, 5}, {1, 3, 4}, {1, 4, 5}, {2, 3, 4}, {2, 3, 5}};
    expect_refused(exact::certify(one_sided), "its faces cannot be oriented consistently");

    mesh::PolygonSurface branching = unit_cube();
    branching.vertices.emplace_back(0.5, -1, 0);
    branching.faces.push_back({0, 1, 8});
    expect_refused(exact::certify(branching), "more than two faces meet in 1 edges");

    mesh::PolygonSurface two = unit_cube();
    const mesh::PolygonSurface second = box({3, 0, 0}, {4, 1, 1});
    two.vertices.insert(two.vertices.end(), second.vertices.begin(), second.vertices.end());
    for (std::vector<int> face : second.faces) {
        for (int& v : face) v += 8;
        two.faces.push_back(face);
    }
    expect_refused(exact::certify(two), "2 separate shells");
}

TEST(Certify, RefusesWhatHasNoVolume)
{
    expect_refused(exact::certify(box({0, 0, 0}, {1, 2e-5, 2e-5})), "no volume");
    EXPECT_NE(exact::certify(box({0, 0, 0}, {1, 1, 0})).reason, "");
    expect_refused(exact::certify({"nothing", {}, {}}), "no faces");
    expect_refused(exact::certify({"point", std::vector<Eigen::Vector3d>(3, {1, 2, 3}), {{0, 1, 2}}}),
                   "one point");
    expect_refused(exact::certify(box({0, 0, 0}, {1e200, 1, 1})), "check the unit");
}

TEST(Certify, CutsABentFaceAsAFanFromItsFirstCorner)
{
    mesh::PolygonSurface bent = unit_cube();
    bent.vertices[6].z() = 1.2;  // a corner of the roof {4, 5, 6, 7}, which folds along the diagonal from 4 to 6
    const exact::Certificate ridge = exact::certify(bent);
    ASSERT_EQ(ridge.parts.size(), 1U) << ridge.reason;
    EXPECT_NEAR(moments_of(ridge.parts[0]).volume, 1 + 0.2 / 3, 1e-15);
    ASSERT_EQ(ridge.repairs.size(), 1U);
    EXPECT_EQ(ridge.repairs[0].text.find("1 faces are not flat and were cut into triangles"), 0U);

    bent.vertices[6].z() = 0.8;  // the same fold is a valley now
    const exact::Certificate valley = exact::certify(bent);
    ASSERT_EQ(valley.parts.size(), 2U) << valley.reason;
    EXPECT_NEAR(moments_of(valley.parts).volume, 1 - 0.2 / 3, 1e-15);
}

}  // namespace
}  // namespace voussoir::importers
