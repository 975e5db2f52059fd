// What the tests of walls and houses measure on them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "importers/exact/overlap.h"
#include "importers/patterns/masonry.h"
#include "libdda/contact/initial_contacts.h"
#include "libdda/errors.h"

namespace voussoir::importers
{

/// All faults of a pattern that must be refused, one a line.
template <class Make>
std::string refusal_of(const Make& make)
{
    try {
        make();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

inline Model model_of(const std::vector<patterns::MasonryBlock>& blocks)
{
    JointMaterial dry;
    dry.name = "dry";
    Model model = make_model(Kinematics::spatial_rigid, {"stone", 2000, 1e9, 0.2}, dry);
    for (const patterns::MasonryBlock& block : blocks)
        model.blocks.push_back(make_block(block.name, 0, 0, {patterns::to_polyhedron(block)}));
    return model;
}

inline double volume_of(const std::vector<patterns::MasonryBlock>& blocks)
{
    double volume = 0;
    for (const Block& block : model_of(blocks).blocks) volume += block.moments.volume;
    return volume;
}

/// Areas of all joints [m2] and which blocks meet in them.
struct Joints {
    double bed = 0, head = 0;
    std::vector<std::vector<int>> touching;  // (blocks) over bed joints
};

inline Joints joints_of(const std::vector<patterns::MasonryBlock>& blocks)
{
    const Model model = model_of(blocks);
    State state = initial_state(model);
    find_initial_contacts(model, state);
    Joints joints;
    joints.touching.resize(blocks.size());
    for (const ContactPatch& patch : state.contacts.patches) {
        const bool is_bed = std::abs(patch.normal.z()) > 0.5;
        for (int i = patch.first_point; i < patch.first_point + patch.point_count; ++i)
            (is_bed ? joints.bed : joints.head) += state.contacts.points[i].area;
        if (!is_bed) continue;
        joints.touching[patch.block_a].push_back(patch.block_b);
        joints.touching[patch.block_b].push_back(patch.block_a);
    }
    return joints;
}

/// Number of blocks that bed joints connect with the first one.
inline int standing_on_first(const Joints& joints)
{
    std::vector<int> reached = {0};
    std::vector<bool> seen(joints.touching.size(), false);
    seen[0] = true;
    for (std::size_t i = 0; i < reached.size(); ++i)
        for (const int next : joints.touching[reached[i]]) {
            if (seen[next]) continue;
            seen[next] = true;
            reached.push_back(next);
        }
    return static_cast<int>(reached.size());
}

inline std::vector<exact::OverlappingPair> overlaps_of(const std::vector<patterns::MasonryBlock>& blocks)
{
    std::vector<std::vector<ConvexPolyhedron>> stones;
    for (const patterns::MasonryBlock& block : blocks) stones.push_back({patterns::to_polyhedron(block)});
    return exact::find_overlaps(stones, 1e-12);
}

/// Vertical joints of the wall whose blocks' names begin with `prefix`: height of the course's foot to places
/// along `axis` where one block ends and the next begins, or where the other wall of a corner begins.
inline std::map<double, std::vector<double>> vertical_joints(const std::vector<patterns::MasonryBlock>& blocks,
                                                             const std::string& prefix, int axis, double corner,
                                                             double length)
{
    std::map<double, std::vector<double>> begins, ends, joints;
    std::vector<double> feet;
    for (const patterns::MasonryBlock& block : blocks)
        if (block.name.starts_with(prefix + "_c")) feet.push_back(block.corners[0].z());
    for (const patterns::MasonryBlock& block : blocks)
        if (block.name.starts_with(prefix + "_"))
            for (const double z : feet)
                if (block.corners[0].z() <= z && z < block.corners[7].z()) {
                    begins[z].push_back(block.corners[0][axis]);
                    ends[z].push_back(block.corners[7][axis]);
                }
    for (auto& [z, places] : begins)
        for (const double x : places)
            if (std::count(ends[z].begin(), ends[z].end(), x) > 0 || (corner > 0 && x == corner))
                if (std::count(joints[z].begin(), joints[z].end(), x) == 0) joints[z].push_back(x);
    for (auto& [z, places] : ends)
        for (const double x : places)
            if (corner > 0 && x == length - corner && std::count(joints[z].begin(), joints[z].end(), x) == 0)
                joints[z].push_back(x);
    return joints;
}

/// Smallest distance along the wall between vertical joints of two courses that lie on each other [m];
/// NaN when there are none.
inline double smallest_bond(const std::map<double, std::vector<double>>& joints)
{
    double smallest = INFINITY;
    for (auto course = joints.begin(); course != joints.end() && std::next(course) != joints.end(); ++course)
        for (const double below : course->second)
            for (const double above : std::next(course)->second)
                smallest = std::min(smallest, std::abs(above - below));
    return std::isfinite(smallest) ? smallest : NAN;
}

/// Shortest edge of any block [m].
inline double smallest_edge(const std::vector<patterns::MasonryBlock>& blocks)
{
    double smallest = INFINITY;
    for (const patterns::MasonryBlock& block : blocks)
        for (const int corner : {1, 2, 4})
            smallest = std::min(smallest, (block.corners[corner] - block.corners[0]).norm());
    return smallest;
}

}  // namespace voussoir::importers
