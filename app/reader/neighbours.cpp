#include <map>

#include "app/reader/block_reading.h"
#include "libdda/contact/initial_contacts.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double least_area = 1e-3;  // of the squared size of the smaller block: less is an edge or a corner

using Areas = std::map<std::pair<int, int>, double>;  // of each pair of blocks, m2

template <int D>
void add_areas(const ContactSetIn<D>& contacts, Areas& areas)
{
    for (const ContactPatchIn<D>& patch : contacts.patches) {
        if (patch.edge_edge) continue;
        double& area = areas[std::minmax(patch.block_a, patch.block_b)];
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            area += contacts.points[i].area;
    }
}

/// The blocks as one group of rigid stones: what else they are does not matter to the contact search.
Model plain(const Model& model)
{
    JointMaterial joint;
    joint.stiffness = {ContactStiffness::Kind::per_area, 1, 1};
    joint.face = FaceLaw::corners;  // outlines are asked for
    Model stones = make_model(is_planar(model.kinematics) ? Kinematics::planar_rigid : Kinematics::spatial_rigid,
                              {"stone", 1, 1, 0}, joint);
    stones.thickness = model.thickness;
    stones.blocks = model.blocks;
    for (Block& block : stones.blocks) block.group = block.material = 0;
    return stones;
}

}  // namespace

std::vector<std::vector<int>> neighbours_of(const Model& model)
{
    const Model stones = plain(model);
    State state = initial_state(stones);
    find_initial_contacts(stones, state);
    Areas areas;
    add_areas(state.contacts, areas);
    add_areas(state.planar_contacts, areas);
    std::vector<std::vector<int>> neighbours(model.blocks.size());
    for (const auto& [pair, area] : areas) {
        const auto& [a, b] = pair;
        const double size = std::min(size_of(stones, a), size_of(stones, b));
        if (area < least_area * size * (is_planar(model.kinematics) ? model.thickness : size)) continue;
        neighbours[a].push_back(b);
        neighbours[b].push_back(a);
    }
    return neighbours;
}

}  // namespace voussoir::app::reader
