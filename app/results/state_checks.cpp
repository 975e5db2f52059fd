#include "app/results/state_checks.h"

#include <algorithm>
#include <cmath>

#include "app/results/counts.h"
#include "libdda/contact/placed_part.h"

namespace voussoir::app::results
{

namespace
{

template <int D>
bool is_sound(const ContactSetIn<D>& contacts)
{
    const auto has_points = [&](const ContactPatchIn<D>& patch) {
        return patch.first_point >= 0 && patch.point_count >= 0 &&
               static_cast<std::size_t>(patch.first_point) + static_cast<std::size_t>(patch.point_count) <=
                   contacts.points.size();
    };
    const auto has_status = [](const ContactPointIn<D>& point) { return point.status <= ContactStatus::sliding; };
    return std::all_of(contacts.patches.begin(), contacts.patches.end(), has_points) &&
           std::all_of(contacts.points.begin(), contacts.points.end(), has_status);
}

std::size_t faces_of(const ConvexPolyhedron& part)
{
    return part.faces.size();
}

std::size_t faces_of(const ConvexPolygon& part)
{
    return part.vertices.size();
}

template <int D>
bool fits(const ContactSetIn<D>& contacts, const Model& model)
{
    const auto is_side = [&](const ContactPatchIn<D>& patch, int block, int part, std::uint32_t face) {
        if (block < 0 || static_cast<std::size_t>(block) >= model.blocks.size()) return false;
        const auto& parts = contact::ShapeIn<D>::of(model.blocks[block]);
        if (part < 0 || static_cast<std::size_t>(part) >= parts.size()) return false;
        return patch.edge_edge || face < faces_of(parts[part]);
    };
    return std::all_of(contacts.patches.begin(), contacts.patches.end(), [&](const ContactPatchIn<D>& patch) {
        return is_side(patch, patch.block_a, patch.part_a, patch.feature_a) &&
               is_side(patch, patch.block_b, patch.part_b, patch.feature_b);
    });
}

bool are_finite(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

bool is_sound(const State& state)
{
    const bool has_times = std::isfinite(state.time) && std::isfinite(state.stage_time) &&
                           std::isfinite(state.next_time_step) && state.next_time_step >= 0;
    return has_times && is_count(state.step) && is_count(state.stage) && is_count(state.grid) &&
           is_sound(state.contacts) && is_sound(state.planar_contacts);
}

bool fits(const State& state, const Model& model)
{
    const std::size_t blocks = model.blocks.size(),
                      coordinates = blocks * static_cast<std::size_t>(coordinates_per_block(model.kinematics)),
                      velocities = blocks * static_cast<std::size_t>(unknowns_per_block(model.kinematics)),
                      anchors = model.foundations.size() * axes_of(model.kinematics).size(),
                      reactions = initial_state(model).boundary_reactions.size(),
                      branches = initial_state(model).branch_strains.size(),
                      bars = model.bars.size() * (axes_of(model.kinematics).size() + 1);
    return state.coordinates.size() == coordinates && state.velocities.size() == velocities &&
           state.foundation_anchors.size() == anchors && state.boundary_reactions.size() == reactions &&
           state.branch_strains.size() == branches && are_finite(state.branch_strains) &&
           state.bars.size() == bars && are_finite(state.bars) && are_finite(state.boundary_reactions) &&
           are_finite(state.coordinates) && are_finite(state.velocities) && are_finite(state.foundation_anchors) &&
           fits(state.contacts, model) && fits(state.planar_contacts, model);
}

}  // namespace voussoir::app::results
