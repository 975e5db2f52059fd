// The answer depends on the mesh, and on nothing else: not on where the heap happens to put things.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "importers/exact/certify.h"
#include "tests/importers/concave_shapes.h"
#include "tests/importers/rough_stone.h"

namespace voussoir::importers
{
namespace
{

/// A cube of n x n x n cells with its surface as squares, some of the surface's cells taken out: many flat facets
/// with many needless vertices, many hulls, and ties everywhere.
mesh::PolygonSurface pitted_cube(int n)
{
    mesh::PolygonSurface surface{"pitted", {}, {}};
    const auto is_stone = [&](int x, int y, int z) {
        const bool inside = std::min({x, y, z}) >= 0 && std::max({x, y, z}) < n;
        return inside && !(z == n - 1 && x % 2 == 1 && y % 2 == 1);
    };
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z) {
                if (!is_stone(x, y, z)) continue;
                const Eigen::Vector3d lower(x, y, z);
                const mesh::PolygonSurface cell = box(lower, lower + Eigen::Vector3d::Ones());
                for (const std::vector<int>& face : cell.faces) {
                    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
                    for (const int v : face) middle += cell.vertices[v] / 4;
                    const Eigen::Vector3d next = 2 * middle - (lower + Eigen::Vector3d::Constant(0.5));
                    if (is_stone(static_cast<int>(std::floor(next.x())), static_cast<int>(std::floor(next.y())),
                                 static_cast<int>(std::floor(next.z()))))
                        continue;
                    surface.faces.emplace_back();
                    for (const int v : face) {
                        surface.faces.back().push_back(static_cast<int>(surface.vertices.size()));
                        surface.vertices.push_back(cell.vertices[v]);
                    }
                }
            }
    return surface;
}

/// Blocks of memory with holes between them: what is allocated next lies in another order than before.
std::vector<std::unique_ptr<char[]>> disturb_heap(std::mt19937& random)
{
    std::vector<std::unique_ptr<char[]>> blocks;
    for (int i = 0; i < 20000; ++i) blocks.push_back(std::make_unique<char[]>(16 + random() % 6000));
    std::shuffle(blocks.begin(), blocks.end(), random);
    blocks.resize(blocks.size() / 2);
    return blocks;
}

TEST(SameAnswer, HullsAndPartsDoNotDependOnAddresses)
{
    std::mt19937 random(7);
    const mesh::PolygonSurface surface = pitted_cube(5);
    const exact::TriangleSurface first_hull = exact::convex_hull(surface.vertices);
    EXPECT_EQ(first_hull.vertices.size(), 8U) << "corners only";
    const exact::Certificate first = exact::certify(surface, {.max_parts = 40, .volume_error = 0.03});
    ASSERT_EQ(first.reason, "");
    ASSERT_GT(first.parts.size(), 1U);
    for (int trial = 0; trial < 8; ++trial) {
        const auto blocks = disturb_heap(random);
        const exact::TriangleSurface hull = exact::convex_hull(surface.vertices);
        EXPECT_EQ(hull.vertices, first_hull.vertices);
        EXPECT_EQ(hull.triangles, first_hull.triangles);
        const exact::Certificate again = exact::certify(surface, {.max_parts = 40, .volume_error = 0.03});
        EXPECT_EQ(again.volume_error, first.volume_error);
        ASSERT_EQ(again.parts.size(), first.parts.size());
        for (std::size_t p = 0; p < first.parts.size(); ++p) {
            EXPECT_EQ(again.parts[p].vertices, first.parts[p].vertices);
            EXPECT_EQ(again.parts[p].faces, first.parts[p].faces);
        }
    }
}

TEST(SameAnswer, SimplifiedStonesDoNotDependOnAddresses)
{
    std::mt19937 random(8);
    exact::CertifyOptions options;
    options.simplify = exact::SimplifyOptions{.max_parts = 4, .volume_error = 0.05};
    const mesh::PolygonSurface surface = rough_stone(3);
    const exact::Certificate first = exact::certify(surface, options);
    ASSERT_EQ(first.reason, "");
    for (int trial = 0; trial < 4; ++trial) {
        const auto blocks = disturb_heap(random);
        const exact::Certificate again = exact::certify(surface, options);
        ASSERT_EQ(again.parts.size(), first.parts.size());
        for (std::size_t p = 0; p < first.parts.size(); ++p) {
            EXPECT_EQ(again.parts[p].vertices, first.parts[p].vertices);
            EXPECT_EQ(again.parts[p].glued, first.parts[p].glued);
        }
    }
}

}  // namespace
}  // namespace voussoir::importers
