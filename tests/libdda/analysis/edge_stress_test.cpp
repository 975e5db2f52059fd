// The bed of a joint, whatever order its patches and their corners come in.
#include "libdda/analysis/edge_stress.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace voussoir::testing
{

namespace
{

/// A triangle in the plane z = 0 that presses at one corner more than at the others.
BedPatch triangle(const std::array<Eigen::Vector2d, 3>& corners, double area)
{
    BedPatch patch;
    patch.normal = Eigen::Vector3d::UnitZ();
    for (FacePlane& face : patch.faces) face.normal = patch.normal;
    for (std::size_t i = 0; i < corners.size(); ++i)
        patch.points.push_back({{corners[i].x(), corners[i].y(), 0}, area / 3, i == 0 ? 4.0 : 1.0});
    return patch;
}

}  // namespace

// The sides of the flat triangle, its longest one above all, are what the rectangle around the bed lies along.
TEST(EdgeStress, DoesNotDependOnWhereAPolygonBeginsNorOnWhichComesFirst)
{
    const BedPatch flat = triangle({{{0, 0}, {2, 0}, {1, 0.5}}}, 0.5);
    const BedPatch small = triangle({{{1, 0.2}, {1.1, 0.23}, {1.02, 0.3}}}, 0.0044);
    const double size = 1, stress = hardest_bearing({flat, small}, size).stress;
    BedPatch turned = flat;
    for (int begin = 0; begin < 3; ++begin) {
        EXPECT_NEAR(hardest_bearing({turned, small}, size).stress, stress, 1e-12 * stress) << begin;
        EXPECT_NEAR(hardest_bearing({small, turned}, size).stress, stress, 1e-12 * stress) << begin;
        std::rotate(turned.points.begin(), turned.points.begin() + 1, turned.points.end());
    }
}

}  // namespace voussoir::testing
