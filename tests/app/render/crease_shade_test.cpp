// The shade of creases: dark where it is hollow, nothing where it is flat, however it is seen.
#include "app/render/crease_shade.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <functional>
#include <numbers>

namespace voussoir::app::render
{
namespace
{

using Eigen::Vector3d;

constexpr int width = 320, height = 200;  // pixels
constexpr double reach = 16;              // pixels

/// Along a ray from `eye` the first place of what stands there, as a share of the ray; over 1: nothing.
using Hit = std::function<double(const Vector3d& eye, const Vector3d& ray)>;

/// Where a ray crosses the plane normal to an axis, if it is `inside` there.
double crossing(const Vector3d& eye, const Vector3d& ray, int axis, double at,
                const std::function<bool(const Vector3d&)>& inside)
{
    const double share = (at - eye[axis]) / ray[axis];
    return share > 0 && inside(eye + share * ray) ? share : 2;
}

Camera camera_at(double elevation_in_degrees, bool orthographic)
{
    const double elevation = elevation_in_degrees * std::numbers::pi / 180;
    const Vector3d back(0, -std::cos(elevation), std::sin(elevation));
    const std::vector<Vector3d> points = {{-2, -2, -1}, {2, 2, 3}};
    const double aspect = static_cast<double>(width) / height;
    return orthographic ? parallel_camera(points, {}, aspect, back) : camera_from(points, {}, aspect, back);
}

/// What the rasteriser would have told.
Depths depths_of(const Hit& hit, const Camera& camera)
{
    Depths depths{width / 2, height / 2, {}};
    const Eigen::Matrix4d back = camera.view_projection.inverse();
    for (int y = 0; y < depths.height; ++y)
        for (int x = 0; x < depths.width; ++x) {
            const double across = 2 * (x + 0.5) / depths.width - 1, up = 1 - 2 * (y + 0.5) / depths.height;
            const Vector3d eye = (back * Eigen::Vector4d(across, up, -1, 1)).hnormalized(),
                           end = (back * Eigen::Vector4d(across, up, 1, 1)).hnormalized();
            const double share = hit(eye, end - eye);
            const Vector3d clip =
                (camera.view_projection * Vector3d(eye + share * (end - eye)).homogeneous()).hnormalized();
            depths.values.push_back(share <= 1 ? static_cast<float>((clip.z() + 1) / 2) : 1.0F);
        }
    return depths;
}

double ground(const Vector3d& eye, const Vector3d& ray)
{
    return crossing(eye, ray, 2, 0, [](const Vector3d& p) { return p.head<2>().cwiseAbs().maxCoeff() < 2; });
}

/// A wall along x that stands on the ground, and nothing behind it.
double wall_on_ground(const Vector3d& eye, const Vector3d& ray)
{
    const double before_it = crossing(eye, ray, 2, 0, [](const Vector3d& p) { return p.y() <= 0 && p.y() > -2; });
    return std::min(before_it,
                    crossing(eye, ray, 1, 0, [](const Vector3d& p) { return p.z() >= 0 && p.z() < 3; }));
}

/// Light along the middle of the picture, from its top.
std::vector<float> middle_of(const Shade& shade)
{
    std::vector<float> light;
    light.reserve(static_cast<std::size_t>(shade.height));
    for (int y = 0; y < shade.height; ++y)
        light.push_back(shade.light[static_cast<std::size_t>(y) * shade.width + shade.width / 2]);
    return light;
}

TEST(CreaseShade, FlatFacesStayAsBrightAsTheyAre)
{
    for (const bool orthographic : {false, true})
        for (const double elevation : {80.0, 30.0, 8.0}) {
            const Camera camera = camera_at(elevation, orthographic);
            const Shade shade = crease_shade(depths_of(ground, camera), camera, reach);
            EXPECT_GT(*std::min_element(shade.light.begin(), shade.light.end()), 0.99F) << elevation;
        }
}

TEST(CreaseShade, FootOfAWallIsDarkestAndTheShadeEndsWithinItsReach)
{
    for (const bool orthographic : {false, true})
        for (const double elevation : {60.0, 30.0, 12.0}) {
            const Camera camera = camera_at(elevation, orthographic);
            const std::vector<float> light =
                middle_of(crease_shade(depths_of(wall_on_ground, camera), camera, reach));
            const Vector3d foot = (camera.view_projection * Eigen::Vector4d(0, 0, 0, 1)).hnormalized();
            const double row = (1 - foot.y()) / 2 * height / 2;
            const auto darkest = std::min_element(light.begin(), light.end());
            EXPECT_NEAR(static_cast<double>(darkest - light.begin()), row, 1.5) << elevation;
            EXPECT_LT(*darkest, 0.8F) << elevation;
            EXPECT_GT(*darkest, 0.5F) << "colours must still be told from the scale";
            for (std::size_t y = 0; y < light.size(); ++y)
                EXPECT_TRUE(light[y] > 0.99F || std::abs(static_cast<double>(y) - row) <= reach / 2 + 1)
                    << elevation << " row " << y << ": " << light[y];
        }
}

TEST(CreaseShade, EdgesThatStickOutStayBright)
{
    const auto corner = [](const Vector3d& eye, const Vector3d& ray) {  // the top of a wall, and its front
        return std::min(crossing(eye, ray, 2, 0, [](const Vector3d& p) { return p.y() >= 0; }),
                        crossing(eye, ray, 1, 0, [](const Vector3d& p) { return p.z() <= 0; }));
    };
    const Camera camera = camera_at(30, false);
    const std::vector<float> light = middle_of(crease_shade(depths_of(corner, camera), camera, reach));
    EXPECT_GT(*std::min_element(light.begin(), light.end()), 0.995F);
}

TEST(CreaseShade, WhatStandsFarInFrontCastsNothingAndNothingIsAddedToTheBackground)
{
    const auto far_in_front = [](const Vector3d& eye, const Vector3d& ray) {
        return std::min(crossing(eye, ray, 1, 30, [](const Vector3d& p) { return p.x() < 1; }),
                        crossing(eye, ray, 1, 0, [](const Vector3d& p) { return p.x() < 0; }));
    };
    const Camera camera = camera_at(8, false);
    const Depths depths = depths_of(far_in_front, camera);
    EXPECT_EQ(std::count(depths.values.begin(), depths.values.end(), 1.0F) % depths.height, 0);
    const Shade shade = crease_shade(depths, camera, reach);
    EXPECT_GT(*std::min_element(shade.light.begin(), shade.light.end()), 0.995F);
}

TEST(Darken, LeavesMarksAndWhatIsTransparent)
{
    Image image{
        4,
        2,
        {0xFF808080U, 0xFEFF0000U, 0x80404040U, 0x00000000U, 0xFF808080U, 0xFF808080U, 0xFF0000FFU, 0xFF808080U}};
    darken(image, {2, 1, {0.5F, 0.5F}});
    EXPECT_EQ(image.pixels, (std::vector<std::uint32_t>{0xFF404040U, 0xFEFF0000U, 0x80404040U, 0x00000000U,
                                                        0xFF404040U, 0xFF404040U, 0xFF00007FU, 0xFF404040U}));
    Image whole{2, 2, {0xFFFFFFFFU, 0xFF123456U, 0xFF000000U, 0xFFFEDCBAU}};
    const std::vector<std::uint32_t> before = whole.pixels;
    darken(whole, {1, 1, {1}});
    EXPECT_EQ(whole.pixels, before) << "where all the light arrives";
}

}  // namespace
}  // namespace voussoir::app::render
