#include "app/reader/side_ground.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "app/reader/side_faces.h"
#include "libdda/contact/normal_stiffness.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector3d;

constexpr double same_place = 1e-6;  // of a block's size: how far apart corners of the same place may be drawn

/// Lowest and highest corner of a block [m].
std::pair<double, double> heights_of(const Block& block)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto add = [&](double z) {
        low = std::min(low, z);
        high = std::max(high, z);
    };
    for (const ConvexPolyhedron& part : block.parts)
        for (const Vector3d& vertex : part.vertices) add(block.moments.centroid.z() + vertex.z());
    for (const ConvexPolygon& outline : block.outlines)
        for (const Eigen::Vector2d& vertex : outline.vertices) add(block.moments.centroid.z() + vertex.y());
    return {low, high};
}

/// The nearest of some blocks that is as high as a face and as low; -1: none.
int beside(const Model& model, const std::vector<int>& blocks, const BlockFace& face)
{
    const std::vector<Vector3d> corners = corners_of(model, face);
    const double tolerance = same_place * size_of(model, face.block);
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int block : blocks) {
        const auto [low, high] = heights_of(model.blocks[block]);
        const bool spans =
            std::all_of(corners.begin(), corners.end(), [&, low = low, high = high](const Vector3d& c) {
                return c.z() > low - tolerance && c.z() < high + tolerance;
            });
        const double distance = (model.blocks[block].moments.centroid - corners.front()).norm();
        if (!spans || distance >= least) continue;
        nearest = block;
        least = distance;
    }
    return nearest;
}

/// Whether a face, moved by `period`, is the other one.
bool is_copy(const Model& model, const BlockFace& face, const BlockFace& other, const Vector3d& period)
{
    const double tolerance = same_place * size_of(model, face.block);
    const std::vector<Vector3d> corners = corners_of(model, face), others = corners_of(model, other);
    return corners.size() == others.size() &&
           std::all_of(corners.begin(), corners.end(), [&](const Vector3d& corner) {
               return std::any_of(others.begin(), others.end(), [&](const Vector3d& there) {
                   return (corner + period - there).norm() < tolerance;
               });
           });
}

/// Extent of a block along a direction [m].
double depth_along(const Block& block, const Vector3d& direction)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    const auto add = [&](const Vector3d& vertex) {
        low = std::min(low, vertex.dot(direction));
        high = std::max(high, vertex.dot(direction));
    };
    for (const ConvexPolyhedron& part : block.parts)
        for (const Vector3d& vertex : part.vertices) add(vertex);
    for (const ConvexPolygon& outline : block.outlines)
        for (const Eigen::Vector2d& vertex : outline.vertices) add(to_space(vertex));
    return high - low;
}

/// The stiffness that a bonded joint of the two blocks would have.
SideTie tie_of(const Model& model, const BlockFace& a, const BlockFace& b, const Vector3d& direction)
{
    const JointMaterial& joint = model.joint_between(a.block, b.block);
    double normal = joint.stiffness.value;
    if (joint.stiffness.kind == ContactStiffness::Kind::from_modulus) {
        double compliance = 0;
        for (const int block : {a.block, b.block})
            compliance +=
                depth_along(model.blocks[block], direction) / model.materials[model.blocks[block].material].young;
        normal = 2 * contact::times_modulus(model.kinematics, joint) / compliance;
    }
    normal *= joint.stiffness.factor;
    return {a, b, normal, joint.shear_to_normal_stiffness * normal};
}

/// Refuses what cannot be tied. @returns whether it can
bool can_be_tied(const YamlCursor& sides, const Model& model, const BlockFace& a, const BlockFace& b)
{
    if (a.block == b.block) {
        sides.fault("block " + model.blocks[a.block].name + " is both sides of a row one block wide",
                    "use tied_sides for it");
        return false;
    }
    const JointMaterial& joint = model.joint_between(a.block, b.block);
    const bool per_area = joint.stiffness.kind != ContactStiffness::Kind::per_point;
    if (joint.has_strength() && per_area) return true;
    sides.fault(fmt::format("joint {} between their blocks, which {}", joint.name,
                            per_area ? "opens" : "has a stiffness per point"),
                per_area ? "give it cohesion or tensile strength: tied sides never open"
                         : "give contact_stiffness in Pa/m, or leave it to the rule");
    return false;
}

