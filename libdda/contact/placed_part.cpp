#include "libdda/contact/placed_part.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cstdint>

#include "libdda/model/parallel.h"

namespace voussoir::contact
{

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace
{

void place_normals(PlacedPart& placed)
{
    const std::vector<std::vector<int>>& faces = placed.shape->faces;
    placed.normals.resize(faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const std::vector<int>& loop = faces[f];
        Vector3d sum = Vector3d::Zero();
        for (std::size_t i = 1; i + 1 < loop.size(); ++i)
            sum += (placed.vertices[loop[i]] - placed.vertices[loop[0]])
                       .cross(placed.vertices[loop[i + 1]] - placed.vertices[loop[0]]);
        placed.normals[f] = sum.normalized();
    }
}

void place_normals(PlacedOutline& placed)
{
    const std::size_t count = placed.vertices.size();
    placed.normals.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Vector2d along = placed.vertices[(i + 1) % count] - placed.vertices[i];
        placed.normals[i] = Vector2d(along.y(), -along.x()).normalized();
    }
}

/// To the last bit.
template <int D>
bool is_same(const PoseIn<D>& a, const PoseIn<D>& b)
{
    const auto same = [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    };
    return std::equal(a.centroid.data(), a.centroid.data() + D, b.centroid.data(), same) &&
           std::equal(a.map.data(), a.map.data() + D * D, b.map.data(), same);
}

}  // namespace

template <int D>
void place_parts(const Model& model, const State& state, int threads, std::vector<PlacedPartIn<D>>& parts)
{
    std::size_t count = 0;
    const auto place_next = [&](int block, int part, const typename ShapeIn<D>::Type& shape) {
        if (count == parts.size()) parts.emplace_back();
        PlacedPartIn<D>& placed = parts[count++];
        if (placed.shape == &shape && placed.block == block && placed.part == part) return;  // known already
        placed.vertices.clear();
        placed.block = block;
        placed.part = part;
        placed.shape = &shape;
        placed.size = size_of(model, block);
    };
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        const auto& shapes = ShapeIn<D>::of(model.blocks[b]);
        for (int p = 0; p < static_cast<int>(shapes.size()); ++p) place_next(b, p, shapes[p]);
    }
    parts.resize(count);
    in_parallel(count, threads, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            PlacedPartIn<D>& placed = parts[i];
            const PoseIn<D> pose = pose_in<D>(model.kinematics, state, placed.block);
            if (!placed.vertices.empty() && is_same(placed.pose, pose)) continue;
            const auto& vertices = placed.shape->vertices;
            placed.vertices.resize(vertices.size());
            for (std::size_t v = 0; v < vertices.size(); ++v)
                placed.vertices[v] = pose.centroid + pose.map * vertices[v];
            placed.lower = placed.upper = placed.vertices.front();
            for (const VectorIn<D>& x : placed.vertices) {
                placed.lower = placed.lower.cwiseMin(x);
                placed.upper = placed.upper.cwiseMax(x);
            }
            place_normals(placed);
            placed.pose = pose;
        }
    });
}

double face_measure(const PlacedPart& part, int face)
{
    const std::vector<int>& loop = part.shape->faces[face];
    double twice = 0;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        twice += part.normals[face].dot((part.vertices[loop[i]] - part.vertices[loop[0]])
                                            .cross(part.vertices[loop[i + 1]] - part.vertices[loop[0]]));
    return twice / 2;
}

double face_measure(const PlacedOutline& part, int edge)
{
    return (part.vertices[(edge + 1) % part.vertices.size()] - part.vertices[edge]).norm();
}

template void place_parts(const Model&, const State&, int, std::vector<PlacedPart>&);
template void place_parts(const Model&, const State&, int, std::vector<PlacedOutline>&);

}  // namespace voussoir::contact
