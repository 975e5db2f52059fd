#include "importers/exact/repairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "importers/exact/shell.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;
using Loop = std::vector<int>;

namespace
{

constexpr std::size_t max_open_edges = 4000;  // every one is compared with every other: more are a heap, no joints

/// Puts `middle` between two neighbouring corners of the one other face that has them. @returns false if none has
bool insert_between(std::vector<Loop>& faces, std::size_t except, int a, int b, int middle)
{
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (f == except) continue;
        Loop& loop = faces[f];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int from = loop[i], to = loop[(i + 1) % loop.size()];
            if (std::minmax(from, to) != std::minmax(a, b)) continue;
            loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
            return true;
        }
    }
    return false;
}

}  // namespace

int drop_repeated_faces(mesh::PolygonSurface& surface)
{
    std::set<Loop> seen;
    const std::size_t before = surface.faces.size();
    std::erase_if(surface.faces, [&](const Loop& face) {
        Loop corners = face;
        std::sort(corners.begin(), corners.end());
        return !seen.insert(corners).second;
    });
    return static_cast<int>(before - surface.faces.size());
}

std::vector<int> drop_collinear_triangles(mesh::PolygonSurface& surface, const std::vector<int>& faces)
{
    std::vector<int> dropped;
    for (const int f : faces) {
        const Loop loop = surface.faces[f];
        if (loop.size() != 3) continue;
        int longest = 0;  // the side from corner k to k + 1
        const auto length = [&](int k) {
            return (surface.vertices[loop[(k + 1) % 3]] - surface.vertices[loop[k]]).norm();
        };
        for (int k = 1; k < 3; ++k)
            if (length(k) > length(longest)) longest = k;
        const int from = loop[longest], to = loop[(longest + 1) % 3], middle = loop[(longest + 2) % 3];
        if (insert_between(surface.faces, f, from, to, middle)) dropped.push_back(f);
    }
    std::sort(dropped.rbegin(), dropped.rend());
    for (const int f : dropped) surface.faces.erase(surface.faces.begin() + f);
    return dropped;
}

int insert_corners_on_open_edges(mesh::PolygonSurface& surface, double tolerance)
{
    const std::vector<std::pair<int, int>> open = edge_use(surface).open;
    if (open.size() > max_open_edges) return 0;
    std::set<int> ends;
    for (const auto& [a, b] : open) ends.insert({a, b});
    std::map<std::pair<int, int>, std::vector<std::pair<double, int>>> inserts;  // by share of the way along
    for (const auto& edge : open) {
        const Vector3d &from = surface.vertices[edge.first], &to = surface.vertices[edge.second];
        const double length = (to - from).norm();
        const Vector3d along = (to - from) / length;
        for (const int v : ends) {
            if (v == edge.first || v == edge.second) continue;
            const Vector3d arm = surface.vertices[v] - from;
            const double at = along.dot(arm);
            if (at <= tolerance || at >= length - tolerance || (arm - at * along).norm() > tolerance) continue;
            inserts[edge].emplace_back(at, v);
        }
        if (const auto found = inserts.find(edge); found != inserts.end())
            std::sort(found->second.begin(), found->second.end());
    }
    int count = 0;
    for (Loop& face : surface.faces) {
        Loop refined;
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int from = face[i], to = face[(i + 1) % face.size()];
            refined.push_back(from);
            const auto found = inserts.find(std::minmax(from, to));
            if (found == inserts.end()) continue;
            for (const auto& [at, v] : found->second) refined.push_back(v);
            if (from > to)
                std::reverse(refined.end() - static_cast<std::ptrdiff_t>(found->second.size()), refined.end());
            count += static_cast<int>(found->second.size());
        }
        face = std::move(refined);
    }
    return count;
}

}  // namespace voussoir::importers::exact
