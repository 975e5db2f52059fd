#include "importers/patterns/stone_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace voussoir::importers::patterns
{

int StoneGrid::corner(const Eigen::Vector3d& x)
{
    std::array<std::int64_t, 3> key{};
    for (int i = 0; i < 3; ++i) key[i] = std::llround(x[i] * 1e9);
    const auto [place, is_new] = numbers_.try_emplace(key, static_cast<int>(corners_.size()));
    if (is_new) {
        corners_.emplace_back(static_cast<double>(key[0]) / 1e9, static_cast<double>(key[1]) / 1e9,
                              static_cast<double>(key[2]) / 1e9);
        held_.push_back(false);
    }
    return place->second;
}

int StoneGrid::foot(int corner, double z)
{
    const int number = this->corner({corners_[corner].x(), corners_[corner].y(), z});
    held_[number] = true;
    return number;
}

int StoneGrid::add_stone(std::string name)
{
    stones_.push_back({std::move(name), {}, {}});
    return static_cast<int>(stones_.size()) - 1;
}

void StoneGrid::add_faces(int stone, const BedLine& lower, const BedLine& upper, Heads heads)
{
    // As for lines that run to the right, the upper one above and the extrados towards the viewer.
    std::vector<std::vector<int>> faces;
    for (std::size_t i = 0; i + 1 < lower.size(); ++i)
        faces.push_back({lower[i].inner, lower[i + 1].inner, lower[i + 1].outer, lower[i].outer});
    for (std::size_t i = 0; i + 1 < upper.size(); ++i)
        faces.push_back({upper[i].inner, upper[i].outer, upper[i + 1].outer, upper[i + 1].inner});
    const std::size_t common = std::min(lower.size(), upper.size());
    const std::size_t more_below = lower.size() - common, more_above = upper.size() - common;
    for (std::size_t i = 0; i < more_below; ++i) {
        faces.push_back({lower[i].outer, lower[i + 1].outer, upper[0].outer});
        faces.push_back({lower[i].inner, upper[0].inner, lower[i + 1].inner});
    }
    for (std::size_t i = 0; i < more_above; ++i) {
        faces.push_back({lower[0].outer, upper[i + 1].outer, upper[i].outer});
        faces.push_back({lower[0].inner, upper[i].inner, upper[i + 1].inner});
    }
    for (std::size_t i = 0; i + 1 < common; ++i) {
        const ThroughEdge &a = lower[more_below + i], &b = lower[more_below + i + 1];
        const ThroughEdge &d = upper[more_above + i], &c = upper[more_above + i + 1];
        faces.push_back({a.outer, b.outer, c.outer, d.outer});
        faces.push_back({a.inner, d.inner, c.inner, b.inner});
    }
    if (heads.first)
        faces.push_back({lower.front().inner, lower.front().outer, upper.front().outer, upper.front().inner});
    if (heads.last)
        faces.push_back({lower.back().inner, upper.back().inner, upper.back().outer, lower.back().outer});
    const Eigen::Vector3d from = corners_[lower.back().inner];
    const Eigen::Vector3d back = corners_[lower.front().inner] - from, up = corners_[upper.back().inner] - from,
                          out = corners_[lower.back().outer] - from;
    if (back.cross(up).dot(out) > 0)
        for (std::vector<int>& face : faces) std::reverse(face.begin(), face.end());
    stones_[stone].faces.insert(stones_[stone].faces.end(), faces.begin(), faces.end());
    add_parts(stones_[stone], lower, upper, heads);
}

bool StoneGrid::is_straight(const BedLine& line) const
{
    const Eigen::Vector3d from = corners_[line.front().inner], way = corners_[line.back().inner] - from;
    for (const ThroughEdge& edge : line)
        if (way.cross(corners_[edge.inner] - from).norm() > 1e-6 * way.squaredNorm()) return false;
    return true;
}

void StoneGrid::add_parts(Stone& stone, const BedLine& lower, const BedLine& upper, Heads heads) const
{
    if (is_straight(lower) && is_straight(upper)) {
        stone.parts.push_back({{lower.front(), lower.back(), upper.front(), upper.back()}, heads});
        return;
    }
    const std::size_t last = std::min(lower.size(), upper.size()) - 1;
    for (std::size_t i = 0; i < last; ++i)
        stone.parts.push_back({{lower[i], lower[i + 1], upper[i], upper[i + 1]},
                               {i == 0 && heads.first, i + 1 == last && heads.last}});
}

void StoneGrid::add_plug(int stone, const BedLine& ring)
{
    Eigen::Vector3d inner = Eigen::Vector3d::Zero(), outer = inner;
    for (const ThroughEdge& edge : ring) {
        inner += corners_[edge.inner] / static_cast<double>(ring.size());
        outer += corners_[edge.outer] / static_cast<double>(ring.size());
    }
    const int below = corner(inner), above = corner(outer);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const ThroughEdge &a = ring[i], &b = ring[(i + 1) % ring.size()];
        stones_[stone].faces.push_back({a.inner, b.inner, b.outer, a.outer});
        stones_[stone].faces.push_back({a.outer, b.outer, above});
        stones_[stone].faces.push_back({b.inner, a.inner, below});
    }
}

std::vector<ConvexPolyhedron> parts_of(const StoneGrid& grid, const StoneGrid::Stone& stone)
{
    std::vector<ConvexPolyhedron> shapes;
    for (const StoneGrid::Part& part : stone.parts) {
        std::vector<Eigen::Vector3d> x;
        for (const ThroughEdge& edge : part.edges)
            x.insert(x.end(), {grid.corners()[edge.inner], grid.corners()[edge.outer]});
        // Below, above, intrados, extrados, the two heads.
        std::vector<std::vector<int>> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 4, 6, 2},
                                            {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}};
        if (volume_of(x, faces) < 0)
            for (std::vector<int>& face : faces) std::reverse(face.begin(), face.end());
        shapes.push_back(make_convex_polyhedron(std::move(x), std::move(faces), stone.name));
        shapes.back().glued = {false, false, false, false, !part.heads.first, !part.heads.last};
    }
    return shapes;
}

double volume_of(const std::vector<Eigen::Vector3d>& corners, const std::vector<std::vector<int>>& faces)
{
    double volume = 0;
    for (const std::vector<int>& face : faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i)
            volume += corners[face[0]].dot(corners[face[i]].cross(corners[face[i + 1]])) / 6;
    return volume;
}

std::string numbered(int number, int last)
{
    const std::string digits = std::to_string(number);
    const std::size_t width = std::max<std::size_t>(2, std::to_string(last).size());
    return std::string(width - std::min(width, digits.size()), '0') + digits;
}

}  // namespace voussoir::importers::patterns
