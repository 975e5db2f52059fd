#include "libdda/analysis/ground.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "libdda/analysis/material_point.h"

namespace voussoir
{

using Eigen::Vector3d;

namespace
{

void add_ends(const Model& model, std::vector<int>& blocks)
{
    for (const ViscousBoundary& boundary : model.boundaries)
        for (const BlockFace& face : boundary.faces) blocks.push_back(face.block);
}

std::vector<int> foundations_of(const Model& model)
{
    std::vector<int> blocks;
    for (const Foundation& foundation : model.foundations) blocks.push_back(foundation.block);
    return blocks;
}

/// Stones that lie on blocks of the ground.
std::set<int> stones_on(const std::vector<bool>& ground, const std::vector<bool>& is_ground,
                        const std::vector<WatchedJoint>& joints)
{
    std::set<int> stones;
    for (const WatchedJoint& joint : joints) {
        if (std::abs(joint.normal.z()) < bed) continue;
        if (ground[joint.block_a] && !is_ground[joint.block_b]) stones.insert(joint.block_b);
        if (ground[joint.block_b] && !is_ground[joint.block_a]) stones.insert(joint.block_a);
    }
    return stones;
}

}  // namespace

std::vector<int> blocks_held_by_ground(const Model& model)
{
    std::vector<int> blocks = foundations_of(model);
    add_ends(model, blocks);
    return blocks;
}

std::vector<int> blocks_that_are_ground(const Model& model)
{
    std::vector<int> blocks = foundations_of(model);
    if (blocks.empty()) add_ends(model, blocks);
    return blocks;
}

std::vector<bool> ground_marks(const Model& model)
{
    std::set<int> materials;
    for (const ViscousBoundary& boundary : model.boundaries)
        for (const BlockFace& face : boundary.faces) materials.insert(model.blocks[face.block].material);
    for (const int b : model.tied_sides) materials.insert(model.blocks[b].material);
    std::vector<bool> result;
    for (const Block& block : model.blocks) result.push_back(materials.contains(block.material));
    for (const Foundation& foundation : model.foundations) result[foundation.block] = true;
    return result;
}

Foot::Foot(const Model& model, const std::vector<WatchedJoint>& joints) : blocks_(blocks_that_are_ground(model))
{
    const std::vector<bool> is_ground = ground_marks(model);
    std::vector<bool> supports(is_ground.size(), false), soil = is_ground;
    for (const Foundation& foundation : model.foundations) {
        supports[foundation.block] = true;
        soil[foundation.block] = false;
    }
    if (!stones_on(supports, is_ground, joints).empty()) return;
    const std::set<int> stones = stones_on(soil, is_ground, joints);
    if (stones.empty()) return;
    blocks_.assign(stones.begin(), stones.end());
    on_soil_ = true;
}

Vector3d Foot::displacement(const Model& model, const State& state) const
{
    Vector3d sum = Vector3d::Zero(), count = Vector3d::Zero();
    const auto add = [&](int block, const auto& counts) {
        const Vector3d moved = displacement_of(model, state, {block, Vector3d::Zero()});
        for (const int axis : axes_of(model.kinematics)) {
            if (!counts(axis)) continue;
            sum[axis] += moved[axis];
            count[axis] += 1;
        }
    };
    if (on_soil_ || model.foundations.empty())
        for (const int block : blocks_) add(block, [](int) { return true; });
    else
        for (const Foundation& foundation : model.foundations)
            add(foundation.block, [&](int axis) { return foundation.translation_held[axis]; });
    return sum.cwiseQuotient(count.cwiseMax(1));
}

Vector3d Foot::velocity(const Model& model, const State& state) const
{
    Vector3d sum = Vector3d::Zero();
    for (const int block : blocks_)
        sum += velocity_of(model.kinematics, state, block) / static_cast<double>(blocks_.size());
    return sum;
}

}  // namespace voussoir
