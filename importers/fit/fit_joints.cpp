#include "importers/fit/fit_joints.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <set>

#include "importers/exact/triangle_surface.h"
#include "importers/fit/choose_joints.h"
#include "importers/fit/move_corners.h"
#include "importers/fit/shared_corners.h"

namespace voussoir::importers::fit
{

using Eigen::Vector3d;

namespace
{

constexpr std::size_t many_faces = 2000;  // a stone of more was scanned: its joints are no planes
// Shares of a stone's size: a corner that would go further for free sides than `far` does not follow them, one
// that had to go further than `farthest` for its joints stays.
constexpr double far = 0.2, farthest = 0.4;

double volume_of(const mesh::PolygonSurface& surface)
{
    double volume = 0;
    const Vector3d origin = surface.vertices.front();
    for (int f = 0; f < static_cast<int>(surface.faces.size()); ++f)
        for (const Eigen::Matrix3d& t : triangles_of(surface, f)) {
            const Eigen::Matrix3d arms = t.colwise() - origin;
            volume += arms.determinant() / 6;
        }
    return volume;
}

/// The stones that take part, and which they are of all.
struct Assembly {
    std::vector<SidedStone> stones;
    std::vector<int> number;
};

Assembly sided(const std::vector<mesh::PolygonSurface*>& surfaces)
{
    Assembly assembly;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const mesh::PolygonSurface* surface = surfaces[i];
        if (surface == nullptr || surface->faces.size() > many_faces) continue;
        assembly.stones.push_back({surface, sides_of(*surface), std::cbrt(volume_of(*surface))});
        assembly.number.push_back(static_cast<int>(i));
    }
    return assembly;
}

double planarity_of(const SidedStone& stone, const FitOptions& options)
{
    return options.planarity * exact::diagonal_of(stone.surface->vertices);
}

/// A stone of the assembly as the fit wants it.
struct Wanted {
    std::map<int, Frame> planes;  // of its sides that were fitted
    std::set<int> facing;         // all sides that face another stone
};

std::vector<Wanted> wanted_of(const std::vector<SidedStone>& stones, const std::vector<Facing>& joints,
                              const SharedShape& shape)
{
    std::vector<Wanted> wanted(stones.size());
    for (const auto& [key, plane] : shape.planes) wanted[key.stone].planes.emplace(key.side, plane);
    for (const Facing& joint : joints) {
        wanted[joint.stone_a].facing.insert(joint.side_a);
        wanted[joint.stone_b].facing.insert(joint.side_b);
    }
    return wanted;
}

/// Whether no vertex lies outside the plane of a side that faces another stone: its hull then stays behind it.
bool is_behind_its_joints(const SidedStone& stone, const std::vector<Vector3d>& vertices, const Wanted& wanted,
                          double tolerance)
{
    for (const int s : wanted.facing) {
        const auto plane = wanted.planes.find(s);
        if (plane == wanted.planes.end() && stone.sides[s].largest_off > tolerance) return false;
        const Frame& frame = plane != wanted.planes.end() ? plane->second : stone.sides[s].plane;
        for (const Vector3d& x : vertices)
            if (frame.height(x) > tolerance) return false;
    }
    return true;
}

/// The stone with its corners moved: its hull where that adds little and nothing at its joints.
mesh::PolygonSurface reshaped(const SidedStone& stone, std::vector<Vector3d> vertices, const Wanted& wanted,
                              const FitOptions& options)
{
    mesh::PolygonSurface moved{stone.surface->name, std::move(vertices), stone.surface->faces};
    if (!is_behind_its_joints(stone, moved.vertices, wanted, planarity_of(stone, options))) return moved;
    const exact::TriangleSurface hull = exact::convex_hull(moved.vertices);
    const double volume = volume_of(moved);
    if (hull.triangles.empty() || !(exact::volume_of(hull) - volume <= options.volume_error * volume))
        return moved;
    mesh::PolygonSurface convex{moved.name, hull.vertices, {}};
    for (const Eigen::Vector3i& t : hull.triangles) convex.faces.push_back({t[0], t[1], t[2]});
    return convex;
}

std::string why_not(double move, double size)
{
    char words[128];
    std::snprintf(words, sizeof words, "a corner would have to move by %.3g m, %.2g %% of its size", move,
                  100 * move / size);
    return words;
}

double largest_move(const SidedStone& stone, const std::vector<Vector3d>& vertices)
{
    double largest = 0;
    for (std::size_t v = 0; v < vertices.size(); ++v)
        largest = std::max(largest, (vertices[v] - stone.surface->vertices[v]).norm());
    return largest;
}

/// The new surface of a stone, if its corners can go where its planes are.
std::optional<mesh::PolygonSurface> fitted(const SidedStone& stone, const std::vector<Vector3d>& shared,
                                           const Wanted& wanted, double farthest_shared, const FitOptions& options,
                                           FittedStone& report)
{
    // Free sides go along as far as corners had to go for the joints, unless that takes one much further.
    const double flat = std::max(planarity_of(stone, options), farthest_shared);
    std::vector<Vector3d> vertices = move_corners(stone, shared, wanted.planes, flat);
    if (largest_move(stone, vertices) > far * stone.size) vertices = shared;
    const double move = largest_move(stone, vertices);
    if (move > farthest * stone.size) {
        report.left = why_not(move, stone.size);
        return std::nullopt;
    }
    mesh::PolygonSurface surface = reshaped(stone, vertices, wanted, options);
    report.largest_move = move;
    for (const auto& [side, plane] : wanted.planes) report.joints.push_back(plane);
    report.fitted = true;
    return surface;
}

JointLimits limits_of(const FitOptions& options)
{
    JointLimits limits;
    limits.planarity = options.planarity;
    limits.flatten = options.how == FitJoints::planar;
    if (limits.flatten) limits.flat_enough = std::numeric_limits<double>::infinity();
    return limits;
}

/// Divides the sides that are no plane when whole; `joints` are then found anew.
void divide_sides(const JointLimits& limits, std::vector<SidedStone>& stones, std::vector<Facing>& joints)
{
    if (split_sides(joints, bent_sides(joints, stones, limits), stones)) joints = find_facing(stones);
    const JointChoice choice = choose_joints(stones, joints, limits);
    std::vector<SideOf> all;
    for (const Facing& joint : choice.joints) all.push_back({joint.stone_a, joint.side_a});
    std::vector<SidedStone> divided = stones;
    if (!split_sides(choice.joints, all, divided)) return;
    const JointChoice choice_divided = choose_joints(divided, find_facing(divided), limits);
    const SharedShape shape = share_corners(stones, choice.joints);
    const SharedShape shape_divided = share_corners(divided, choice_divided.joints);
    if (split_sides(choice.joints, bent_sides(choice.joints, stones, shape, shape_divided), stones))
        joints = find_facing(stones);
}

}  // namespace

