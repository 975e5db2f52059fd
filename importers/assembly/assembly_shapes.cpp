#include "importers/assembly/assembly_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libdda/geometry/extent.h"

namespace voussoir::importers::assembly
{
namespace
{

using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Vector3d> vertices_of(const AssemblyStone& stone)
{
    std::vector<Vector3d> vertices;
    for (const ConvexPolyhedron& part : stone.parts)
        vertices.insert(vertices.end(), part.vertices.begin(), part.vertices.end());
    return vertices;
}

double diameter_of(const std::vector<Vector3d>& vertices)
{
    double most = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (std::size_t k = i + 1; k < vertices.size(); ++k)
            most = std::max(most, (vertices[i] - vertices[k]).squaredNorm());
    return std::sqrt(most);
}

/// Least extent along the normals of the stone's own faces, and the face it was found on.
void find_least_width(const AssemblyStone& stone, const std::vector<Vector3d>& vertices, SliverStone& sliver)
{
    sliver.width = infinity;
    for (const ConvexPolyhedron& part : stone.parts)
        for (int face = 0; face < static_cast<int>(part.faces.size()); ++face) {
            if (part.is_glued(face)) continue;
            const double width = extent_along(face_normal(part, face), vertices);
            if (width >= sliver.width) continue;
            sliver.width = width;
            sliver.marks = {{}};
            for (const int v : part.faces[face]) sliver.marks.front().push_back(part.vertices[v]);
        }
}

void find_shortest_edge(const AssemblyStone& stone, SliverStone& sliver)
{
    std::vector<Vector3d> shortest;
    sliver.shortest_edge = infinity;
    for (const ConvexPolyhedron& part : stone.parts)
        for (const ConvexPolyhedron::Edge& edge : part.edges) {
            const double length = (part.vertices[edge.to] - part.vertices[edge.from]).norm();
            if (part.is_glued(edge) || length >= sliver.shortest_edge) continue;
            sliver.shortest_edge = length;
            shortest = {part.vertices[edge.from], part.vertices[edge.to]};
        }
    if (!sliver.thin) sliver.marks = {shortest};
}

void judge_slivers(Assembly& assembly)
{
    for (int i = 0; i < static_cast<int>(assembly.stones.size()); ++i) {
        const AssemblyStone& stone = assembly.stones[i];
        if (stone.endless) continue;
        const std::vector<Vector3d> vertices = vertices_of(stone);
        SliverStone sliver;
        sliver.stone = i;
        sliver.diameter = diameter_of(vertices);
        find_least_width(stone, vertices, sliver);
        sliver.thin = sliver.width < assembly_tolerance::thin * sliver.diameter;
        find_shortest_edge(stone, sliver);
        if (sliver.thin || sliver.shortest_edge < assembly_tolerance::short_edge * sliver.diameter)
            assembly.slivers.push_back(std::move(sliver));
    }
}

void judge_sizes(Assembly& assembly)
{
    Vector3d lower = Vector3d::Constant(infinity), upper = -lower;
    std::vector<double> sizes;
    for (int i = 0; i < static_cast<int>(assembly.stones.size()); ++i) {
        const AssemblyStone& stone = assembly.stones[i];
        for (const Vector3d& x : vertices_of(stone)) {
            lower = lower.cwiseMin(x);
            upper = upper.cwiseMax(x);
        }
        sizes.push_back(std::cbrt(stone.volume));
        if (stone.foundation || stone.endless) continue;  // ground may be as large as it likes
        if (assembly.largest < 0 || stone.volume > assembly.stones[assembly.largest].volume) assembly.largest = i;
        if (assembly.smallest < 0 || stone.volume < assembly.stones[assembly.smallest].volume)
            assembly.smallest = i;
    }
    if (sizes.empty()) return;
    assembly.extent = upper - lower;
    std::nth_element(sizes.begin(), sizes.begin() + sizes.size() / 2, sizes.end());
    assembly.typical_size = sizes[sizes.size() / 2];
    if (assembly.largest >= 0)
        assembly.size_ratio = assembly.stones[assembly.largest].volume / assembly.stones[assembly.smallest].volume;
}

}  // namespace

void judge_shapes(Assembly& assembly)
{
    judge_slivers(assembly);
    judge_sizes(assembly);
}

}  // namespace voussoir::importers::assembly
