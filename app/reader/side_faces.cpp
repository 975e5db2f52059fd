#include "app/reader/side_faces.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "app/reader/foundation.h"
#include "app/reader/plane.h"
#include "libdda/geometry/plane.h"

namespace voussoir::app::reader
{

using Eigen::Vector3d;

namespace
{

constexpr double same_way = 0.99619;  // cosine of 5 degrees: a face that looks as asked
constexpr double same_plane = 0.01;   // of a block's size: how far the faces of one side may lie apart

/// A face that looks the way that was asked for, and how far out it lies.
struct Candidate {
    BlockFace face;
    double farthest = 0;  // m, of its corners along the direction
};

void add_candidates(const Model& model, int block, const Vector3d& direction, std::vector<Candidate>& found)
{
    const Block& stone = model.blocks[block];
    const double base = stone.moments.centroid.dot(direction);
    for (int p = 0; p < static_cast<int>(stone.parts.size()); ++p) {
        const ConvexPolyhedron& part = stone.parts[p];
        for (int f = 0; f < static_cast<int>(part.faces.size()); ++f) {
            if (part.is_glued(f) || face_normal(part, f).dot(direction) < same_way) continue;
            found.push_back({{block, p, f}, base + part.vertices[part.faces[f][0]].dot(direction)});
        }
    }
    for (int p = 0; p < static_cast<int>(stone.outlines.size()); ++p) {
        const auto& corners = stone.outlines[p].vertices;
        for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
            const Eigen::Vector2d along = corners[(i + 1) % corners.size()] - corners[i];
            const Vector3d normal = to_space(Eigen::Vector2d(Eigen::Vector2d(along.y(), -along.x()).normalized()));
            if (normal.dot(direction) < same_way) continue;
            found.push_back({{block, p, i}, base + to_space(corners[i]).dot(direction)});
        }
    }
}

}  // namespace

std::vector<BlockFace> faces_towards(const Model& model, const std::vector<int>& blocks, const Vector3d& direction)
{
    std::vector<Candidate> candidates;
    for (const int block : blocks) add_candidates(model, block, direction, candidates);
    double farthest = -std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : candidates) farthest = std::max(farthest, candidate.farthest);
    std::vector<BlockFace> faces;
    for (const Candidate& candidate : candidates)
        if (candidate.farthest > farthest - same_plane * size_of(model, candidate.face.block))
            faces.push_back(candidate.face);
    return faces;
}

std::vector<Vector3d> corners_of(const Model& model, const BlockFace& face)
{
    const Block& block = model.blocks[face.block];
    std::vector<Vector3d> corners;
    if (!block.parts.empty()) {
        const ConvexPolyhedron& part = block.parts[face.part];
        for (const int vertex : part.faces[face.face])
            corners.push_back(block.moments.centroid + part.vertices[vertex]);
        return corners;
    }
    const auto& outline = block.outlines[face.part].vertices;
    for (const std::size_t i :
         {static_cast<std::size_t>(face.face), (face.face + std::size_t{1}) % outline.size()})
        corners.push_back(block.moments.centroid + to_space(outline[i]));
    return corners;
}

Vector3d read_side(const YamlCursor& value, Kinematics kinematics)
{
    if (value.is_list()) {
        const Vector3d direction = read_direction(value, kinematics);
        if (direction.norm() == 0) value.fault("a direction of length 0", "give one such as [0, 0, -1]");
        return direction.norm() > 0 ? Vector3d(direction.normalized()) : Vector3d(Vector3d::Zero());
    }
    const std::pair<std::string_view, Vector3d> sides[] = {{"bottom", {0, 0, -1}}, {"left", {-1, 0, 0}},
                                                           {"right", {1, 0, 0}},   {"front", {0, -1, 0}},
                                                           {"back", {0, 1, 0}},    {"top", {0, 0, 1}}};
    const std::string word = value.as_text();
    for (const auto& [name, direction] : sides)
        if (word == name && !(is_planar(kinematics) && direction.y() != 0)) return direction;
    if (!word.empty())
        value.fault("\"" + word + "\"", is_planar(kinematics)
                                            ? "expected bottom, top, left, right or a direction [x, z]"
                                            : "expected bottom, top, left, right, front, back or a direction");
    return Vector3d::Zero();
}

std::vector<int> free_blocks(const YamlCursor& group, const Model& model)
{
    std::vector<int> blocks;
    for (const YamlCursor& one :
         group.is_list() ? group.items("a list of groups") : std::vector<YamlCursor>{group})
        for (const int block : blocks_of_group(one, model)) blocks.push_back(block);
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    for (const Foundation& foundation : model.foundations)
        if (std::find(blocks.begin(), blocks.end(), foundation.block) != blocks.end()) {
            group.fault("block " + model.blocks[foundation.block].name + " follows the ground",
                        "a block has a foundation or a boundary; leave one of them away");
            return {};
        }
    return blocks;
}

}  // namespace voussoir::app::reader
