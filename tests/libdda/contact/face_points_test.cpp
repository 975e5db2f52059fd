// The points of a face have its area, its moments and its mean distance from the centroid.
#include "libdda/contact/face_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "libdda/contact/narrow_phase.h"
#include "libdda/geometry/polygon_moments.h"
#include "libdda/model/state.h"

namespace voussoir::testing
{

namespace
{

using contact::PolygonPoint;
using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Outline = std::vector<Vector2d>;

constexpr double pi = std::numbers::pi;

Outline regular(int corners)
{
    Outline outline;
    for (int i = 0; i < corners; ++i)
        outline.emplace_back(std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners));
    return outline;
}

Outline rectangle(double a, double b)
{
    return {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
}

/// Corners of an affine image of a regular polygon, each turned a little: convex, and of no symmetry.
Outline irregular(std::mt19937& engine)
{
    std::uniform_real_distribution<double> part(0, 1);
    const int corners = 3 + static_cast<int>(5 * part(engine));
    const double longer = 1 + 3 * part(engine), skew = part(engine);
    Outline outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * (i + 0.6 * part(engine)) / corners;
        outline.emplace_back(longer * std::cos(angle) + skew * std::sin(angle), std::sin(angle));
    }
    return outline;
}

/// A face in space: a frame, and the plane of the incident face over it.
struct Face {
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();  // columns u, v, n
    Vector2d slope = Vector2d::Zero();

    std::vector<PolygonPoint> of(const Outline& outline) const
    {
        std::vector<PolygonPoint> points = corners_of(outline);
        contact::add_inner_points(Vector3d(frame.col(2)), points);
        return points;
    }
    Vector2d flat(const PolygonPoint& point) const { return (frame.transpose() * point.position).head<2>(); }

 private:
    std::vector<PolygonPoint> corners_of(const Outline& outline) const
    {
        std::vector<PolygonPoint> points;
        // The incident face is seen from below: its loop runs clockwise about the normal.
        for (auto corner = outline.rbegin(); corner != outline.rend(); ++corner) {
            const double gap = -1e-3 + slope.dot(*corner);
            points.push_back({frame * Vector3d(corner->x(), corner->y(), gap), gap, 0,
                              static_cast<std::uint32_t>(points.size())});
        }
        contact::assign_tributary_areas(points, frame.col(2));
        return points;
    }
};

/// Mean distance of a polygon from its centroid [m], by triangles in polar coordinates.
double mean_distance(const Outline& outline)
{
    const PolygonMoments moments(outline);
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d p = outline[i] - moments.centroid, q = outline[(i + 1) % outline.size()] - moments.centroid;
        const Vector2d along = (q - p).normalized();
        const double height = std::abs(p.x() * along.y() - p.y() * along.x());
        const auto primitive = [&](double s) {  // of (h^2 + s^2)^(1/2) h / 3 by s
            return height / 6 * (s * std::hypot(s, height) + height * height * std::asinh(s / height));
        };
        sum += primitive(q.dot(along)) - primitive(p.dot(along));
    }
    return sum / moments.area;
}

double mean_distance(const Face& face, const Outline& outline)
{
    const PolygonMoments moments(outline);
    double sum = 0;
    for (const PolygonPoint& point : face.of(outline))
        sum += point.area * (face.flat(point) - moments.centroid).norm();
    return sum / moments.area;
}

void expect_moments_of(const Outline& outline, const Face& face, const std::vector<PolygonPoint>& points)
{
    const PolygonMoments exact(outline);
    double area = 0;
    Vector2d first = Vector2d::Zero();
    Matrix2d second = Matrix2d::Zero();
    for (const PolygonPoint& point : points) {
        const Vector2d at = face.flat(point) - exact.centroid;
        EXPECT_GT(point.area, 0);
        EXPECT_NEAR(point.gap, -1e-3 + face.slope.dot(face.flat(point)), 1e-12);
        area += point.area;
        first += point.area * at;
        second += point.area * at * at.transpose();
    }
    EXPECT_NEAR(area, exact.area, 1e-12 * exact.area);
    EXPECT_LT(first.norm(), 1e-12 * std::pow(exact.area, 1.5));
    EXPECT_LT((second - exact.second).norm(), 1e-11 * exact.second.norm());
}

