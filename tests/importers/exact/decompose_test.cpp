#include "importers/exact/decompose.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "importers/exact/certify.h"
#include "importers/exact/overlap.h"
#include "tests/importers/concave_shapes.h"

namespace voussoir::importers
{
namespace
{

struct Case {
    const char* name;
    mesh::PolygonSurface surface;
    double volume;
    std::size_t max_parts;
};

double sector_volume()
{
    const double step = std::numbers::pi / 18;  // six chords over 60 degrees
    return 6 * 0.5 * std::sin(step) * (9 - 4) - 0.16;
}

std::vector<Case> cases()
{
    return {{"L", l_shape(), 3, 2},
            {"U", u_shape(), 4.5, 3},
            {"ring sector with a hole", ring_sector_with_hole(), sector_volume(), 14},
            {"hollow cube", hollow_cube(), 1 - 0.064, 14}};
}

double face_area(const ConvexPolyhedron& part, int f)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const std::vector<int>& loop = part.faces[f];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        sum += (part.vertices[loop[i]] - part.vertices[loop[0]])
                   .cross(part.vertices[loop[i + 1]] - part.vertices[loop[0]]);
    return sum.norm() / 2;
}

/// Areas of the faces of the surface and of the faces in cuts.
std::pair<double, double> areas(const std::vector<ConvexPolyhedron>& parts)
{
    double free = 0, glued = 0;
    for (const ConvexPolyhedron& part : parts)
        for (int f = 0; f < static_cast<int>(part.faces.size()); ++f)
            (part.is_glued(f) ? glued : free) += face_area(part, f);
    return {free, glued};
}

double surface_area(const mesh::PolygonSurface& surface)
{
    double area = 0;
    for (const std::vector<int>& loop : surface.faces) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            sum += (surface.vertices[loop[i]] - surface.vertices[loop[0]])
                       .cross(surface.vertices[loop[i + 1]] - surface.vertices[loop[0]]);
        area += sum.norm() / 2;
    }
    return area;
}

void turn(mesh::PolygonSurface& surface)
{
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    for (Eigen::Vector3d& x : surface.vertices) x = rotation * x + Eigen::Vector3d(10, -3, 5);
}

TEST(Decompose, FillsTheSolidWithConvexPartsThatDoNotOverlap)
{
    for (Case& each : cases())
        for (const bool turned : {false, true}) {
            SCOPED_TRACE(std::string(each.name) + (turned ? ", turned" : ""));
            if (turned) turn(each.surface);
            const exact::Certificate stone = exact::certify(each.surface);
            ASSERT_EQ(stone.reason, "");
            EXPECT_FALSE(stone.convex);
            EXPECT_NEAR(stone.moments.volume, each.volume, 1e-12 * each.volume);
            EXPECT_GT(stone.parts.size(), 1U);
            EXPECT_LE(stone.parts.size(), each.max_parts);
            const Moments sum = moments_of(stone.parts);
            EXPECT_NEAR(sum.volume, each.volume, 1e-9 * each.volume);
            EXPECT_LT((sum.centroid - stone.moments.centroid).norm(), 1e-9);
            EXPECT_LT((sum.second - stone.moments.second).norm(), 1e-9 * stone.moments.second.norm());
            for (std::size_t a = 0; a < stone.parts.size(); ++a)
                for (std::size_t b = a + 1; b < stone.parts.size(); ++b)
                    EXPECT_LT(exact::overlap_volume(stone.parts[a], stone.parts[b]), 1e-12);
        }
}

TEST(Decompose, MarksTheFacesInItsCutsAndNoOthers)
{
    for (const Case& each : cases()) {
        SCOPED_TRACE(each.name);
        const exact::Certificate stone = exact::certify(each.surface);
        ASSERT_EQ(stone.reason, "");
        const auto [free, glued] = areas(stone.parts);
        EXPECT_NEAR(free, surface_area(each.surface), 1e-9);
        EXPECT_GT(glued, 0.1);
    }
}

TEST(Decompose, AConvexSolidStaysOnePartWithoutCuts)
{
    const exact::Certificate stone = exact::certify(triangulated(unit_cube()));
    ASSERT_EQ(stone.parts.size(), 1U);
    EXPECT_TRUE(stone.parts[0].glued.empty());
}

/// A finely faceted ball with a dent in every face: far too many concave edges for an exact answer.
mesh::PolygonSurface dented_ball(double depth)
{
    mesh::PolygonSurface ball{"ball", {}, {}};
    const int rings = 10, columns = 16;
    ball.vertices.emplace_back(0, 0, -1);
    for (int r = 1; r < rings; ++r)
        for (int c = 0; c < columns; ++c) {
            const double polar = std::numbers::pi * r / rings, around = 2 * std::numbers::pi * c / columns;
            const double radius = (r + c) % 2 == 0 ? 1 : 1 - depth;
            ball.vertices.push_back(radius * Eigen::Vector3d(std::sin(polar) * std::cos(around),
                                                             std::sin(polar) * std::sin(around),
                                                             -std::cos(polar)));
        }
    ball.vertices.emplace_back(0, 0, 1);
    const auto at = [&](int r, int c) { return 1 + (r - 1) * columns + (c + columns) % columns; };
    const int last = static_cast<int>(ball.vertices.size()) - 1;
    for (int c = 0; c < columns; ++c) {
        ball.faces.push_back({0, at(1, c + 1), at(1, c)});
        ball.faces.push_back({last, at(rings - 1, c), at(rings - 1, c + 1)});
        for (int r = 1; r + 1 < rings; ++r) {
            ball.faces.push_back({at(r, c), at(r, c + 1), at(r + 1, c + 1)});
            ball.faces.push_back({at(r, c), at(r + 1, c + 1), at(r + 1, c)});
        }
    }
    return ball;
}

TEST(Decompose, ApproximatesARoughStoneAndStatesTheVolumeError)
{
    const exact::Certificate stone = exact::certify(dented_ball(0.003));
    ASSERT_EQ(stone.reason, "");
    EXPECT_GT(stone.volume_error, 1e-4);
    EXPECT_LE(stone.volume_error, exact::CertifyOptions{}.volume_error);
    const double sum = moments_of(stone.parts).volume;
    EXPECT_NEAR(stone.volume_error, sum / stone.moments.volume - 1, 1e-9);
    ASSERT_EQ(stone.repairs.size(), 1U);
    EXPECT_NE(stone.repairs[0].text.find("which exceed it by"), std::string::npos) << stone.repairs[0].text;
}

TEST(Decompose, RefusesAStoneThatNeedsTooManyParts)
{
    const exact::Certificate stone = exact::certify(dented_ball(0.2), {.max_parts = 6});
    EXPECT_NE(stone.reason.find("needs more than 6 convex parts"), std::string::npos) << stone.reason;
    EXPECT_TRUE(stone.parts.empty());
    EXPECT_TRUE(stone.closed);
    EXPECT_GT(stone.moments.volume, 1);
}

}  // namespace
}  // namespace voussoir::importers
