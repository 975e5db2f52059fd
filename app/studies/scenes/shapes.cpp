#include "app/studies/scenes/shapes.h"

#include <utility>

namespace voussoir::app::studies::scenes
{

using Eigen::Vector3d;

ConvexPolyhedron octahedron(const Vector3d& centre, const Vector3d& radius)
{
    std::vector<Vector3d> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            corners.push_back(centre + sign * radius[axis] * Vector3d::Unit(axis));
    std::vector<std::vector<int>> faces;
    for (const int x : {0, 1})
        for (const int y : {2, 3})
            for (const int z : {4, 5}) {
                const bool even = (x + y + z) % 2 == 0;
                faces.push_back(even ? std::vector<int>{x, y, z} : std::vector<int>{x, z, y});
            }
    return make_convex_polyhedron(std::move(corners), std::move(faces), "octahedron");
}

ConvexPolyhedron needle(const Eigen::Vector2d& place, double tip, double z_tip, double top, double z_top)
{
    std::vector<Vector3d> corners;
    for (const auto& [side, z] : {std::pair{tip, z_tip}, std::pair{top, z_top}})
        for (const Eigen::Vector2d& to :
             {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1), Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1)})
            corners.emplace_back(place.x() + side / 2 * to.x(), place.y() + side / 2 * to.y(), z);
    return make_convex_polyhedron(
        std::move(corners), {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
        "needle");
}

ConvexPolyhedron bar_on_edge(const Vector3d& centre, int axis, double length, double across)
{
    const Vector3d along = Vector3d::Unit(axis), up = Vector3d::UnitZ(), side = up.cross(along);
    std::vector<Vector3d> corners;
    for (const double end : {-length / 2, length / 2})
        for (const auto& [a, b] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{-1, 0}, std::pair{0, -1}})
            corners.push_back(centre + end * along + across / 2 * (a * side + b * up));
    return make_convex_polyhedron(
        std::move(corners), {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
        "bar");
}

ConvexPolyhedron prism(const std::vector<Eigen::Vector2d>& section, double from, double to)
{
    std::vector<Vector3d> vertices;
    for (const double x : {from, to})
        for (const Eigen::Vector2d& corner : section) vertices.emplace_back(x, corner.x(), corner.y());
    const int n = static_cast<int>(section.size());
    std::vector<std::vector<int>> faces(2);
    for (int i = 0; i < n; ++i) {
        faces[0].push_back(n - 1 - i);
        faces[1].push_back(n + i);
        faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    return make_convex_polyhedron(std::move(vertices), std::move(faces), "prism");
}

}  // namespace voussoir::app::studies::scenes
