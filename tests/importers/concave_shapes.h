// Concave solids with closed forms.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/importers/shapes.h"

namespace voussoir::importers
{

inline mesh::PolygonSurface l_shape()
{
    return prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 1);
}

/// 3 x 2 x 1 m with a notch of 1 x 1.5 m from above (along y).
inline mesh::PolygonSurface u_shape()
{
    return prism({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 0.5}, {1, 0.5}, {1, 2}, {0, 2}}, 0, 1);
}

/// A voussoir with chords for arcs: radii 2 and 3 m, from -30 to 30 degrees in `steps`, 1 m deep, with a square
/// hole of 0.4 m through it along its depth.
inline mesh::PolygonSurface ring_sector_with_hole(int steps = 6)
{
    mesh::PolygonSurface surface{"ring sector", {}, {}};
    std::vector<Eigen::Vector2d> outline, hole{{2.3, -0.2}, {2.7, -0.2}, {2.7, 0.2}, {2.3, 0.2}};
    const auto on = [&](double radius, int i) {
        const double a = std::numbers::pi / 3 * (static_cast<double>(i) / steps - 0.5);
        return Eigen::Vector2d(radius * std::cos(a), radius * std::sin(a));
    };
    for (int i = 0; i <= steps; ++i) outline.push_back(on(3, i));
    for (int i = steps; i >= 0; --i) outline.push_back(on(2, i));
    const int n = static_cast<int>(outline.size());
    for (const double z : {0., 1.}) {
        for (const Eigen::Vector2d& p : outline) surface.vertices.emplace_back(p.x(), p.y(), z);
        for (const Eigen::Vector2d& p : hole) surface.vertices.emplace_back(p.x(), p.y(), z);
    }
    const int top = n + 4;
    const auto wall = [&](int a, int b) { surface.faces.push_back({a, b, top + b, top + a}); };
    for (int i = 0; i < n; ++i) wall(i, (i + 1) % n);
    for (int i = 0; i < 4; ++i) wall(n + (i + 1) % 4, n + i);
    // The flat ends have a hole each: two pieces that meet on a line through the hole.
    const int outer = steps / 2, middle = steps + 1 + (steps - steps / 2);  // outer and inner point at 0 degrees
    std::vector<int> lower{n + 0}, upper{n + 3};
    for (int i = middle; i < n; ++i) lower.push_back(i);
    for (int i = 0; i <= outer; ++i) lower.push_back(i);
    lower.push_back(n + 1);
    upper.push_back(n + 2);
    for (int i = outer; i <= middle; ++i) upper.push_back(i);
    // The lines from the hole to the middle points are slanted alike in both pieces: corners 0, 3 and 1, 2 of the
    // hole are joined to the same outline points by triangles.
    const std::vector<int> left{n + 0, n + 3, middle}, right{n + 2, n + 1, outer};
    for (std::vector<int> face : {lower, upper, left, right}) {
        std::vector<int> roof = face;
        for (int& v : roof) v += top;
        surface.faces.push_back(roof);
        surface.faces.emplace_back(face.rbegin(), face.rend());
    }
    return surface;
}

/// A cube of 1 m with a cubic cavity of 0.4 m in its middle.
inline mesh::PolygonSurface hollow_cube()
{
    mesh::PolygonSurface surface = unit_cube();
    const mesh::PolygonSurface cavity = box({0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
    surface.vertices.insert(surface.vertices.end(), cavity.vertices.begin(), cavity.vertices.end());
    for (std::vector<int> face : cavity.faces) {
        for (int& v : face) v += 8;
        surface.faces.push_back(face);
    }
    return surface;
}

}  // namespace voussoir::importers
