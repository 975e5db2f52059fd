#include "app/render/camera.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace voussoir::app::render
{

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{

constexpr double degree = std::numbers::pi / 180;
const double half_view = std::tan(8 * degree);  // of the smaller half side at unit distance

/// Unit horizontal direction of the largest extent; x when there is none to speak of.
Vector3d long_axis(const std::vector<Vector3d>& points)
{
    Vector2d mean = Vector2d::Zero();
    for (const Vector3d& p : points) mean += p.head<2>() / static_cast<double>(points.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vector3d& p : points) spread += (p.head<2>() - mean) * (p.head<2>() - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(spread);
    const bool clear = solver.eigenvalues()[1] > 1.2 * solver.eigenvalues()[0];
    Vector2d axis = clear ? Vector2d(solver.eigenvectors().col(1)) : Vector2d(1, 0);
    if (axis.x() + 1e-6 * axis.y() < 0) axis = -axis;
    return {axis.x(), axis.y(), 0};
}

/// Unit direction towards a viewer aside of the longest extent and slightly above.
Vector3d from_aside(const std::vector<Vector3d>& points)
{
    const Vector3d along = long_axis(points), across = Vector3d::UnitZ().cross(along);
    const double azimuth = 25 * degree, elevation = 18 * degree;
    const Vector3d aside = std::cos(azimuth) * -across + std::sin(azimuth) * along;
    return std::cos(elevation) * aside + std::sin(elevation) * Vector3d::UnitZ();
}

struct Bounds {
    Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity());
    Vector2d high = Vector2d::Constant(-std::numeric_limits<double>::infinity());
};

/// Extent on a screen at unit distance of points (camera axes) seen from `eye`.
Bounds screen_bounds(const std::vector<Vector3d>& points, const Vector3d& eye)
{
    Bounds bounds;
    for (const Vector3d& p : points) {
        const Vector3d seen = p - eye;
        const Vector2d place = seen.head<2>() / -seen.z();
        bounds.low = bounds.low.cwiseMin(place);
        bounds.high = bounds.high.cwiseMax(place);
    }
    return bounds;
}

/// Where the camera stands, in its own axes: the points' extents touch `size` (screen at unit distance), centred.
Vector3d place_camera(const std::vector<Vector3d>& points, const Vector2d& size)
{
    Vector3d low = points[0], high = points[0];
    for (const Vector3d& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double extent = std::max((high - low).norm(), 1e-9);
    const double nearest = high.z();
    Vector3d eye = (low + high) / 2;
    eye.z() = nearest + 10 * extent;
    // A fixed-point iteration that halves its error in a few steps; where it overshoots, as in front of a deep box
    // seen straight on, its steps are halved.
    double last = 0, damping = 1;
    for (int i = 0; i < 60; ++i) {
        const Bounds bounds = screen_bounds(points, eye);
        const Vector2d middle = (bounds.low + bounds.high) / 2, found = bounds.high - bounds.low;
        const double distance = eye.z() - (low.z() + high.z()) / 2;
        eye.head<2>() += middle * distance;
        const double excess = found.cwiseQuotient(size).maxCoeff() - 1;
        if (excess * last < 0) damping *= 0.5;
        last = excess;
        eye.z() = std::max(nearest + 0.05 * extent, eye.z() + damping * distance * excess);
    }
    return eye;
}

}  // namespace

Camera camera_for(const std::vector<Vector3d>& points, const PictureArea& area, double aspect, View view)
{
    return camera_from(points, area, aspect,
                       view == View::straight_on ? Vector3d(-Vector3d::UnitY()) : from_aside(points));
}

Camera parallel_camera(const std::vector<Vector3d>& points, const PictureArea& area, double aspect,
                       const Vector3d& back)
{
    Camera camera;
    camera.back = back;
    camera.right = Vector3d::UnitZ().cross(camera.back).normalized();
    camera.up = camera.back.cross(camera.right);
    Eigen::Matrix3d axes;
    axes << camera.right.transpose(), camera.up.transpose(), camera.back.transpose();
    Vector3d low = axes * points[0], high = low;
    for (const Vector3d& p : points) {
        low = low.cwiseMin(axes * p);
        high = high.cwiseMax(axes * p);
    }
    const Vector3d middle = (low + high) / 2, size = (high - low).cwiseMax(1e-9);
    const double share_x = (area.right - area.left) / 2, share_y = (area.top - area.bottom) / 2;
    // metres in half a height of the picture: what is longest in its share of it decides
    const double half = 0.5 * std::max(size.y() / share_y, size.x() / share_x / aspect);
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    const Vector3d scale(1 / (half * aspect), 1 / half, -1 / (0.6 * size.z() + half));
    view.topLeftCorner<3, 3>() = scale.asDiagonal() * axes;
    view.topRightCorner<3, 1>() =
        Vector3d((area.left + area.right) / 2, (area.bottom + area.top) / 2, 0) - scale.cwiseProduct(middle);
    camera.view_projection = view;
    return camera;
}

Camera camera_from(const std::vector<Vector3d>& points, const PictureArea& area, double aspect,
                   const Vector3d& back)
{
    Camera camera;
    camera.back = back;
    camera.right = Vector3d::UnitZ().cross(camera.back).normalized();
    camera.up = camera.back.cross(camera.right);
    Eigen::Matrix3d axes;
    axes << camera.right.transpose(), camera.up.transpose(), camera.back.transpose();
    std::vector<Vector3d> seen;
    seen.reserve(points.size());
    for (const Vector3d& p : points) seen.push_back(axes * p);

    // half sides of the whole picture and of the area at unit distance
    const Vector2d half = aspect >= 1 ? Vector2d(aspect, 1) * half_view : Vector2d(1, 1 / aspect) * half_view;
    const Vector2d share((area.right - area.left) / 2, (area.top - area.bottom) / 2);
    const Vector3d eye = place_camera(seen, 2 * half.cwiseProduct(share));
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const Vector3d& p : seen) {
        nearest = std::min(nearest, eye.z() - p.z());
        farthest = std::max(farthest, eye.z() - p.z());
    }
    const double near = 0.3 * nearest, far = 3 * farthest;
    const double centre_x = (area.left + area.right) / 2, centre_y = (area.bottom + area.top) / 2;
    Eigen::Matrix4d projection = Eigen::Matrix4d::Zero(), placing = Eigen::Matrix4d::Identity();
    projection(0, 0) = 1 / half.x();
    projection(1, 1) = 1 / half.y();
    projection(0, 2) = -centre_x;  // moves the vanishing point into the middle of the area
    projection(1, 2) = -centre_y;
    projection(2, 2) = -(far + near) / (far - near);
    projection(2, 3) = -2 * far * near / (far - near);
    projection(3, 2) = -1;
    placing.topLeftCorner<3, 3>() = axes;
    placing.topRightCorner<3, 1>() = -eye;
    camera.view_projection = projection * placing;
    return camera;
}

}  // namespace voussoir::app::render
