#include "importers/exact/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "importers/exact/certify.h"
#include "importers/exact/clipped_volume.h"
#include "importers/exact/hull_volume.h"
#include "importers/exact/overlap.h"
#include "tests/importers/concave_shapes.h"
#include "tests/importers/rough_stone.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Vector3d;

exact::TriangleSurface surface_of(const mesh::PolygonSurface& polygons)
{
    exact::TriangleSurface surface{polygons.vertices, {}};
    for (const std::vector<int>& f : triangulated(polygons).faces)
        surface.triangles.emplace_back(f[0], f[1], f[2]);
    return surface;
}

exact::CertifyOptions to_parts(int parts, double volume_error = 0)
{
    exact::CertifyOptions options;
    options.simplify = exact::SimplifyOptions{};
    options.simplify->max_parts = parts;
    options.simplify->volume_error = volume_error;
    return options;
}

std::vector<Vector3d> vertices_of(const std::vector<ConvexPolyhedron>& parts)
{
    std::vector<Vector3d> all;
    for (const ConvexPolyhedron& part : parts) all.insert(all.end(), part.vertices.begin(), part.vertices.end());
    return all;
}

/// How high the hull of points reaches along directions all round.
std::vector<double> heights(const std::vector<Vector3d>& points, bool down_only)
{
    std::vector<double> found;
    for (int i = 0; i < 400; ++i) {  // a spiral over the sphere
        const double z = 1 - (2 * i + 1) / 400.0, around = 2.4 * i, r = std::sqrt(1 - z * z);
        const Vector3d direction(r * std::cos(around), r * std::sin(around), z);
        if (down_only && -z < std::cos(std::numbers::pi / 5)) continue;
        double most = -1e300;
        for (const Vector3d& x : points) most = std::max(most, direction.dot(x));
        found.push_back(most);
    }
    return found;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

TEST(Simplify, KeepsTheBudgetOfPartsAndTheHullOfTheScan)
{
    const mesh::PolygonSurface scan = rough_stone(5);
    double last = 1;
    for (const int budget : {1, 4, 12}) {
        const exact::Certificate stone = exact::certify(scan, to_parts(budget));
        ASSERT_EQ(stone.reason, "");
        EXPECT_LE(stone.parts.size(), static_cast<std::size_t>(budget));
        EXPECT_GT(stone.volume_error, 0) << "hulls only add";
        EXPECT_LT(stone.volume_error, last) << budget << " parts are nearer than fewer";
        last = stone.volume_error;
        EXPECT_NEAR(moments_of(stone.parts).volume, (1 + stone.volume_error) * stone.moments.volume, 1e-12);
        EXPECT_LT(largest_difference(heights(vertices_of(stone.parts), false), heights(scan.vertices, false)),
                  2e-5)
            << "it stands and tilts on the same points";
        for (std::size_t a = 0; a < stone.parts.size(); ++a)
            for (std::size_t b = a + 1; b < stone.parts.size(); ++b)
                EXPECT_LT(exact::overlap_volume(stone.parts[a], stone.parts[b]), 1e-7 * stone.moments.volume);
    }
}

TEST(Simplify, MassAndInertiaStayThoseOfTheScan)
{
    const mesh::PolygonSurface scan = rough_stone(4);
    const exact::TriangleSurface surface = surface_of(scan);
    const Moments whole = moments_of_surface(surface.vertices, surface.triangles);
    for (const exact::CertifyOptions& options : {to_parts(3), to_parts(12, 0.03)}) {
        const exact::Certificate stone = exact::certify(scan, options);
        ASSERT_EQ(stone.reason, "");
        EXPECT_NEAR(stone.moments.volume, whole.volume, 1e-14);
        EXPECT_LT((stone.moments.centroid - whole.centroid).norm(), 1e-14);
        EXPECT_LT((stone.moments.second - whole.second).norm(), 1e-14);
    }
}

TEST(Simplify, AScanInsideOutGivesTheSameParts)
{
    const mesh::PolygonSurface scan = rough_stone(4);
    const exact::Certificate stone = exact::certify(scan, to_parts(6));
    const exact::Certificate turned = exact::certify(inside_out(scan), to_parts(6));
    ASSERT_EQ(turned.reason, "");
    EXPECT_EQ(turned.repairs.front().kind, "turned inside out");
    ASSERT_EQ(turned.parts.size(), stone.parts.size());
    EXPECT_NEAR(turned.volume_error, stone.volume_error, 1e-9);
    EXPECT_NEAR(turned.moments.volume, stone.moments.volume, 1e-12);
}

TEST(Simplify, DropsCornersThatStandOutToReachAVolumeErrorButNoneItStandsOn)
{
    const mesh::PolygonSurface scan = rough_stone(5, 0.02);
    const exact::SimplifiedStone rough = exact::simplify(surface_of(scan), {.max_parts = 6});
    const double asked = 0.8 * rough.volume_error;
    const exact::SimplifiedStone stone =
        exact::simplify(surface_of(scan), {.max_parts = 6, .volume_error = asked});
    ASSERT_EQ(stone.reason, "");
    EXPECT_LE(stone.volume_error, asked);
    EXPECT_GT(stone.volume_error, 0.8 * asked) << "no more is dropped than needs be";
    EXPECT_GT(stone.smoothed, 0);
    EXPECT_GT(stone.lack, 0) << "what is left out is told";
    EXPECT_LT(stone.lack, 0.25 * asked);
    const std::vector<Vector3d> corners = vertices_of(stone.parts);
    EXPECT_LT(largest_difference(heights(corners, true), heights(scan.vertices, true)), 2e-5);
    EXPECT_LT(largest_difference(heights(corners, false), heights(scan.vertices, false)), stone.smoothed + 2e-5);
}

TEST(Simplify, RefusesWithWhatWasReached)
{
    const exact::Certificate stone = exact::certify(u_shape(), to_parts(1, 0.001));
    EXPECT_NE(stone.reason.find("1 convex parts exceed it by"), std::string::npos) << stone.reason;
    EXPECT_NE(stone.reason.find("0.1 % is allowed"), std::string::npos) << stone.reason;
    EXPECT_TRUE(stone.parts.empty());
}

TEST(Simplify, TakesAVolumeErrorForABudget)
{
    for (const double error : {0.08, 0.04}) {
        const exact::Certificate stone = exact::certify(rough_stone(4), to_parts(64, error));
        ASSERT_EQ(stone.reason, "");
        EXPECT_LE(stone.volume_error, error);
        EXPECT_LT(stone.parts.size(), 12U) << "no more parts than needs be";
    }
}

TEST(Simplify, CutsSimpleShapesWhereAMasonWould)
{
    const exact::Certificate l = exact::certify(l_shape(), to_parts(2));
    ASSERT_EQ(l.parts.size(), 2U);
    EXPECT_NEAR(l.volume_error, 0, 1e-9);
    const exact::Certificate u = exact::certify(u_shape(), to_parts(3));
    ASSERT_EQ(u.parts.size(), 3U);
    EXPECT_LT(u.volume_error, 0.03);
    const exact::Certificate cube = exact::certify(unit_cube(), to_parts(8));
    EXPECT_EQ(cube.parts.size(), 1U) << "a convex stone has nothing to simplify";
}

TEST(Simplify, GluesOnlyFacesThatOtherPartsCover)
{
    const exact::Certificate stone = exact::certify(rough_stone(4), to_parts(8));
    ASSERT_EQ(stone.parts.size(), 8U);
    int glued = 0;
    for (const ConvexPolyhedron& part : stone.parts)
        for (int f = 0; f < static_cast<int>(part.faces.size()); ++f) {
            if (!part.is_glued(f)) continue;
            ++glued;
            Vector3d middle = Vector3d::Zero();
            for (const int v : part.faces[f])
                middle += part.vertices[v] / static_cast<double>(part.faces[f].size());
            const Vector3d beyond = middle + 1e-4 * face_normal(part, f);
            const bool covered = std::any_of(stone.parts.begin(), stone.parts.end(), [&](const auto& other) {
                for (int k = 0; k < static_cast<int>(other.faces.size()); ++k)
                    if (face_normal(other, k).dot(beyond - other.vertices[other.faces[k][0]]) > 0) return false;
                return true;
            });
            EXPECT_TRUE(covered) << "the middle of a glued face lies open";
        }
    EXPECT_GE(glued, 14);
}

TEST(Simplify, DecimatesBeforeAnythingElse)
{
    exact::CertifyOptions options = to_parts(4);
    options.triangles = 500;
    const exact::Certificate stone = exact::certify(rough_stone(5), options);
    ASSERT_EQ(stone.reason, "");
    EXPECT_EQ(stone.repairs.front().kind, "fewer triangles");
    EXPECT_LE(stone.repairs.front().count, 500);
    EXPECT_GE(stone.repairs.front().count, 490);
    EXPECT_LT(stone.repairs.front().worst, 1) << "% of the volume";
    const exact::TriangleSurface scan = surface_of(rough_stone(5));
    EXPECT_NEAR(stone.moments.volume, exact::volume_of(scan), 1e-14) << "the mass is that of the scan";
}

TEST(HullVolume, PointsInAPlaneHaveNoHull)
{
    std::vector<Vector3d> points;  // many, so that they would make many triangles
    for (int i = 0; i < 12; ++i) points.emplace_back(std::cos(i), std::sin(i), 0);
    EXPECT_TRUE(exact::convex_hull(points).triangles.empty());
    EXPECT_EQ(exact::hull_volume(points), 0);
}

TEST(HullVolume, IsThatOfTheExactHull)
{
    std::mt19937 random(3);
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<Vector3d> points;
        for (int i = 0; i < 5 + 10 * trial; ++i) {
            const auto one = [&] { return static_cast<double>(random() % 1000) / 1000; };  // on a grid: with ties
            points.emplace_back(one(), one(), 0.1 * one());
        }
        const double exact_volume = exact::volume_of(exact::convex_hull(points));
        EXPECT_NEAR(exact::hull_volume(points), exact_volume, 1e-8);
    }
    EXPECT_EQ(exact::hull_volume({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}), 0);
}

