// The fields of a state, for Packer and Unpacker.
#pragma once

#include "libdda/model/state.h"

namespace voussoir::app::results
{

/// One list of fields for both directions, so that they cannot disagree.
template <typename Archive, typename Patch>
void patch_fields(Archive& archive, Patch& patch)
{
    archive.field(patch.block_a);
    archive.field(patch.block_b);
    archive.field(patch.part_a);
    archive.field(patch.part_b);
    archive.field(patch.feature_a);
    archive.field(patch.feature_b);
    archive.field(patch.edge_edge);
    archive.field(patch.intact);
    archive.field(patch.stiffness);
    archive.field(patch.bending_energy);
    archive.field(patch.normal);
    archive.field(patch.first_point);
    archive.field(patch.point_count);
}

template <typename Archive, typename Point>
void point_fields(Archive& archive, Point& point)
{
    archive.field(point.feature);
    archive.field(point.status);
    archive.field(point.gap);
    archive.field(point.rest_gap);
    archive.field(point.area);
    archive.field(point.normal_force);
    archive.field(point.position);
    archive.field(point.shear_force);
    archive.field(point.elastic_slip);
    archive.field(point.plastic_slip);
}

template <typename Archive, typename Contacts>
void contact_fields(Archive& archive, Contacts& contacts)
{
    archive.list(contacts.patches, [](auto& to, auto& patch) { patch_fields(to, patch); });
    archive.list(contacts.points, [](auto& to, auto& point) { point_fields(to, point); });
}

template <typename Archive, typename SomeState>
void state_fields(Archive& archive, SomeState& state)
{
    archive.field(state.time);
    archive.field(state.step);
    archive.field(state.stage);
    archive.field(state.stage_time);
    archive.field(state.grid);
    archive.field(state.next_time_step);
    for (auto* list : {&state.coordinates, &state.velocities, &state.foundation_anchors, &state.boundary_reactions,
                       &state.branch_strains, &state.bars})
        archive.list(*list);
    contact_fields(archive, state.contacts);
    contact_fields(archive, state.planar_contacts);
}

}  // namespace voussoir::app::results
