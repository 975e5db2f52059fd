// Volume, centroid and second moments of known solids through the whole way: OBJ file, reader, certificate.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "importers/helper/import_meshes.h"
#include "importers/mesh/write_obj.h"
#include "tests/importers/shapes.h"

namespace voussoir::importers
{
namespace
{

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct KnownSolid {
    mesh::PolygonSurface surface;
    double volume;
    Vector3d centroid;
    Matrix3d second;  // about the centroid
};

KnownSolid known_box()
{
    const Vector3d size(1, 0.6, 0.3);
    const double volume = size.prod();
    return {box({0, 0, 0}, size), volume, size / 2, (volume / 12 * size.array().square()).matrix().asDiagonal()};
}

/// Corner tetrahedron with unit legs: integral of x^2 is 1/60, of xy is 1/120, volume 1/6, centroid 1/4.
KnownSolid known_tetrahedron()
{
    mesh::PolygonSurface surface{
        "stone", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    Matrix3d second = Matrix3d::Constant(1. / 120);
    second.diagonal().setConstant(1. / 60);
    return {surface, 1. / 6, Vector3d::Constant(0.25), second - Matrix3d::Constant(1. / 6 / 16)};
}

/// A regular octagon of circumradius R and side a has the second moment A (6 R^2 - a^2) / 24 about any diameter.
KnownSolid known_drum()
{
    const double radius = 0.8, height = 1.1, side = 2 * radius * std::sin(std::numbers::pi / 8);
    std::vector<Eigen::Vector2d> outline;
    for (int i = 0; i < 8; ++i)
        outline.emplace_back(radius * std::cos(i * std::numbers::pi / 4),
                             radius * std::sin(i * std::numbers::pi / 4));
    const double area = 4 * radius * radius * std::sin(std::numbers::pi / 4);
    const double across = area * (6 * radius * radius - side * side) / 24 * height;
    return {prism(outline, 0, height),
            area * height,
            {0, 0, height / 2},
            Vector3d(across, across, area * std::pow(height, 3) / 12).asDiagonal()};
}

/// A trapezoid of half widths b (z = 0) and c (z = h), extruded by d along y and laid down as a prism.
KnownSolid known_voussoir()
{
    const double b = 0.3, c = 0.4, h = 1.5, d = 0.9;
    mesh::PolygonSurface surface = prism({{-b, 0}, {b, 0}, {c, h}, {-c, h}}, 0, d);
    const double area = (b + c) * h, centre = h * (b + 2 * c) / (3 * (b + c));
    const double along = 2 * h * h * h * (b / 12 + c / 4) - area * centre * centre;
    const double across = 2. / 3 * h * (b * b * b + b * b * c + b * c * c + c * c * c) / 4;
    return {surface,
            area * d,
            {0, centre, d / 2},
            Vector3d(across * d, along * d, area * d * d * d / 12).asDiagonal()};
}

/// @param tolerance relative to the solid's own size
void expect_known(const KnownSolid& solid, const Matrix3d& rotation, const Vector3d& offset, double tolerance)
{
    const TemporaryFolder folder;
    mesh::PolygonSurface moved = solid.surface;
    for (Vector3d& x : moved.vertices) x = rotation * x + offset;
    const auto file = folder.write("solid.obj", mesh::to_obj({moved}, {"a known solid"}));
    const helper::Geometry geometry = helper::import_meshes({{.file = file}});
    ASSERT_TRUE(geometry.meshes[0].accepted) << geometry.meshes[0].reason;
    const helper::Stone& stone = geometry.meshes[0].stones[0];
    EXPECT_EQ(stone.parts[0].faces.size(), solid.surface.faces.size());
    EXPECT_NEAR(stone.moments.volume, solid.volume, tolerance * solid.volume);
    const Vector3d centroid = rotation * solid.centroid + (offset - geometry.origin);
    EXPECT_NEAR((stone.moments.centroid - centroid).norm(), 0, tolerance);
    const Matrix3d second = rotation * solid.second * rotation.transpose();
    EXPECT_NEAR((stone.moments.second - second).norm(), 0, tolerance * second.norm());
}

class KnownSolids : public ::testing::TestWithParam<KnownSolid (*)()>
{
};

TEST_P(KnownSolids, AsTheyAre)
{
    expect_known(GetParam()(), Matrix3d::Identity(), Vector3d::Zero(), 1e-14);
}

TEST_P(KnownSolids, Rotated)
{
    const Matrix3d rotation = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    expect_known(GetParam()(), rotation, {0.1, -0.2, 0.3}, 1e-14);
}

TEST_P(KnownSolids, RotatedAndFarAway)
{
    const Matrix3d rotation = Eigen::AngleAxisd(2.1, Vector3d(-1, 1, 3).normalized()).toRotationMatrix();
    expect_known(GetParam()(), rotation, {1e6, -1e6, 800.5}, 2e-9);  // a double at 1e6 m keeps 1e-10 m
}

INSTANTIATE_TEST_SUITE_P(Each, KnownSolids,
                         ::testing::Values(known_box, known_tetrahedron, known_drum, known_voussoir));

TEST(ImportMeshes, ChoosesAnOriginOnlyForLargeCoordinates)
{
    const TemporaryFolder folder;
    const auto near = folder.write("near.obj", mesh::to_obj({box({0, 0, 0}, {9000, 1, 1})}, {}));
    EXPECT_EQ(helper::import_meshes({{.file = near}}).origin, Vector3d::Zero());
    const auto far =
        folder.write("far.obj", mesh::to_obj({box({5e5, 4.6e6, 800}, {5e5 + 2, 4.6e6 + 2, 802})}, {}));
    EXPECT_EQ(helper::import_meshes({{.file = far}}).origin, Vector3d(500001, 4600001, 801));
}

TEST(ImportMeshes, AppliesUnitAndUpAxisWithoutMirroring)
{
    const TemporaryFolder folder;
    const auto file = folder.write("mm.obj", mesh::to_obj({box({0, 0, 0}, {1000, 2000, 3000})}, {}));
    const helper::Stone y_up = helper::import_meshes({{file, 0.001, 'y'}}).meshes[0].stones[0];
    EXPECT_NEAR((y_up.moments.centroid - Vector3d(0.5, -1.5, 1)).norm(), 0, 1e-15);
    EXPECT_NEAR(y_up.moments.volume, 6, 1e-14);
    EXPECT_TRUE(y_up.repairs.empty());
    const helper::Stone x_up = helper::import_meshes({{file, 0.001, 'x'}}).meshes[0].stones[0];
    EXPECT_NEAR((x_up.moments.centroid - Vector3d(1, 1.5, 0.5)).norm(), 0, 1e-15);
    EXPECT_TRUE(x_up.repairs.empty());
    EXPECT_FALSE(helper::import_meshes({{file, -1, 'z'}}).meshes[0].accepted);
    EXPECT_FALSE(helper::import_meshes({{file, 1, 'w'}}).meshes[0].accepted);
}

TEST(ImportMeshes, KeepsAStoneFarFromTheOrigin)
{
    const TemporaryFolder folder;
    std::string text = "OFF\n8 6 0\n";
    for (const Vector3d& x : unit_cube().vertices)
        text += std::to_string(x.x() + 4.6e6) + " " + std::to_string(x.y()) + " " + std::to_string(x.z()) + "\n";
    for (const std::vector<int>& face : unit_cube().faces) {
        text += "4";
        for (const int v : face) text += " " + std::to_string(v);
        text += "\n";
    }
    const helper::ImportedMesh mesh = helper::import_meshes({{.file = folder.write("grid.off", text)}}).meshes[0];
    ASSERT_TRUE(mesh.accepted) << mesh.reason;
    EXPECT_DOUBLE_EQ(mesh.stones[0].moments.volume, 1);
}

}  // namespace
}  // namespace voussoir::importers
