#include "libdda/analysis/block_shifts.h"

#include <algorithm>

namespace voussoir
{

namespace
{

using Eigen::Vector3d;

double farthest_corner(const Block& block, const BlockShift& shift)
{
    double farthest = 0;
    const auto consider = [&](const Vector3d& lever) {
        farthest = std::max(farthest, (shift.centroid + shift.map * lever).norm());
    };
    for (const ConvexPolyhedron& part : block.parts)
        for (const Vector3d& vertex : part.vertices) consider(vertex);
    for (const ConvexPolygon& outline : block.outlines)
        for (const Eigen::Vector2d& vertex : outline.vertices) consider({vertex.x(), 0, vertex.y()});
    return farthest;
}

}  // namespace

std::vector<BlockShift> shifts_between(const Model& model, const std::vector<double>& from,
                                       const std::vector<double>& to)
{
    State before, after;
    before.coordinates = from;
    after.coordinates = to;
    std::vector<BlockShift> shifts(model.blocks.size());
    std::vector<bool> held(shifts.size(), false);
    for (const Foundation& foundation : model.foundations) held[foundation.block] = foundation.fully_held();
    for (int b = 0; b < static_cast<int>(shifts.size()); ++b) {
        if (held[b]) continue;
        const Pose start = pose_of(model.kinematics, before, b), end = pose_of(model.kinematics, after, b);
        shifts[b] = {end.centroid - start.centroid, end.map - start.map, 0};
        shifts[b].farthest = farthest_corner(model.blocks[b], shifts[b]);
    }
    return shifts;
}

double product_of(const Model& model, const std::vector<BlockShift>& one, const std::vector<BlockShift>& other)
{
    double sum = 0;
    for (int b = 0; b < static_cast<int>(one.size()); ++b)
        sum += model.mass(b) * one[b].centroid.dot(other[b].centroid) +
               (one[b].map * model.mass_second(b)).cwiseProduct(other[b].map).sum();
    return sum;
}

double largest_share(const Model& model, const std::vector<BlockShift>& shifts)
{
    double largest = 0;
    for (int b = 0; b < static_cast<int>(shifts.size()); ++b)
        largest = std::max(largest, shifts[b].farthest / size_of(model, b));
    return largest;
}

}  // namespace voussoir
