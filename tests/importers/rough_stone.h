// Stones as a scanner gives them.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "tests/importers/shapes.h"

namespace voussoir::importers
{

/// An ellipsoid with dents and bumps and a rough skin, in triangles; it stands on its flattened underside.
/// @param levels of subdivision: 8 times 4^levels triangles @param roughness of the skin [m]
inline mesh::PolygonSurface rough_stone(int levels, double roughness = 2e-3, unsigned seed = 1)
{
    mesh::PolygonSurface surface{"boulder", {}, {}};
    surface.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    surface.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middles;
        std::vector<std::vector<int>> finer;
        const auto middle = [&](int a, int b) {
            const auto [entry, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<int>(surface.vertices.size()));
            if (is_new) {
                const Eigen::Vector3d x = (surface.vertices[a] + surface.vertices[b]).normalized();
                surface.vertices.push_back(x);
            }
            return entry->second;
        };
        for (const std::vector<int>& f : surface.faces) {
            const int ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
            finer.insert(finer.end(), {{f[0], ab, ca}, {ab, f[1], bc}, {ca, bc, f[2]}, {ab, bc, ca}});
        }
        surface.faces = std::move(finer);
    }
    std::mt19937 random(seed);
    for (Eigen::Vector3d& x : surface.vertices) {
        const double dents =
            0.06 * std::sin(4 * x.x() + 1) * std::cos(3 * x.y()) + 0.05 * std::sin(5 * x.z() + x.y());
        const double skin = roughness * (static_cast<double>(random()) / 4294967296.0 - 0.5);
        x = (1 + dents + 2 * skin) * Eigen::Vector3d(0.35 * x.x(), 0.25 * x.y(), 0.3 * x.z());
        x.z() = std::max(x.z(), -0.2 + 0.05 * skin / (roughness > 0 ? roughness : 1));
    }
    return surface;
}

inline mesh::PolygonSurface inside_out(mesh::PolygonSurface surface)
{
    for (std::vector<int>& face : surface.faces) std::swap(face[1], face[2]);
    return surface;
}

}  // namespace voussoir::importers
