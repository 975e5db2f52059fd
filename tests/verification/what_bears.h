// Why stones fall, by statics of their drawn shape alone: no force of the engine is asked for.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "libdda/contact/initial_contacts.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"

namespace voussoir::verification
{

/// Signed distance of a point from the convex hull of points in the plan, > 0 outside [m].
inline double outside_hull(const Eigen::Vector2d& x, const std::vector<Eigen::Vector2d>& points)
{
    // Outside if some direction has x beyond all points; the best of the directions across pairs of points.
    double farthest = -INFINITY;
    for (const Eigen::Vector2d& p : points)
        for (const Eigen::Vector2d& q : points) {
            const Eigen::Vector2d along = q - p;
            if (along.norm() < 1e-12) continue;
            const Eigen::Vector2d normal = Eigen::Vector2d(along.y(), -along.x()).normalized();
            double reach = -INFINITY;
            for (const Eigen::Vector2d& r : points) reach = std::max(reach, normal.dot(r));
            farthest = std::max(farthest, normal.dot(x) - reach);
        }
    return farthest;
}

/// Stones that hang together with `stone` by joints, without those that are held.
inline std::vector<bool> loose_group(const Model& model, const ContactSet& contacts, int stone)
{
    std::vector<bool> held(model.blocks.size(), false), group(model.blocks.size(), false);
    for (const Foundation& foundation : model.foundations) held[foundation.block] = true;
    group[stone] = true;
    for (std::size_t round = 0; round < model.blocks.size(); ++round)
        for (const ContactPatch& patch : contacts.patches) {
            if (held[patch.block_a] || held[patch.block_b]) continue;
            if (group[patch.block_a] || group[patch.block_b]) group[patch.block_a] = group[patch.block_b] = true;
        }
    return group;
}

/// In words, why a group of stones cannot rest on the others; empty when statics does not say so.
///
/// A joint whose face looks down on the group bears nothing, and one that stands upright bears by friction only,
/// which needs a force across it that nothing provides. What is left is the support polygon: points of joints that
/// bear from below; the centroid of the group must lie over it, by more than `margin` [m].
inline std::string why_group_falls(const Model& model, const ContactSet& contacts, const std::vector<bool>& group,
                                   double margin = 0)
{
    std::vector<Eigen::Vector2d> polygon;
    bool touches = false;
    for (const ContactPatch& patch : contacts.patches) {
        if (group[patch.block_a] == group[patch.block_b]) continue;
        touches = true;
        const double upward = group[patch.block_a] ? patch.normal.z() : -patch.normal.z();  // on the group
        if (upward < 1e-6) continue;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            polygon.emplace_back(contacts.points[i].position.head<2>());
    }
    if (!touches) return "it touches nothing";
    if (polygon.empty()) return "no joint bears it from below";
    double mass = 0;
    Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
    for (std::size_t b = 0; b < group.size(); ++b) {
        if (!group[b]) continue;
        mass += model.mass(static_cast<int>(b));
        centroid += model.mass(static_cast<int>(b)) * model.blocks[b].moments.centroid.head<2>();
    }
    const double outside = outside_hull(centroid / mass, polygon);
    if (outside < -margin) return "";
    const auto stones = std::count(group.begin(), group.end(), true);
    return fmt::format("the centroid of {} stone{} lies {:.4f} m {} the edge of the support", stones,
                       stones == 1 ? "" : "s", std::abs(outside), outside < 0 ? "inside" : "outside");
}

/// Why a stone by itself slides: the face that bears it falls by more than the angle of friction [rad], and
/// nothing stands in its way there. Empty: statics does not say so.
inline std::string why_it_slides(const Model& model, int stone, double friction_angle)
{
    State state = initial_state(model);
    find_initial_contacts(model, state);
    std::vector<Eigen::Vector3d> faces;  // normals, towards the stone
    for (const ContactPatch& patch : state.contacts.patches) {
        if (patch.block_a != stone && patch.block_b != stone) continue;
        faces.push_back(patch.block_a == stone ? patch.normal : Eigen::Vector3d(-patch.normal));
    }
    const Eigen::Vector3d down(0, 0, -1);
    for (const Eigen::Vector3d& bearing : faces) {
        const double slope = std::acos(std::clamp(bearing.z(), -1.0, 1.0));
        if (bearing.z() < 1e-6 || slope < friction_angle) continue;
        const Eigen::Vector3d way = (down - down.dot(bearing) * bearing).normalized();
        if (std::all_of(faces.begin(), faces.end(), [&](const Eigen::Vector3d& n) { return n.dot(way) > -1e-3; }))
            return fmt::format("it slides down a face of {:.0f} degrees", slope * 180 / std::numbers::pi);
    }
    return "";
}

/// Why a stone that lies on others may topple: its centroid lies outside its support, or inside by less than 1 %
/// of its size, which no survey measures.
inline std::string why_it_topples(const Model& model, int stone)
{
    State state = initial_state(model);
    find_initial_contacts(model, state);
    std::vector<bool> alone(model.blocks.size(), false);
    alone[stone] = true;
    return why_group_falls(model, state.contacts, alone, 0.01 * size_of(model, stone));
}

/// Why a stone falls: by itself, or with all that hangs together with it and is not held. Empty: statics does not
/// say so.
inline std::string why_it_falls(const Model& model, int stone)
{
    State state = initial_state(model);
    find_initial_contacts(model, state);
    std::vector<bool> alone(model.blocks.size(), false);
    alone[stone] = true;
    const std::string by_itself = why_group_falls(model, state.contacts, alone);
    return by_itself.empty() ? why_group_falls(model, state.contacts, loose_group(model, state.contacts, stone))
                             : by_itself;
}

}  // namespace voussoir::verification
