// A face that opens in part: points on both sides of the line, with the moments of both.
#include "libdda/contact/cut_face.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "libdda/contact/narrow_phase.h"
#include "libdda/model/state.h"

namespace voussoir::testing
{

namespace
{

using contact::PolygonPoint;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// A convex polygon of no symmetry in the plane z = 0, seen from below.
std::vector<PolygonPoint> irregular(std::mt19937& engine)
{
    std::uniform_real_distribution<double> part(0, 1);
    const int corners = 3 + static_cast<int>(5 * part(engine));
    const double longer = 1 + 3 * part(engine);
    std::vector<PolygonPoint> points;
    for (int i = corners; i-- > 0;) {
        const double angle = 2 * std::numbers::pi * (i + 0.6 * part(engine)) / corners;
        points.push_back({Vector3d(longer * std::cos(angle), std::sin(angle), 0), 0, 0,
                          static_cast<std::uint32_t>(points.size())});
    }
    contact::assign_tributary_areas(points, Vector3d::UnitZ());
    return points;
}

/// The gap of a polygon's corners over a plane.
std::vector<double> gaps_of(std::vector<PolygonPoint>& points, double at_origin, const Vector2d& slope)
{
    std::vector<double> gaps;
    gaps.reserve(points.size());
    for (PolygonPoint& point : points) gaps.push_back(point.gap = at_origin + slope.dot(point.position.head<2>()));
    return gaps;
}

/// Force and moments of a pressure -gap where it is closed: by a grid of midpoints.
Vector3d pressure_on_grid(const std::vector<PolygonPoint>& corners, double at_origin, const Vector2d& slope)
{
    constexpr int cells = 1500;
    Vector2d low = corners[0].position.head<2>(), high = low;
    for (const PolygonPoint& corner : corners) {
        low = low.cwiseMin(corner.position.head<2>());
        high = high.cwiseMax(corner.position.head<2>());
    }
    const Vector2d cell = (high - low) / cells;
    const auto is_inside = [&](const Vector2d& at) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vector2d from = corners[i].position.head<2>(),
                           to = corners[(i + 1) % corners.size()].position.head<2>();
            const Vector2d along = to - from, away = at - from;
            if (along.x() * away.y() - along.y() * away.x() > 0) return false;  // it runs clockwise
        }
        return true;
    };
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const Vector2d at = low + Vector2d((i + 0.5) * cell.x(), (j + 0.5) * cell.y());
            const double gap = at_origin + slope.dot(at);
            if (gap < 0 && is_inside(at)) sum -= cell.prod() * gap * Vector3d(1, at.x(), at.y());
        }
    return sum;
}

Vector3d pressure_on_points(const std::vector<PolygonPoint>& points)
{
    Vector3d sum = Vector3d::Zero();
    for (const PolygonPoint& p : points)
        if (p.gap < 0) sum -= p.area * p.gap * Vector3d(1, p.position.x(), p.position.y());
    return sum;
}

}  // namespace

TEST(CutFace, PressureAndItsMomentsAreThoseOfTheAreaThatPresses)
{
    std::mt19937 engine(7);
    for (int n = 0; n < 20; ++n) {
        std::vector<PolygonPoint> points = irregular(engine);
        const Vector2d slope(0.7, -1.1);
        const double at_origin = -0.9 + 0.09 * n;  // from nearly closed to nearly open
        const std::vector<double> gaps = gaps_of(points, at_origin, slope);
        const Vector3d expected = pressure_on_grid(points, at_origin, slope);
        contact::add_points_of_parts<3>(Vector3d::UnitZ(), gaps, points);
        EXPECT_LT((pressure_on_points(points) - expected).norm(), 2e-3 * expected.norm()) << n;
    }
}

TEST(CutFace, CornersStayFirstAndEveryPointHasItsOwnLabel)
{
    std::mt19937 engine(11);
    for (int n = 0; n < 50; ++n) {
        const std::vector<PolygonPoint> corners = irregular(engine);
        std::vector<PolygonPoint> points = corners;
        const std::vector<double> gaps = gaps_of(points, 0.1, {0.7, 0.3});
        contact::add_points_of_parts<3>(Vector3d::UnitZ(), gaps, points);
        std::set<std::uint32_t> labels;
        double area = 0, whole = 0;
        for (const PolygonPoint& corner : corners) whole += corner.area;
        for (std::size_t i = 0; i < points.size(); ++i) {
            labels.insert(points[i].feature);
            area += points[i].area;
            EXPECT_EQ((points[i].feature & inner_feature) == 0, i < corners.size());
            if (i < corners.size()) {
                EXPECT_EQ(points[i].position, corners[i].position);
            }
        }
        EXPECT_EQ(labels.size(), points.size());
        EXPECT_NEAR(area, whole, 1e-13 * whole);
    }
}

TEST(CutFace, AFaceThatPressesAllOverIsNotCut)
{
    std::mt19937 engine(3);
    const std::vector<PolygonPoint> corners = irregular(engine);
    for (const double at_origin : {-10., 10., 0.}) {
        std::vector<PolygonPoint> points = corners;
        const std::vector<double> gaps = gaps_of(points, at_origin, at_origin * Vector2d(0.01, 0.02));
        contact::add_points_of_parts<3>(Vector3d::UnitZ(), gaps, points);
        EXPECT_EQ(points.size(), 3 * corners.size());
    }
}

TEST(CutFace, SegmentOfAPlanarScene)
{
    for (const double line : {0.1, 0.35, 0.8}) {
        std::vector<contact::PolygonPointIn<2>> points{{{0, 0}, -line, 0.5, 0}, {{1, 0}, 1 - line, 0.5, 1}};
        contact::add_points_of_parts<2>(Vector2d::UnitY(), std::vector<double>{-line, 1 - line}, points);
        ASSERT_EQ(points.size(), 8U);
        double force = 0, moment = 0;
        for (const auto& p : points)
            if (p.gap < 0) {
                force -= p.area * p.gap;
                moment -= p.area * p.gap * p.position.x();
            }
        EXPECT_NEAR(force, line * line / 2, 1e-14);
        EXPECT_NEAR(moment, line * line * line / 6, 1e-14);
    }
}

}  // namespace voussoir::testing
