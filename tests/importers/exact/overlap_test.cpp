#include "importers/exact/overlap.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "libdda/geometry/moments.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Vector3d;

ConvexPolyhedron turned(ConvexPolyhedron shape, double angle, const Vector3d& axis)
{
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    for (Vector3d& x : shape.vertices) x = rotation * x;
    return shape;
}

ConvexPolyhedron cube(double half = 0.5)
{
    return make_box(Vector3d::Constant(-half), Vector3d::Constant(half));
}

TEST(Overlap, OfBoxesIsTheProductOfTheirSharedSides)
{
    const ConvexPolyhedron other = make_box({0.25, 0.4, -2}, {3, 3, 0.1});
    EXPECT_NEAR(exact::overlap_volume(cube(), other), 0.25 * 0.1 * 0.6, 1e-15);
    EXPECT_NEAR(exact::overlap_volume(other, cube()), 0.25 * 0.1 * 0.6, 1e-15);
}

TEST(Overlap, IsExactlyNothingWhereStonesTouch)
{
    EXPECT_EQ(exact::overlap_volume(cube(), translated(cube(), {1, 0, 0})), 0);
    EXPECT_EQ(exact::overlap_volume(cube(), translated(cube(), {1, 0.3, 1})), 0);
    EXPECT_EQ(exact::overlap_volume(cube(), translated(cube(), {1, 1, 1})), 0);
}

TEST(Overlap, OfAStoneWithItselfOrOneInsideItIsTheSmallerVolume)
{
    const ConvexPolyhedron tilted = turned(cube(), 0.3, {1, 2, 3});
    EXPECT_NEAR(exact::overlap_volume(tilted, tilted), 1, 1e-14);
    EXPECT_NEAR(exact::overlap_volume(tilted, cube(0.2)), 0.064, 1e-15);
    EXPECT_NEAR(exact::overlap_volume(cube(0.2), tilted), 0.064, 1e-15);
}

TEST(Overlap, OfACubeWithItselfTurnedByAnEighthIsAnOctagon)
{
    const ConvexPolyhedron other = turned(cube(), std::numbers::pi / 4, Vector3d::UnitZ());
    EXPECT_NEAR(exact::overlap_volume(cube(), other), 2 * (std::sqrt(2.) - 1), 1e-14);
}

TEST(Overlap, OfTiltedStonesIsSymmetricAndAddsUpOverTheHalvesOfOne)
{
    const ConvexPolyhedron halves[] = {make_box({-0.5, -0.5, -0.5}, {0.1, 0.5, 0.5}),
                                       make_box({0.1, -0.5, -0.5}, {0.5, 0.5, 0.5})};
    for (int i = 1; i <= 200; ++i) {
        const Vector3d axis(std::sin(i), std::cos(2 * i), std::sin(3 * i));
        const Vector3d offset = 0.6 * Vector3d(std::sin(5 * i), std::cos(7 * i), std::sin(11 * i));
        const ConvexPolyhedron other = translated(turned(cube(), i, axis), offset);
        const double volume = exact::overlap_volume(cube(), other);
        EXPECT_NEAR(exact::overlap_volume(other, cube()), volume, 1e-14);
        EXPECT_NEAR(exact::overlap_volume(halves[0], other) + exact::overlap_volume(halves[1], other), volume,
                    1e-14);
        EXPECT_GT(volume, 0);
    }
}

TEST(Overlap, IsReportedPerPairAboveTheTolerance)
{
    const std::vector<std::vector<ConvexPolyhedron>> stones{{cube()},
                                                            {translated(cube(), {0.9, 0, 0})},
                                                            {translated(cube(), {1.9, 0, 0})},
                                                            {translated(cube(), {2.9 - 1e-7, 0, 0})}};
    const std::vector<exact::OverlappingPair> pairs = exact::find_overlaps(stones);
    ASSERT_EQ(pairs.size(), 1U) << "touching, and overlapping by 1e-7 of the volume, are no overlaps";
    EXPECT_EQ(pairs[0].a, 0);
    EXPECT_EQ(pairs[0].b, 1);
    EXPECT_NEAR(pairs[0].volume, 0.1, 1e-15);
    EXPECT_EQ(exact::find_overlaps(stones, 1e-8).size(), 2U);
}

}  // namespace
}  // namespace voussoir::importers