struct Place {
    Vector2d at;    // m
    double weight;  // of the area
};

std::vector<Place> by_triangles(const Outline& outline, int parts)
{
    std::vector<Place> places;
    double area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d p = outline[i] / parts, q = outline[(i + 1) % outline.size()] / parts;
        const double small = 0.5 * (p.x() * q.y() - p.y() * q.x());
        for (int u = 0; u < parts; ++u)
            for (int v = 0; u + v < parts; ++v) {
                places.push_back({(u + 1. / 3) * p + (v + 1. / 3) * q, small});
                if (u + v + 1 < parts) places.push_back({(u + 2. / 3) * p + (v + 2. / 3) * q, small});
            }
        area += small * parts * parts;
    }
    for (Place& place : places) place.weight /= area;
    return places;
}

std::vector<Place> face_places(const Outline& outline)
{
    const Face face;
    const double area = PolygonMoments(outline).area;
    std::vector<Place> places;
    for (const PolygonPoint& point : face.of(outline)) places.push_back({face.flat(point), point.area / area});
    return places;
}

/// Where an increasing function passes through zero.
template <class Function>
double root_of(const Function& f, double low, double high)
{
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0 ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

/// Couple that a face bears of unit friction force under a pressure that grows linearly with x from a line on, its
/// resultant at `lever` [m] from the middle. The face is the same on both sides of the x axis.
double couple_beside(const std::vector<Place>& places, double lever)
{
    double edge = 0;
    for (const Place& place : places) edge = std::max(edge, place.at.x());
    const auto sum_of = [&](double line, const auto& of_place) {
        double sum = 0;
        for (const Place& place : places)
            sum += place.weight * std::max(0.0, place.at.x() - line) * of_place(place);
        return sum;
    };
    const auto force_at = [&](double line) { return sum_of(line, [](const Place&) { return 1.0; }); };
    const double line = root_of(
        [&](double x) { return sum_of(x, [](const Place& place) { return place.at.x(); }) / force_at(x) - lever; },
        -1e3, edge - 1e-9);
    // It turns about the point that takes the least power.
    const double middle = root_of(
        [&](double x) {
            return sum_of(line, [&](const Place& place) {
                const Vector2d to(x - place.at.x(), place.at.y());
                return to.x() / (to.norm() + 1e-12);
            });
        },
        -edge, edge);
    return sum_of(line, [&](const Place& place) { return (place.at - Vector2d(middle, 0)).norm(); }) /
           force_at(line);
}

/// Friction of a face of unit friction force that slides by (vx, vy, spin about the origin).
class Limit
{
 public:
    explicit Limit(std::vector<Place> places) : places_(std::move(places)) {}

    double power(const Vector3d& slide) const
    {
        double sum = 0;
        for (const Place& place : places_) sum += place.weight * speed(slide, place).norm();
        return sum;
    }
    Vector3d force(const Vector3d& slide) const
    {
        Vector3d sum = Vector3d::Zero();
        for (const Place& place : places_) {
            const Vector2d along = place.weight * speed(slide, place).normalized();
            sum += Vector3d(along.x(), along.y(), place.at.x() * along.y() - place.at.y() * along.x());
        }
        return sum;
    }

 private:
    static Vector2d speed(const Vector3d& slide, const Place& place)
    {
        return {slide.x() - slide.z() * place.at.y(), slide.y() + slide.z() * place.at.x()};
    }

    std::vector<Place> places_;
};

std::vector<Vector3d> ways_to_slide(double length)
{
    std::mt19937 engine(3);
    std::normal_distribution<double> normal;
    std::vector<Vector3d> ways;
    ways.reserve(600);
    for (int i = 0; i < 600; ++i) ways.emplace_back(normal(engine), normal(engine), normal(engine) / length);
    return ways;
}

/// Whether a place is in a polygon that runs counter-clockwise.
bool contains(const Outline& outline, const Vector2d& place)
{
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d side = outline[(i + 1) % outline.size()] - outline[i], to = place - outline[i];
        if (side.x() * to.y() - side.y() * to.x() < -1e-12) return false;  // the middles of sides lie on them
    }
    return true;
}

}  // namespace