Fit fit_joints(const std::vector<mesh::PolygonSurface*>& stones, const FitOptions& options)
{
    Fit fit;
    fit.stones.resize(stones.size());
    if (options.how == FitJoints::as_drawn) return fit;
    const JointLimits limits = limits_of(options);
    Assembly assembly = sided(stones);
    std::vector<Facing> joints = find_facing(assembly.stones);
    const JointChoice drawn = choose_joints(assembly.stones, joints, limits);
    fit.misfit_before = drawn.misfit;
    if (drawn.misfitting() + drawn.left == 0) return fit;
    divide_sides(limits, assembly.stones, joints);
    JointChoice choice = choose_joints(assembly.stones, joints, limits);
    SharedShape shape = share_corners(assembly.stones, choice.joints);
    if (leave_bent_joints(shape, assembly.stones, choice)) shape = share_corners(assembly.stones, choice.joints);
    fit.joints = choice.misfitting();
    fit.left = choice.left;
    const std::vector<Wanted> wanted = wanted_of(assembly.stones, joints, shape);
    std::vector<std::optional<mesh::PolygonSurface>> surfaces(assembly.stones.size());
    double farthest_shared = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        farthest_shared = std::max(farthest_shared, largest_move(assembly.stones[i], shape.vertices[i]));
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (!wanted[i].planes.empty())
            surfaces[i] = fitted(assembly.stones[i], shape.vertices[i], wanted[i], farthest_shared, options,
                                 fit.stones[assembly.number[i]]);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (surfaces[i]) *stones[assembly.number[i]] = std::move(*surfaces[i]);
    for (const auto& [key, misfit] : shape.misfit) fit.misfit_after = std::max(fit.misfit_after, misfit);
    return fit;
}

}  // namespace voussoir::importers::fit
