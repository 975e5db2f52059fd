#include "importers/exact/merge_small.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace voussoir::importers::exact
{
namespace
{

/// A face of a part of a block.
struct FacePlace {
    std::size_t block = 0, part = 0, face = 0;
};

/// Its corners in an order that does not depend on the side it is seen from: neighbours were rounded alike.
using FaceKey = std::vector<std::array<double, 3>>;

FaceKey key_of(const ConvexPolyhedron& part, const std::vector<int>& face)
{
    FaceKey key;
    key.reserve(face.size());
    for (const int v : face) {
        const Eigen::Vector3d& x = part.vertices[static_cast<std::size_t>(v)];
        key.push_back({x.x() + 0.0, x.y() + 0.0, x.z() + 0.0});
    }
    std::sort(key.begin(), key.end());
    return key;
}

double area_of(const ConvexPolyhedron& part, const std::vector<int>& face)
{
    const auto at = [&](std::size_t i) { return part.vertices[static_cast<std::size_t>(face[i])]; };
    Eigen::Vector3d twice = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < face.size(); ++i) twice += (at(i) - at(0)).cross(at(i + 1) - at(0));
    return twice.norm() / 2;
}

/// Two whole faces that lie against each other.
struct Shared {
    FacePlace one, other;
    double area = 0;  // m2
};

std::vector<Shared> shared_faces(const std::vector<RockBlock>& blocks)
{
    std::map<FaceKey, FacePlace> waiting;
    std::vector<Shared> shared;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        for (std::size_t p = 0; p < blocks[b].parts.size(); ++p) {
            const ConvexPolyhedron& part = blocks[b].parts[p];
            for (std::size_t f = 0; f < part.faces.size(); ++f) {
                if (part.is_glued(static_cast<int>(f))) continue;
                const auto [place, is_new] = waiting.try_emplace(key_of(part, part.faces[f]), FacePlace{b, p, f});
                if (!is_new) shared.push_back({place->second, {b, p, f}, area_of(part, part.faces[f])});
            }
        }
    return shared;
}

/// Which block each one is part of by now.
class Owners
{
 public:
    explicit Owners(std::size_t count) : owner_(count)
    {
        for (std::size_t i = 0; i < count; ++i) owner_[i] = i;
    }
    std::size_t of(std::size_t block) const
    {
        while (owner_[block] != block) block = owner_[block];
        return block;
    }
    void give(std::size_t block, std::size_t to) { owner_[block] = to; }

 private:
    std::vector<std::size_t> owner_;
};

/// The blocks beside each one, with the areas of the faces they share [m2].
using Neighbours = std::vector<std::map<std::size_t, double>>;

Neighbours neighbours_of(const std::vector<Shared>& shared, std::size_t count)
{
    Neighbours neighbours(count);
    for (const Shared& faces : shared) {
        if (faces.one.block == faces.other.block) continue;
        neighbours[faces.one.block][faces.other.block] += faces.area;
        neighbours[faces.other.block][faces.one.block] += faces.area;
    }
    return neighbours;
}

/// The block joins `to`, and brings its neighbours.
void join(std::size_t block, std::size_t to, Neighbours& neighbours)
{
    for (const auto& [other, area] : neighbours[block]) {
        neighbours[other].erase(block);
        if (other == to) continue;
        neighbours[to][other] += area;
        neighbours[other][to] += area;
    }
    neighbours[block].clear();
}

void glue_within(std::vector<RockBlock>& blocks, const std::vector<Shared>& shared, const Owners& owners)
{
    const auto mark = [&](const FacePlace& place) {
        ConvexPolyhedron& part = blocks[place.block].parts[place.part];
        part.glued.resize(part.faces.size(), false);
        part.glued[place.face] = true;
    };
    for (const Shared& faces : shared)
        if (owners.of(faces.one.block) == owners.of(faces.other.block)) {
            mark(faces.one);
            mark(faces.other);
        }
}

/// Leaves the owners, with all that is theirs, unless they are too small.
void collect(double smallest, const Owners& owners, CutRock& rock)
{
    std::vector<RockBlock>& blocks = rock.blocks;
    std::vector<RockBlock> left;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const std::size_t owner = owners.of(b);
        if (owner != b)
            std::move(blocks[b].parts.begin(), blocks[b].parts.end(), std::back_inserter(blocks[owner].parts));
    }
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (owners.of(b) != b) continue;
        if (blocks[b].volume < smallest)
            leave_out(blocks[b], rock);
        else
            left.push_back(std::move(blocks[b]));
    }
    blocks = std::move(left);
}

}  // namespace

void leave_out(const RockBlock& block, CutRock& rock)
{
    ++rock.removed;
    rock.removed_volume += block.volume;
}

void merge_small(double smallest, CutRock& rock)
{
    std::vector<RockBlock>& blocks = rock.blocks;
    const std::vector<Shared> shared = shared_faces(blocks);
    Neighbours neighbours = neighbours_of(shared, blocks.size());
    Owners owners(blocks.size());
    std::vector<double> drawn;  // m3, without what they took up
    drawn.reserve(blocks.size());
    for (const RockBlock& block : blocks) drawn.push_back(block.volume);
    std::set<std::pair<double, std::size_t>> small;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (blocks[b].volume < smallest) small.emplace(blocks[b].volume, b);
    while (!small.empty()) {
        const auto [volume, block] = *small.begin();
        small.erase(small.begin());
        const auto largest = std::max_element(neighbours[block].begin(), neighbours[block].end(),
                                              [](const auto& a, const auto& b) { return a.second < b.second; });
        if (largest == neighbours[block].end()) continue;
        const std::size_t to = largest->first;
        small.erase({blocks[to].volume, to});
        join(block, to, neighbours);
        owners.give(block, to);
        blocks[to].volume += volume;
        ++rock.merged;
        rock.merged_volume += drawn[block];
        if (blocks[to].volume < smallest) small.emplace(blocks[to].volume, to);
    }
    glue_within(blocks, shared, owners);
    collect(smallest, owners, rock);
}

}  // namespace voussoir::importers::exact