// A corner that is cut off by a hair: what presses there presses as it did, or an edge that wanders over it would
// pump energy into the stones, or out of them.
TEST(FacePoints, HardlyChangeWhereACornerIsCutOff)
{
    const double e = 1e-4;
    const Outline whole = rectangle(2, 1), cut{{-2, -1}, {2 - e, -1}, {2, -1 + e}, {2, 1}, {-2, 1}};
    Face face;
    for (const Vector2d& slope : {Vector2d(0.3, 0), Vector2d(0.2, -0.3), Vector2d(-0.1, 0.4)}) {
        face.slope = slope;
        const auto pressed = [&](const Outline& outline) {
            double energy = 0;
            for (const PolygonPoint& point : face.of(outline))
                if (const double gap = point.gap - 0.55 * slope.norm(); gap < 0) energy += point.area * gap * gap;
            return energy;
        };
        EXPECT_NEAR(pressed(cut), pressed(whole), 20 * e * pressed(whole));
    }
}

TEST(FacePoints, HaveTheMomentsOfTheFace)
{
    std::mt19937 engine(7);
    Face face;
    face.frame = Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    face.slope = {1e-4, -2e-4};
    std::vector<Outline> outlines;
    outlines.reserve(306);
    for (int i = 0; i < 300; ++i) outlines.push_back(irregular(engine));
    for (int corners = 3; corners < 9; ++corners) outlines.push_back(regular(corners));
    for (const Outline& outline : outlines) expect_moments_of(outline, face, face.of(outline));
}

// Across a needle nothing can be told of a linear gap.
TEST(FacePoints, OfANeedleAreItsCorners)
{
    const Face face;
    for (const double width : {1e-12, 1e-8, 1e-4}) EXPECT_EQ(face.of(rectangle(1, width)).size(), 4U) << width;
    EXPECT_EQ(face.of(rectangle(1, 1e-2)).size(), 12U);
}

// A corner that rounding leaves on a side, or a little inside it, is one more: the face does not fall back on its
// corners.
TEST(FacePoints, OfAFaceWithACornerOnASideAreItsOwn)
{
    for (const double inwards : {0., 1e-12, 1e-6}) {
        Outline outline = rectangle(0.3, 0.2);
        outline.insert(outline.begin() + 1, Vector2d(0.1, -0.2 + inwards));
        const Face face;
        const std::vector<PolygonPoint> points = face.of(outline);
        ASSERT_EQ(points.size(), 15U) << inwards;
        double second = 0, area = 0;
        for (const PolygonPoint& point : points) {
            area += point.area;
            second += point.area * face.flat(point).x() * face.flat(point).x();
        }
        EXPECT_NEAR(area, 0.24, 1e-5 * 0.24);
        EXPECT_NEAR(second, 0.24 * 0.36 / 12, 1e-5 * 0.24 * 0.36 / 12);
    }
}

TEST(FacePoints, LieInTheFace)
{
    std::mt19937 engine(8);
    const Face face;
    for (int i = 0; i < 300; ++i) {
        const Outline outline = irregular(engine);
        const std::vector<PolygonPoint> points = face.of(outline);
        ASSERT_EQ(points.size(), 3 * outline.size());
        for (std::size_t k = outline.size(); k < points.size(); ++k)
            EXPECT_TRUE(contains(outline, face.flat(points[k])));
    }
}

// What even pressure bears against turning on the face: corners with tributary areas have 0.707 a of a square.
TEST(FacePoints, HaveTheMeanDistanceOfTheFace)
{
    const Face face;
    EXPECT_NEAR(mean_distance(rectangle(0.5, 0.5)), 0.3826, 1e-4);
    for (const double longer : {1., 2., 3., 5.}) {
        const Outline outline = rectangle(longer, 1);
        EXPECT_NEAR(mean_distance(face, outline) / mean_distance(outline), 1, 0.02) << "1 : " << longer;
    }
    for (int corners = 3; corners < 9; ++corners) {
        const Outline outline = regular(corners);
        EXPECT_NEAR(mean_distance(face, outline) / mean_distance(outline), 1, 0.01) << corners << " corners";
    }
    std::mt19937 engine(9);
    double squares = 0;
    for (int i = 0; i < 300; ++i) {
        const Outline outline = irregular(engine);
        const double error = mean_distance(face, outline) / mean_distance(outline) - 1;
        EXPECT_LT(std::abs(error), 0.04);
        squares += error * error;
    }
    EXPECT_LT(std::sqrt(squares / 300), 0.015);
}

