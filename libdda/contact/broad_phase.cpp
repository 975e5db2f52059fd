#include "libdda/contact/broad_phase.h"

#include <algorithm>
#include <numeric>

namespace voussoir
{

using Eigen::Vector3d;

double PlacedPart::support(const Vector3d& direction) const
{
    double most = direction.dot(vertices.front());
    for (const Vector3d& x : vertices) most = std::max(most, direction.dot(x));
    return most;
}

void place_parts(const Model& model, const State& state, std::vector<PlacedPart>& parts)
{
    std::size_t count = 0;
    for (int b = 0; b < static_cast<int>(model.blocks.size()); ++b) {
        const Pose pose = pose_of(model.kinematics, state, b);
        const Block& block = model.blocks[b];
        for (int p = 0; p < static_cast<int>(block.parts.size()); ++p, ++count) {
            if (count == parts.size()) parts.emplace_back();
            PlacedPart& placed = parts[count];
            const ConvexPolyhedron& shape = block.parts[p];
            placed.block = b;
            placed.part = p;
            placed.shape = &shape;
            placed.size = std::cbrt(block.moments.volume);
            placed.vertices.resize(shape.vertices.size());
            for (std::size_t v = 0; v < shape.vertices.size(); ++v)
                placed.vertices[v] = pose.centroid + pose.map * shape.vertices[v];
            placed.lower = placed.upper = placed.vertices.front();
            for (const Vector3d& x : placed.vertices) {
                placed.lower = placed.lower.cwiseMin(x);
                placed.upper = placed.upper.cwiseMax(x);
            }
            placed.normals.resize(shape.faces.size());
            for (std::size_t f = 0; f < shape.faces.size(); ++f) {
                const std::vector<int>& loop = shape.faces[f];
                Vector3d sum = Vector3d::Zero();
                for (std::size_t i = 1; i + 1 < loop.size(); ++i)
                    sum += (placed.vertices[loop[i]] - placed.vertices[loop[0]])
                               .cross(placed.vertices[loop[i + 1]] - placed.vertices[loop[0]]);
                placed.normals[f] = sum.normalized();
            }
        }
    }
    parts.resize(count);
}

std::vector<std::pair<int, int>> candidate_pairs(const std::vector<PlacedPart>& parts,
                                                 const std::vector<double>& reach,
                                                 const std::vector<bool>& fully_held)
{
    std::vector<std::pair<int, int>> pairs;
    if (parts.empty()) return pairs;
    Vector3d lower = parts.front().lower, upper = parts.front().upper;
    for (const PlacedPart& part : parts) {
        lower = lower.cwiseMin(part.lower);
        upper = upper.cwiseMax(part.upper);
    }
    int axis = 0;
    (upper - lower).maxCoeff(&axis);

    const auto low = [&](int i) { return parts[i].lower[axis] - reach[parts[i].block]; };
    std::vector<int> order(parts.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](int i, int j) { return low(i) < low(j) || (low(i) == low(j) && i < j); });

    for (std::size_t k = 0; k < order.size(); ++k) {
        const PlacedPart& first = parts[order[k]];
        const double high = first.upper[axis] + reach[first.block];
        for (std::size_t m = k + 1; m < order.size() && low(order[m]) <= high; ++m) {
            const PlacedPart& second = parts[order[m]];
            if (first.block == second.block || (fully_held[first.block] && fully_held[second.block])) continue;
            const double grow = reach[first.block] + reach[second.block];
            const bool apart = ((first.lower.array() - grow) > second.upper.array()).any() ||
                               ((second.lower.array() - grow) > first.upper.array()).any();
            if (!apart) pairs.emplace_back(std::min(order[k], order[m]), std::max(order[k], order[m]));
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace voussoir
