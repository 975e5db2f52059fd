// Surfaces and files for the tests of this room.
#pragma once

#include <unistd.h>

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "importers/mesh/polygon_surface.h"
#include "tests/temporary_folder.h"

namespace voussoir::importers
{

/// A vertical prism. @param outline (n,2) counter-clockwise seen from above
inline mesh::PolygonSurface prism(const std::vector<Eigen::Vector2d>& outline, double bottom, double top)
{
    mesh::PolygonSurface surface{"stone", {}, {}};
    const int n = static_cast<int>(outline.size());
    for (const double z : {bottom, top})
        for (const Eigen::Vector2d& p : outline) surface.vertices.emplace_back(p.x(), p.y(), z);
    std::vector<int> floor, roof;
    for (int i = 0; i < n; ++i) {
        floor.push_back(n - 1 - i);
        roof.push_back(n + i);
        const int next = (i + 1) % n;
        surface.faces.push_back({i, next, n + next, n + i});
    }
    surface.faces.push_back(floor);
    surface.faces.push_back(roof);
    return surface;
}

inline mesh::PolygonSurface box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper)
{
    return prism({lower.head<2>(), {upper.x(), lower.y()}, upper.head<2>(), {lower.x(), upper.y()}}, lower.z(),
                 upper.z());
}

inline mesh::PolygonSurface unit_cube()
{
    return box({0, 0, 0}, {1, 1, 1});
}

/// Every face as a fan of triangles.
inline mesh::PolygonSurface triangulated(mesh::PolygonSurface surface)
{
    std::vector<std::vector<int>> triangles;
    for (const std::vector<int>& face : surface.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i) triangles.push_back({face[0], face[i], face[i + 1]});
    surface.faces = triangles;
    return surface;
}

}  // namespace voussoir::importers