// Couple and shear at once, at even pressure: for every way to slide, the limit by integration over the face, as a
// share of what the points resist in that direction of force.
TEST(FacePoints, HaveTheLimitOfCoupleAndShearTogether)
{
    for (const Outline& outline : {rectangle(1, 1), rectangle(2, 1), rectangle(3, 1), regular(3), regular(6)}) {
        const Limit exact(by_triangles(outline, 24)), points(face_places(outline));
        const std::vector<Vector3d> slides = ways_to_slide(mean_distance(outline));
        double weakest = 1, strongest = 1;
        for (const Vector3d& slide : slides) {
            const Vector3d force = exact.force(slide);
            double beyond = 0;
            for (const Vector3d& way : slides) beyond = std::max(beyond, force.dot(way) / points.power(way));
            weakest = std::min(weakest, 1 / beyond);
            strongest = std::max(strongest, 1 / beyond);
        }
        // A triangle, on nine points, is the weakest.
        EXPECT_GT(weakest, outline.size() == 3 ? 0.94 : 0.955) << outline.size() << " corners";
        EXPECT_LT(strongest, 1.02) << outline.size() << " corners";
    }
}

// A stone that leans presses beside the middle of its bed, in the end on an edge: two corners there alone would
// bear twice the couple of an even line.
TEST(FacePoints, ResistACoupleBesideTheMiddle)
{
    struct Bed {
        double across, along;  // m, halves: the resultant lies beside the middle across it
        double weakest, strongest;
    };
    for (const Bed& bed : {Bed{0.5, 0.5, 0.99, 1.1}, {0.5, 1, 0.97, 1.02}, {1, 0.5, 0.96, 1.3}}) {
        const Outline outline = rectangle(bed.across, bed.along);
        for (const double e : {0.1, 0.2, 0.3, 0.4, 0.45}) {
            const double ratio = couple_beside(face_places(outline), 2 * e * bed.across) /
                                 couple_beside(by_triangles(outline, 120), 2 * e * bed.across);
            std::printf("%g x %g m, %g of the width: %.3f\n", 2 * bed.across, 2 * bed.along, e, ratio);
            EXPECT_GT(ratio, bed.weakest) << e;
            EXPECT_LT(ratio, bed.strongest) << e;
        }
    }
}

TEST(FacePoints, KeepTheirLabelsApart)
{
    const std::vector<PolygonPoint> points = Face().of(regular(6));
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ((points[i].feature & inner_feature) != 0, i >= 6);
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(points[i].feature, points[k].feature);
    }
}

// A planar scene is the spatial one of the same extent.
TEST(FacePoints, OfASegmentAreThoseOfARectangleFromTheSide)
{
    std::vector<contact::PolygonPointIn<2>> points{{{-1, 0}, -1e-3, 1, 0}, {{1, 0}, -3e-3, 1, 1}};
    contact::add_inner_points(Vector2d(0, 1), points);
    const Face face;
    for (int degree = 0; degree < 6; ++degree) {
        double of_segment = 0, of_rectangle = 0;
        for (const contact::PolygonPointIn<2>& point : points)
            of_segment += point.area * std::pow(point.position.x(), degree);
        for (const PolygonPoint& point : face.of(rectangle(1, 3)))
            of_rectangle += point.area * std::pow(face.flat(point).x(), degree) / 6;
        EXPECT_NEAR(of_segment, of_rectangle, 1e-14) << degree;
        if (degree < 4) {
            EXPECT_NEAR(of_segment, degree % 2 == 0 ? 2. / (degree + 1) : 0, 1e-14) << degree;
        }
    }
    for (const contact::PolygonPointIn<2>& point : points)
        EXPECT_NEAR(point.gap, -2e-3 - 1e-3 * point.position.x(), 1e-15);
}

}  // namespace voussoir::testing
