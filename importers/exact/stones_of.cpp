#include "importers/exact/stones_of.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "importers/exact/shell.h"
#include "importers/exact/surface_checks.h"
#include "importers/exact/triangle_surface.h"
#include "importers/exact/weld.h"

namespace voussoir::importers::exact
{

using Eigen::Vector3d;

namespace
{

bool is_closed(const mesh::PolygonSurface& surface)
{
    const EdgeUse use = edge_use(surface);
    return use.open.empty() && use.branching.empty();
}

struct Box {
    Vector3d lower = Vector3d::Constant(1e300), upper = Vector3d::Constant(-1e300);
    explicit Box(const mesh::PolygonSurface& surface)
    {
        for (const Vector3d& x : surface.vertices) {
            lower = lower.cwiseMin(x);
            upper = upper.cwiseMax(x);
        }
    }
    bool holds(const Box& other) const
    {
        return (lower.array() < other.lower.array()).all() && (upper.array() > other.upper.array()).all();
    }
};

/// Puts shells that lie inside a stone into it, as its cavities; a stone inside a cavity stays a stone of its own.
/// @returns how many cavities there are
int join_cavities(std::vector<mesh::PolygonSurface>& shells)
{
    const std::vector<Box> boxes(shells.begin(), shells.end());
    std::vector<std::vector<std::size_t>> hosts(shells.size());  // how deep a shell is, is how many hold it
    for (std::size_t i = 0; i < shells.size(); ++i)
        for (std::size_t o = 0; o < shells.size(); ++o)
            if (o != i && boxes[o].holds(boxes[i]) && lies_inside(shells[i], shells[o])) hosts[i].push_back(o);
    int count = 0;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        if (hosts[i].size() % 2 == 0) continue;
        const std::size_t innermost =
            *std::max_element(hosts[i].begin(), hosts[i].end(),
                              [&](std::size_t a, std::size_t b) { return hosts[a].size() < hosts[b].size(); });
        mesh::PolygonSurface& host = shells[innermost];
        const int first = static_cast<int>(host.vertices.size());
        host.vertices.insert(host.vertices.end(), shells[i].vertices.begin(), shells[i].vertices.end());
        for (std::vector<int> face : shells[i].faces) {
            for (int& v : face) v += first;
            host.faces.push_back(std::move(face));
        }
        shells[i].faces.clear();
        ++count;
    }
    std::erase_if(shells, [](const mesh::PolygonSurface& shell) { return shell.faces.empty(); });
    return count;
}

}  // namespace

std::vector<mesh::PolygonSurface> shells_of(const mesh::PolygonSurface& surface)
{
    const std::vector<int> shell = shell_of_faces(surface);
    const int count = shell.empty() ? 0 : *std::max_element(shell.begin(), shell.end()) + 1;
    // One pass per shell would be quadratic for a survey of thousands of stones in one object.
    std::vector<mesh::PolygonSurface> parts(count, mesh::PolygonSurface{surface.name, {}, {}});
    std::vector<std::map<int, int>> local(count);
    for (std::size_t f = 0; f < surface.faces.size(); ++f) {
        mesh::PolygonSurface& part = parts[shell[f]];
        std::vector<int> loop;
        for (const int v : surface.faces[f]) {
            const auto [entry, is_new] = local[shell[f]].emplace(v, static_cast<int>(part.vertices.size()));
            if (is_new) part.vertices.push_back(surface.vertices[v]);
            loop.push_back(entry->second);
        }
        part.faces.push_back(std::move(loop));
    }
    return parts;
}

bool lies_inside(const mesh::PolygonSurface& shell, const mesh::PolygonSurface& host)
{
    mesh::PolygonSurface oriented = host;
    if (!edge_use(host).clashing.empty() && !orient_consistently(oriented)) return false;
    // A vertex on the host's surface has a share of a turn only: a stone that sits in a notch is not inside.
    const std::size_t stride = std::max<std::size_t>(1, shell.vertices.size() / 24);
    for (std::size_t v = 0; v < shell.vertices.size(); v += stride)
        if (std::abs(winding_number(oriented, shell.vertices[v])) < 0.99) return false;
    return true;
}

SeparatedStones separate_stones(mesh::PolygonSurface surface, double weld_tolerance)
{
    SeparatedStones result;
    std::vector<mesh::PolygonSurface> shells = shells_of(surface);  // by the file's own vertices
    const auto all_closed = [&] { return std::all_of(shells.begin(), shells.end(), is_closed); };
    if (!all_closed()) {
        mesh::PolygonSurface welded = surface;
        weld(welded, 0);
        shells = shells_of(welded);
        if (!all_closed()) {
            weld(welded, weld_tolerance * diagonal_of(welded.vertices));
            shells = shells_of(welded);
        }
    }
    const auto closed = std::count_if(shells.begin(), shells.end(), is_closed);
    if (closed < 2) {
        result.stones.push_back(std::move(surface));
        return result;
    }
    const int cavities = join_cavities(shells);
    if (cavities > 0)
        result.repairs.push_back({"cavities",
                                  "\"" + surface.name + "\": " + std::to_string(cavities) +
                                      " closed surfaces inside others were taken as cavities",
                                  cavities, "cavities"});
    if (shells.size() == 1) {
        result.stones.push_back(std::move(surface));
        return result;
    }
    for (std::size_t i = 0; i < shells.size(); ++i) shells[i].name = surface.name + "." + std::to_string(i + 1);
    result.repairs.push_back({"taken apart into stones",
                              "\"" + surface.name + "\" consists of " + std::to_string(shells.size()) +
                                  " separate surfaces, which became stones of their own, \"" +
                                  shells.front().name + "\" and so on",
                              static_cast<int>(shells.size()), "stones"});
    result.stones = std::move(shells);
    return result;
}

}  // namespace voussoir::importers::exact