TEST(ClippedVolume, HasTheClosedFormsOfCutCubesAndRings)
{
    const exact::TriangleSurface cube = surface_of(unit_cube());
    EXPECT_NEAR(exact::clipped_volume(cube, {}), 1, 1e-15);
    EXPECT_NEAR(exact::clipped_volume(cube, {{{0.25, 0, 0}, {1, 0, 0}}}), 0.25, 1e-15);
    EXPECT_NEAR(exact::clipped_volume(cube, {{{0.5, 0, 0}, Vector3d(1, 1, 1).normalized()}}), 1.0 / 48, 1e-15);
    EXPECT_NEAR(exact::clipped_volume(
                    cube, {{{0.5, 0, 0}, {1, 0, 0}}, {{0, 0.5, 0}, {0, 1, 0}}, {{0, 0, 0.5}, {0, 0, 1}}}),
                0.125, 1e-15);
    mesh::PolygonSurface with_cavity = hollow_cube();
    for (std::size_t f = 6; f < with_cavity.faces.size(); ++f)
        std::reverse(with_cavity.faces[f].begin(), with_cavity.faces[f].end());
    const exact::TriangleSurface hollow = surface_of(with_cavity);
    EXPECT_NEAR(exact::clipped_volume(hollow, {{{0, 0, 0.5}, {0, 0, 1}}}), 0.5 * (1 - 0.064), 1e-15)
        << "the cap has a hole";
    EXPECT_NEAR(exact::clipped_volume(cube, {{{2, 0, 0}, {-1, 0, 0}}}), 0, 1e-15);
}

}  // namespace
}  // namespace voussoir::importers
