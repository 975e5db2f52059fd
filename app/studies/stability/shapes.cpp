#include "app/studies/stability/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/studies/stability/engine.h"

namespace voussoir::stability
{

using Eigen::Vector3d;

void run_down(const Model& model, double angle, double friction, double g, double time_step, CellRun& cell)
{
    constexpr double mobilised = 1 - 1e-5;  // a static stage has no answer at the limit itself
    constexpr double duration = 1;          // s
    const double dip = angle * std::numbers::pi / 180;
    Stage rest = rest_stage(), motion = motion_stage(duration, time_step);
    motion.gravity = g * Vector3d(std::sin(dip), 0, -std::cos(dip));
    rest.gravity = motion.gravity;
    rest.gravity.x() = std::min(rest.gravity.x(), mobilised * friction * -rest.gravity.z());
    State state = initial_state(model);
    if (!run_counted(model, {rest}, state, {}, cell)) return;
    state.stage = 0;
    begin_stage(model, 0, state);
    const Vector3d start = pose_of(model.kinematics, state, 1).centroid;
    if (!run_counted(model, {motion}, state, {}, cell)) return;
    const Vector3d moved = pose_of(model.kinematics, state, 1).centroid - start;
    const double exact = std::max(0.0, 0.5 * g * (std::sin(dip) - friction * std::cos(dip)) * duration * duration);
    cell.error = (moved - Vector3d(exact, 0, 0)).norm() / (exact > 0 ? exact : size_of(model, 1));
}

ConvexPolyhedron octahedron(const Vector3d& centre, const Vector3d& radius)
{
    std::vector<Vector3d> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            corners.push_back(centre + sign * radius[axis] * Vector3d::Unit(axis));
    std::vector<std::vector<int>> faces;
    for (const int x : {0, 1})
        for (const int y : {2, 3})
            for (const int z : {4, 5}) {
                const bool even = (x + y + z) % 2 == 0;
                faces.push_back(even ? std::vector<int>{x, y, z} : std::vector<int>{x, z, y});
            }
    return make_convex_polyhedron(std::move(corners), std::move(faces), "octahedron");
}

ConvexPolyhedron needle(const Eigen::Vector2d& place, double tip, double z_tip, double top, double z_top)
{
    std::vector<Vector3d> corners;
    for (const auto& [side, z] : {std::pair{tip, z_tip}, std::pair{top, z_top}})
        for (const Eigen::Vector2d& to :
             {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1), Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1)})
            corners.emplace_back(place.x() + side / 2 * to.x(), place.y() + side / 2 * to.y(), z);
    return make_convex_polyhedron(
        std::move(corners), {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
        "needle");
}

ConvexPolyhedron bar_on_edge(const Vector3d& centre, int axis, double length, double across)
{
    const Vector3d along = Vector3d::Unit(axis), up = Vector3d::UnitZ(), side = up.cross(along);
    std::vector<Vector3d> corners;
    for (const double end : {-length / 2, length / 2})
        for (const auto& [a, b] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{-1, 0}, std::pair{0, -1}})
            corners.push_back(centre + end * along + across / 2 * (a * side + b * up));
    return make_convex_polyhedron(
        std::move(corners), {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
        "bar");
}

}  // namespace voussoir::stability
