#include "app/reader/overlaps.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "libdda/geometry/box_tree.h"
#include "libdda/geometry/plane.h"

namespace voussoir::app::reader
{
namespace
{

struct Interval {
    double lower = std::numeric_limits<double>::infinity(), upper = -std::numeric_limits<double>::infinity();
};

template <int D>
Interval extent(const std::vector<VectorIn<D>>& vertices, const VectorIn<D>& axis)
{
    Interval interval;
    for (const VectorIn<D>& vertex : vertices) {
        interval.lower = std::min(interval.lower, axis.dot(vertex));
        interval.upper = std::max(interval.upper, axis.dot(vertex));
    }
    return interval;
}

/// Shift along +-axis that parts the two shapes.
template <int D>
double depth_along(const std::vector<VectorIn<D>>& a, const std::vector<VectorIn<D>>& b, const VectorIn<D>& offset,
                   const VectorIn<D>& axis)
{
    const Interval of_a = extent<D>(a, axis), of_b = extent<D>(b, axis);
    const double shift = axis.dot(offset);
    return std::min(of_a.upper - (of_b.lower + shift), of_b.upper + shift - of_a.lower);
}

std::vector<Eigen::Vector3d> edge_directions(const ConvexPolyhedron& shape)
{
    std::vector<Eigen::Vector3d> directions;
    for (const ConvexPolyhedron::Edge& edge : shape.edges) {
        const Eigen::Vector3d direction = (shape.vertices[edge.to] - shape.vertices[edge.from]).normalized();
        const bool known = std::any_of(directions.begin(), directions.end(), [&](const Eigen::Vector3d& other) {
            return direction.cross(other).norm() < 1e-12;
        });
        if (!known) directions.push_back(direction);
    }
    return directions;
}

Eigen::AlignedBox3d bounds_of(const Block& block)
{
    Eigen::AlignedBox3d bounds;
    for (const ConvexPolyhedron& part : block.parts)
        for (const Eigen::Vector3d& vertex : part.vertices) bounds.extend(block.moments.centroid + vertex);
    for (const ConvexPolygon& outline : block.outlines)
        for (const Eigen::Vector2d& vertex : outline.vertices)
            bounds.extend(block.moments.centroid + to_space(vertex));
    return bounds;
}

double overlap_depth(const Block& a, const Block& b)
{
    const Eigen::Vector3d offset = b.moments.centroid - a.moments.centroid;
    double depth = 0;
    for (const ConvexPolyhedron& part_a : a.parts)
        for (const ConvexPolyhedron& part_b : b.parts)
            depth = std::max(depth, reader::overlap_depth(part_a, part_b, offset));
    for (const ConvexPolygon& outline_a : a.outlines)
        for (const ConvexPolygon& outline_b : b.outlines)
            depth = std::max(depth, reader::overlap_depth(outline_a, outline_b, from_space<2>(offset)));
    return depth;
}

}  // namespace

double overlap_depth(const ConvexPolyhedron& a, const ConvexPolyhedron& b, const Eigen::Vector3d& offset)
{
    double depth = std::numeric_limits<double>::infinity();
    for (const ConvexPolyhedron* shape : {&a, &b})
        for (int face = 0; face < static_cast<int>(shape->faces.size()) && depth > 0; ++face)
            depth = std::min(depth, depth_along<3>(a.vertices, b.vertices, offset, face_normal(*shape, face)));
    if (depth <= 0) return depth;
    const std::vector<Eigen::Vector3d> edges_b = edge_directions(b);
    for (const Eigen::Vector3d& edge_a : edge_directions(a))
        for (const Eigen::Vector3d& edge_b : edges_b) {
            const Eigen::Vector3d axis = edge_a.cross(edge_b);
            if (axis.norm() <= 1e-9) continue;
            depth = std::min(depth, depth_along<3>(a.vertices, b.vertices, offset, axis.normalized()));
        }
    return depth;
}

double overlap_depth(const ConvexPolygon& a, const ConvexPolygon& b, const Eigen::Vector2d& offset)
{
    double depth = std::numeric_limits<double>::infinity();
    for (const ConvexPolygon* shape : {&a, &b})
        for (std::size_t i = 0; i < shape->vertices.size(); ++i) {
            const Eigen::Vector2d side = shape->vertices[(i + 1) % shape->vertices.size()] - shape->vertices[i];
            const Eigen::Vector2d normal = Eigen::Vector2d(side.y(), -side.x()).normalized();
            depth = std::min(depth, depth_along<2>(a.vertices, b.vertices, offset, normal));
        }
    return depth;
}

std::vector<BlockOverlap> find_overlaps(const std::vector<Block>& blocks, std::size_t count)
{
    std::vector<BlockOverlap> overlaps;
    if (blocks.empty()) return overlaps;
    std::vector<Eigen::AlignedBox3d> bounds;
    bounds.reserve(blocks.size());
    for (const Block& block : blocks) bounds.push_back(bounds_of(block));
    const BoxTree tree(std::move(bounds));
    for (int a = 0; a < static_cast<int>(count); ++a)
        for (const int b : tree.neighbours_behind(a)) {
            const double depth = overlap_depth(blocks[a], blocks[b]);
            const double size = std::min(tree[a].diagonal().norm(), tree[b].diagonal().norm());
            if (depth > 1e-6 * size) overlaps.push_back({a, b, depth});
            if (overlaps.size() == max_overlaps) return overlaps;
        }
    return overlaps;
}

}  // namespace voussoir::app::reader
