#include "importers/fit/fit_joints.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "importers/exact/certify.h"
#include "importers/exact/overlap.h"
#include "importers/patterns/survey.h"
#include "importers/patterns/vaults.h"

namespace voussoir::importers::fit
{
namespace
{

using Eigen::Vector3d;
using mesh::PolygonSurface;

/// A hexahedron over the corners of its bottom and its top, each counter-clockwise from above; quads are cut along
/// the diagonal from the first or from the second corner.
PolygonSurface hexahedron(const std::string& name, const std::vector<Vector3d>& corners, bool from_first)
{
    PolygonSurface stone{name, corners, {}};
    for (const std::vector<int>& q : std::vector<std::vector<int>>{
             {3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
        const int k = from_first ? 0 : 1;
        stone.faces.push_back({q[k], q[k + 1], q[(k + 2) % 4]});
        stone.faces.push_back({q[k], q[(k + 2) % 4], q[(k + 3) % 4]});
    }
    return stone;
}

std::vector<Vector3d> box(const Vector3d& lower, const Vector3d& upper)
{
    std::vector<Vector3d> corners;
    for (const double z : {lower.z(), upper.z()})
        for (const auto& [x, y] : {std::pair(lower.x(), lower.y()), std::pair(upper.x(), lower.y()),
                                   std::pair(upper.x(), upper.y()), std::pair(lower.x(), upper.y())})
            corners.emplace_back(x, y, z);
    return corners;
}

/// Two boxes on each other, one corner of their joint lifted by `warp`; each cut along its own diagonal.
std::vector<PolygonSurface> warped_pair(double warp)
{
    std::vector<Vector3d> below = box({0, 0, 0}, {1, 1, 1}), above = box({0, 0, 1}, {1, 1, 2});
    below[6].z() += warp;
    above[2].z() += warp;
    return {hexahedron("below", below, true), hexahedron("above", above, true)};
}

Fit fit_all(std::vector<PolygonSurface>& stones, FitJoints how = FitJoints::shared)
{
    std::vector<PolygonSurface*> pointers;
    for (PolygonSurface& stone : stones) pointers.push_back(&stone);
    FitOptions options;
    options.how = how;
    return fit_joints(pointers, options);
}

struct Certified {
    std::vector<std::vector<ConvexPolyhedron>> parts;
    double volume = 0;
};

Certified certified(const std::vector<PolygonSurface>& stones, const Fit& fit)
{
    Certified all;
    for (std::size_t i = 0; i < stones.size(); ++i) {
        exact::CertifyOptions options;
        for (const Frame& joint : fit.stones[i].joints) options.joints.push_back({joint.centre, joint.normal});
        exact::Certificate certificate = exact::certify(stones[i], options);
        EXPECT_EQ(certificate.reason, "") << stones[i].name;
        all.parts.push_back(certificate.parts);
        all.volume += certificate.moments.volume;
    }
    return all;
}

double deepest(const Certified& stones)
{
    double depth = 0;
    for (const exact::OverlappingPair& pair : exact::find_overlaps(stones.parts))
        depth = std::max(depth, pair.fraction);
    return depth;
}

TEST(FitJoints, AWarpedJointGetsOnePlaneBetweenItsFourCorners)
{
    std::vector<PolygonSurface> stones = warped_pair(0.05);
    const Fit fit = fit_all(stones);
    EXPECT_EQ(fit.joints, 1);
    EXPECT_EQ(fit.left, 0);
    EXPECT_NEAR(fit.misfit_before, 0.025,
                1e-4);  // of a twisted square, in its middle: half of what a corner is off
    EXPECT_LT(fit.misfit_after, 1e-7);
    const Certified result = certified(stones, fit);
    for (const auto& parts : result.parts) EXPECT_EQ(parts.size(), 1u);
    EXPECT_LT(deepest(result), 1e-9);
    EXPECT_NEAR(result.volume, 2, 1e-3);
    for (const FittedStone& stone : fit.stones) {
        EXPECT_TRUE(stone.fitted);
        // The corners of a twisted square are a quarter of the twist off the plane between them.
        EXPECT_NEAR(stone.largest_move, 0.0125, 2e-3);
    }
}

TEST(FitJoints, AreInvariantUnderMotionsOfTheWhole)
{
    std::vector<PolygonSurface> drawn = warped_pair(0.05), moved = drawn;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    const Vector3d offset(3, -2, 5);
    for (PolygonSurface& stone : moved)
        for (Vector3d& x : stone.vertices) x = turn * x + offset;
    const Fit one = fit_all(drawn), other = fit_all(moved);
    ASSERT_EQ(one.stones.size(), other.stones.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        EXPECT_NEAR(one.stones[i].largest_move, other.stones[i].largest_move, 1e-9);
        for (const Vector3d& x : drawn[i].vertices) {
            double nearest = 1;
            for (const Vector3d& y : moved[i].vertices)
                nearest = std::min(nearest, (turn * x + offset - y).norm());
            EXPECT_LT(nearest, 1e-8);
        }
    }
}

TEST(FitJoints, AssembliesThatFitKeepEveryBit)
{
    std::vector<PolygonSurface> stones{hexahedron("below", box({0, 0, 0}, {1, 1, 1}), true),
                                       hexahedron("above", box({0.3, 0, 1}, {1.3, 1, 2}), false)};
    const std::vector<PolygonSurface> before = stones;
    const Fit fit = fit_all(stones);
    EXPECT_EQ(fit.joints + fit.left, 0);
    for (std::size_t i = 0; i < stones.size(); ++i) {
        EXPECT_EQ(stones[i].vertices, before[i].vertices);
        EXPECT_EQ(stones[i].faces, before[i].faces);
        EXPECT_FALSE(fit.stones[i].fitted);
    }
}

TEST(FitJoints, ABentSurfaceThatBothSidesShareIsFlattenedOnlyIfPlanesAreAskedFor)
{
    std::vector<PolygonSurface> stones = warped_pair(0.05);
    stones[1].faces[0] = {3, 2, 0};  // of the quad 3 2 1 0, along the diagonal that the stone below has
    stones[1].faces[1] = {2, 1, 0};
    std::vector<PolygonSurface> flat = stones;
    EXPECT_EQ(fit_all(stones, FitJoints::shared).joints, 0);
    const Fit fit = fit_all(flat, FitJoints::planar);
    EXPECT_EQ(fit.joints, 1);
    const Certified result = certified(flat, fit);
    for (const auto& parts : result.parts) EXPECT_EQ(parts.size(), 1u);
    EXPECT_LT(deepest(result), 1e-9);
}

TEST(FitJoints, AsDrawnTouchesNothing)
{
    std::vector<PolygonSurface> stones = warped_pair(0.05);
    const std::vector<PolygonSurface> before = stones;
    EXPECT_EQ(fit_all(stones, FitJoints::as_drawn).joints, 0);
    for (std::size_t i = 0; i < stones.size(); ++i) EXPECT_EQ(stones[i].vertices, before[i].vertices);
}

TEST(FitJoints, AJointDrawnForMortarStaysOpen)
{
    std::vector<PolygonSurface> stones{hexahedron("below", box({0, 0, 0}, {1, 1, 1}), true),
                                       hexahedron("above", box({0, 0, 1.01}, {1, 1, 2}), false)};
    EXPECT_EQ(fit_all(stones).joints, 0);
    EXPECT_EQ(stones[1].vertices[0].z(), 1.01);
}

TEST(FitJoints, AWedgeStaysAWedge)
{
    std::vector<Vector3d> above = box({0, 0, 1}, {1, 1, 2});
    for (Vector3d& x : above)
        if (x.x() > 0.5) x.z() += 0.03;
    std::vector<PolygonSurface> stones{hexahedron("below", box({0, 0, 0}, {1, 1, 1}), true),
                                       hexahedron("above", above, false)};
    EXPECT_EQ(fit_all(stones).joints, 0);
}

TEST(FitJoints, AnOverlapOfFlatFacesIsSharedOutOnlyIfPlanesAreAskedFor)
{
    std::vector<PolygonSurface> stones{hexahedron("below", box({0, 0, 0}, {1, 1, 1}), true),
                                       hexahedron("above", box({0, 0, 0.99}, {1, 1, 2}), false)};
    EXPECT_EQ(fit_all(stones, FitJoints::shared).joints, 0);
    const Fit fit = fit_all(stones, FitJoints::planar);
    EXPECT_EQ(fit.joints, 1);
    for (const Vector3d& x : stones[0].vertices) EXPECT_NEAR(x.z(), x.z() > 0.5 ? 0.995 : 0, 1e-7);
    EXPECT_LT(deepest(certified(stones, fit)), 1e-9);
}

TEST(FitJoints, OneBedUnderTwoStonesStaysOnePlane)
{
    // In bond: the stone above faces two stones, whose head joint is nobody's corner in it.
    std::vector<Vector3d> left = box({0, 0, 0}, {1, 1, 1}), right = box({1, 0, 0}, {2, 1, 1});
    std::vector<Vector3d> above = box({0.5, 0, 1}, {1.5, 1, 2});
    left[5].z() += 0.004;
    right[4].z() += 0.004;
    std::vector<PolygonSurface> stones{hexahedron("left", left, true), hexahedron("right", right, false),
                                       hexahedron("above", above, true)};
    const Fit fit = fit_all(stones);
    EXPECT_GE(fit.joints, 2);
    const Certified result = certified(stones, fit);
    for (const auto& parts : result.parts) EXPECT_EQ(parts.size(), 1u);
    EXPECT_LT(deepest(result), 1e-8);
}

struct Vault {
    const char* name;
    patterns::StoneGrid grid;
};

std::vector<Vault> vaults()
{
    patterns::Dome dome, aligned;
    aligned.bonded = false;
    patterns::BarrelVault barrel;
    return {{"dome in bond", patterns::dome(dome)},
            {"dome of meridians", patterns::dome(aligned)},
            {"barrel vault", patterns::barrel_vault(barrel)},
            {"cross vault", patterns::cross_vault(patterns::CrossVault{})}};
}

TEST(FitJoints, VaultsOfASurveyFitWhateverTheSeed)
{
    for (const Vault& vault : vaults())
        for (const std::uint64_t seed : {1, 2}) {
            SCOPED_TRACE(std::string(vault.name) + ", seed " + std::to_string(seed));
            patterns::Survey survey;
            survey.seed = seed;
            survey.warp = 0.05;
            survey.noise = 0.001;
            survey.diagonals = patterns::Diagonals::random;
            std::vector<PolygonSurface> stones = patterns::surveyed(vault.grid, survey);
            const Fit fit = fit_all(stones);
            EXPECT_GT(fit.joints, 100);
            EXPECT_EQ(fit.left, 0);
            EXPECT_LT(fit.misfit_after, 1e-5);
            const Certified result = certified(stones, fit);
            EXPECT_LT(deepest(result), 1e-3);  // of the smaller stone's volume
            std::size_t parts = 0;
            for (const auto& of_stone : result.parts) parts += of_stone.size();
            EXPECT_LT(parts, 3 * stones.size());
        }
}

/// Of stones with bent quadrilaterals, whose surface is the mean of what their two diagonals give.
double volume_of(const std::vector<PolygonSurface>& stones)
{
    double volume = 0;
    for (const PolygonSurface& stone : stones)
        for (int f = 0; f < static_cast<int>(stone.faces.size()); ++f)
            for (const Eigen::Matrix3d& triangle : triangles_of(stone, f)) volume += triangle.determinant() / 6;
    return volume;
}

TEST(FitJoints, TheVolumeOfAVaultIsKept)
{
    for (const Vault& vault : vaults()) {
        SCOPED_TRACE(vault.name);
        patterns::Survey survey;
        survey.warp = 0.05;
        const double drawn = volume_of(patterns::surveyed(vault.grid, survey));
        survey.diagonals = patterns::Diagonals::random;
        std::vector<PolygonSurface> stones = patterns::surveyed(vault.grid, survey);
        const Fit fit = fit_all(stones);
        EXPECT_NEAR(certified(stones, fit).volume / drawn, 1, 3e-3);
    }
}

TEST(Sides, DoNotDependOnDiagonals)
{
    std::vector<Vector3d> corners = box({0, 0, 0}, {1, 2, 3});
    corners[6] += Vector3d(0.1, -0.1, 0.1);
    const PolygonSurface first = hexahedron("first", corners, true), second = hexahedron("second", corners, false);
    const std::vector<Side> a = sides_of(first), b = sides_of(second);
    ASSERT_EQ(a.size(), 6u);
    ASSERT_EQ(b.size(), 6u);
    for (const Side& side : a) {
        const auto same = std::find_if(b.begin(), b.end(), [&](const Side& other) {
            return other.plane.normal.dot(side.plane.normal) > 0.9;
        });
        ASSERT_NE(same, b.end());
        EXPECT_EQ(same->corners, side.corners);
        EXPECT_LT((same->plane.normal - side.plane.normal).norm(), 1e-12);
        EXPECT_LT(std::abs(same->plane.height(side.plane.centre)), 1e-12);
    }
}

TEST(Sides, OfAnOctagonalDrumAreTen)
{
    PolygonSurface drum{"drum", {}, {{}, {}}};
    for (int k = 0; k < 16; ++k)
        drum.vertices.emplace_back(std::cos(k * std::numbers::pi / 4), std::sin(k * std::numbers::pi / 4), k / 8);
    for (int k = 0; k < 8; ++k) {
        drum.faces[0].push_back(7 - k);
        drum.faces[1].push_back(8 + k);
        drum.faces.push_back({k, (k + 1) % 8, 8 + (k + 1) % 8, 8 + k});
    }
    EXPECT_EQ(sides_of(drum).size(), 10u);
}

}  // namespace
}  // namespace voussoir::importers::fit