void tie_faces(const YamlCursor& sides, const std::vector<BlockFace>& from, const std::vector<BlockFace>& to,
               const Vector3d& direction, Model& model)
{
    const auto farthest = [&](const BlockFace& face) { return corners_of(model, face).front().dot(direction); };
    const Vector3d period = (farthest(to.front()) - farthest(from.front())) * direction;
    std::vector<SideTie> ties;
    for (const BlockFace& face : from) {
        const auto at = std::find_if(to.begin(), to.end(),
                                     [&](const BlockFace& other) { return is_copy(model, face, other, period); });
        if (at == to.end())
            return sides.fault(
                "block " + model.blocks[face.block].name + " has no face like its own on the other side",
                "cut both sides into the same blocks");
        if (!can_be_tied(sides, model, face, *at)) return;
        ties.push_back(tie_of(model, face, *at, direction));
    }
    if (from.size() != to.size())
        return sides.fault(fmt::format("{} faces on one side, {} on the other", from.size(), to.size()),
                           "cut both sides into the same blocks");
    model.side_ties.insert(model.side_ties.end(), ties.begin(), ties.end());
}

void read_one(YamlCursor& map, Model& model)
{
    if (!map.expect_map("periodic sides {blocks: soil, sides: [left, right]}")) return;
    const auto group = map.require("blocks", "the group of blocks whose sides are tied, or a list of groups");
    const auto sides = map.require("sides", "the two sides, such as [left, right]");
    map.reject_unknown_keys();
    if (!group || !sides) return;
    std::vector<Vector3d> ways;
    for (const YamlCursor& side : sides->items("two sides, such as [left, right]"))
        ways.push_back(read_side(side, model.kinematics));
    const std::vector<int> blocks = free_blocks(*group, model);
    if (blocks.empty() || std::any_of(ways.begin(), ways.end(), [](const Vector3d& w) { return w.norm() == 0; }))
        return;
    if (ways.size() != 2 || (ways[0] + ways[1]).norm() > same_place)
        return sides->fault(fmt::format("{} sides that are not opposite", ways.size()),
                            "give two, such as [left, right]");
    const std::vector<BlockFace> from = faces_towards(model, blocks, ways[0]),
                                 to = faces_towards(model, blocks, ways[1]);
    if (from.empty() || to.empty())
        return sides->fault("no face of these blocks looks that way", "name sides they have");
    tie_faces(*sides, from, to, ways[1], model);
}

}  // namespace

void read_free_field(const YamlCursor& group, const Model& model, ViscousBoundary& boundary)
{
    const std::vector<int> columns = free_blocks(group, model);
    for (const int block : columns)
        if (!std::binary_search(model.tied_sides.begin(), model.tied_sides.end(), block))
            return group.fault("block " + model.blocks[block].name + " is no ground without sides",
                               "name its group in tied_sides too");
    for (const BlockFace& face : boundary.faces) {
        const int column = beside(model, columns, face);
        if (column < 0 && !columns.empty())
            return group.fault(
                "none of its blocks is as high and as low as block " + model.blocks[face.block].name,
                "cut the columns into the same layers as the model's side");
        if (column == face.block)
            return group.fault("block " + model.blocks[column].name + " is its own free field",
                               "name columns that stand beside the model");
        boundary.free_field.push_back(column);
    }
}

void read_periodic_sides(YamlCursor& value, Model& model)
{
    if (!value.is_list()) return read_one(value, model);
    for (YamlCursor& item : value.items("a list of {blocks, sides}")) read_one(item, model);
}

}  // namespace voussoir::app::reader
