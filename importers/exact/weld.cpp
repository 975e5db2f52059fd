#include "importers/exact/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

using Cell = std::array<std::int64_t, 3>;

/// Finds an earlier vertex near a point: a grid of cells as wide as the tolerance, of which 27 are looked into.
class Neighbourhood
{
 public:
    explicit Neighbourhood(double tolerance) : tolerance_(tolerance) {}

    int find(const Vector3d& x, const std::vector<Vector3d>& kept) const
    {
        int nearest = -1;
        double distance = tolerance_;
        const Cell centre = cell_of(x);
        for (int i = 0; i < 27; ++i) {
            const auto cell =
                cells_.find({centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1});
            if (cell == cells_.end()) continue;
            for (const int v : cell->second)
                if ((kept[v] - x).norm() <= distance) {
                    distance = (kept[v] - x).norm();
                    nearest = v;
                }
        }
        return nearest;
    }

    void insert(const Vector3d& x, int vertex) { cells_[cell_of(x)].push_back(vertex); }

 private:
    Cell cell_of(const Vector3d& x) const
    {
        Cell cell{};
        for (int i = 0; i < 3; ++i) cell[i] = static_cast<std::int64_t>(std::floor(x[i] / tolerance_));
        return cell;
    }

    double tolerance_;
    std::map<Cell, std::vector<int>> cells_;
};

/// For every vertex the kept vertex it becomes. Bit-identical ones are found first, by value.
std::vector<int> representatives(const std::vector<Vector3d>& vertices, double tolerance,
                                 std::vector<Vector3d>& kept, WeldReport& report)
{
    Neighbourhood near(tolerance);
    std::map<std::array<double, 3>, int> same;
    std::vector<int> becomes;
    for (const Vector3d& x : vertices) {
        const auto [entry, is_new] = same.try_emplace({x.x(), x.y(), x.z()}, static_cast<int>(kept.size()));
        if (!is_new) {
            ++report.identical;
        } else if (const int other = tolerance > 0 ? near.find(x - vertices.front(), kept) : -1; other >= 0) {
            ++report.moved;
            report.largest_move = std::max(report.largest_move, (kept[other] + vertices.front() - x).norm());
            entry->second = other;
        } else {
            kept.push_back(x - vertices.front());
            if (tolerance > 0) near.insert(kept.back(), entry->second);
        }
        becomes.push_back(entry->second);
    }
    return becomes;
}

std::vector<int> without_repeats(const std::vector<int>& face, const std::vector<int>& becomes)
{
    std::vector<int> loop;
    for (const int v : face)
        if (loop.empty() || loop.back() != becomes[v]) loop.push_back(becomes[v]);
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return loop;
}

}  // namespace

WeldReport weld(mesh::PolygonSurface& surface, double tolerance)
{
    WeldReport report;
    if (surface.vertices.empty()) return report;
    std::vector<Vector3d> kept;
    const std::vector<int> becomes = representatives(surface.vertices, tolerance, kept, report);
    std::vector<int> original(kept.size(), -1);  // kept positions are relative: take the file's own bits
    for (std::size_t v = 0; v < becomes.size(); ++v)
        if (original[becomes[v]] < 0) original[becomes[v]] = static_cast<int>(v);
    for (std::size_t k = 0; k < kept.size(); ++k) kept[k] = surface.vertices[original[k]];

    std::vector<std::vector<int>> faces;
    for (const std::vector<int>& face : surface.faces) {
        std::vector<int> loop = without_repeats(face, becomes);
        if (loop.size() < 3) {
            ++report.removed_faces;
            continue;
        }
        if (loop.size() < face.size()) ++report.shortened_faces;
        faces.push_back(std::move(loop));
    }
    surface.vertices = std::move(kept);
    surface.faces = std::move(faces);
    drop_unused_vertices(surface);
    return report;
}

void drop_unused_vertices(mesh::PolygonSurface& surface)
{
    std::vector<int> place(surface.vertices.size(), -1);
    for (const std::vector<int>& face : surface.faces)
        for (const int v : face) place[v] = 0;
    std::vector<Vector3d> kept;
    for (std::size_t v = 0; v < place.size(); ++v)
        if (place[v] == 0) {
            place[v] = static_cast<int>(kept.size());
            kept.push_back(surface.vertices[v]);
        }
    for (std::vector<int>& face : surface.faces)
        for (int& v : face) v = place[v];
    surface.vertices = std::move(kept);
}

}  // namespace voussoir::importers::exact
