#include "importers/fit/choose_joints.h"

#include <algorithm>
#include <set>

#include "importers/exact/triangle_surface.h"

namespace voussoir::importers::fit
{

namespace
{

// A bed of a course that is curved in plan can be made flat if all of the course is bent for it.
constexpr double nearly_flat = 1e-4;  // share of a side's size: nearer than this to its plane a side stays whole

// A misfit is closed from both sides, a bent side flattened by a few times its bend, for its corners hang together
// with others. Where corners have to go further, a course would be bent to fit.
constexpr double far_for_a_bend = 2.5;

SideOf first_of(const Facing& joint)
{
    return {joint.stone_a, joint.side_a};
}

SideOf second_of(const Facing& joint)
{
    return {joint.stone_b, joint.side_b};
}

/// Sets of sides that joints connect.
class Components
{
 public:
    Components() = default;
    explicit Components(const std::vector<Facing>& joints)
    {
        for (const Facing& joint : joints) join(first_of(joint), second_of(joint));
    }
    int of(const SideOf& side)
    {
        const auto [known, is_new] = index_.try_emplace(side, static_cast<int>(parent_.size()));
        if (is_new) parent_.push_back(known->second);
        return root(known->second);
    }
    void join(const SideOf& a, const SideOf& b)
    {
        const int i = of(a), j = of(b);
        parent_[i] = j;
    }

 private:
    int root(int k)
    {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }
    std::map<SideOf, int> index_;
    std::vector<int> parent_;
};

bool is_flat(const std::vector<SidedStone>& stones, const SideOf& key, const JointLimits& limits)
{
    const Side& side = stones[key.stone].sides[key.side];
    return side.largest_off <= limits.flat_enough * side.size;
}

/// For each face of a side the area with which it faces each side of other stones [m2]; none where it faces
/// nothing.
using Opponents = std::map<int, std::map<SideOf, double>>;  // by face

std::map<SideOf, Opponents> opponents_of(const std::vector<Facing>& joints)
{
    std::map<SideOf, Opponents> all;
    for (const Facing& joint : joints) {
        for (const auto& [face, area] : joint.area_of_face_a) all[first_of(joint)][face][second_of(joint)] += area;
        for (const auto& [face, area] : joint.area_of_face_b) all[second_of(joint)][face][first_of(joint)] += area;
    }
    return all;
}

/// The faces of a side by what they face; those that face nothing go with the first.
std::vector<std::vector<int>> divided(const Side& side, const Opponents& opponents)
{
    std::map<SideOf, std::vector<int>> by_opponent;
    std::vector<int> alone;
    for (const int face : side.faces) {
        const auto found = opponents.find(face);
        if (found == opponents.end()) {
            alone.push_back(face);
            continue;
        }
        const auto most = std::max_element(found->second.begin(), found->second.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        by_opponent[most->first].push_back(face);
    }
    std::vector<std::vector<int>> groups;
    groups.reserve(by_opponent.size());
    for (auto& [opponent, faces] : by_opponent) groups.push_back(std::move(faces));
    if (!groups.empty()) groups.front().insert(groups.front().end(), alone.begin(), alone.end());
    return groups;
}

/// [m] A bent polygon has no surface of its own: each stone would get diagonals as they come.
double misfit_of(const Facing& joint, const std::vector<SidedStone>& stones)
{
    return std::max({joint.misfit(), stones[joint.stone_a].sides[joint.side_a].bent_face,
                     stones[joint.stone_b].sides[joint.side_b].bent_face});
}

/// How far the corners of a side have moved at most [m].
double move_of(const SidedStone& stone, const Side& side, const std::vector<Eigen::Vector3d>& vertices)
{
    double move = 0;
    for (const int v : side.corners) move = std::max(move, (vertices[v] - stone.surface->vertices[v]).norm());
    return move;
}

/// Sides that face several others and whose corners had to go further than what was drawn explains.
std::vector<SideOf> overbent_sides(const std::vector<Facing>& joints, const SharedShape& shape,
                                   const std::vector<SidedStone>& stones)
{
    Components components(joints);
    struct Drawn {
        double misfit = 0, bend = 0;  // m
        double allowed() const { return std::max(misfit, far_for_a_bend * bend); }
    };
    std::map<int, Drawn> drawn;
    std::map<SideOf, int> opponents;
    for (const Facing& joint : joints) {
        Drawn& of_component = drawn[components.of(first_of(joint))];
        of_component.misfit = std::max(of_component.misfit, misfit_of(joint, stones));
        for (const SideOf& key : {first_of(joint), second_of(joint)}) {
            of_component.bend = std::max(of_component.bend, stones[key.stone].sides[key.side].largest_off);
            ++opponents[key];
        }
    }
    std::vector<SideOf> bent;
    for (const auto& [key, misfit] : shape.misfit) {
        if (opponents.at(key) == 1) continue;
        const Side& side = stones[key.stone].sides[key.side];
        const double allowed = drawn.at(components.of(key)).allowed();
        if (misfit > allowed || move_of(stones[key.stone], side, shape.vertices[key.stone]) > allowed)
            bent.push_back(key);
    }
    return bent;
}

}  // namespace

JointChoice choose_joints(const std::vector<SidedStone>& stones, const std::vector<Facing>& joints,
                          const JointLimits& limits)
{
    std::vector<double> allowed;
    allowed.reserve(stones.size());
    for (const SidedStone& stone : stones)
        allowed.push_back(limits.planarity * exact::diagonal_of(stone.surface->vertices));
    JointChoice choice;
    std::vector<Facing> flat;
    for (const Facing& joint : joints) {
        double misfit = misfit_of(joint, stones), bend = 0;
        for (const SideOf& key : {first_of(joint), second_of(joint)})
            bend = std::max(bend, stones[key.stone].sides[key.side].largest_off);
        const double nothing = std::min(allowed[joint.stone_a], allowed[joint.stone_b]);
        if (limits.flatten) misfit = std::max(misfit, bend);
        // Flat sides that overlap or gape are as they were cut; they are laid where they are, not bent.
        const bool misfits = misfit > nothing && (limits.flatten || bend > nothing);
        if (misfits) choice.misfit = std::max(choice.misfit, misfit);
        if (!is_flat(stones, first_of(joint), limits) || !is_flat(stones, second_of(joint), limits)) {
            choice.left += misfits ? 1 : 0;
            continue;
        }
        flat.push_back(joint);
        flat.back().misfits = misfits;
    }
    Components components(flat);
    std::set<int> misfitting;
    for (const Facing& joint : flat)
        if (joint.misfits) misfitting.insert(components.of(first_of(joint)));
    for (Facing& joint : flat)
        if (misfitting.contains(components.of(first_of(joint)))) choice.joints.push_back(std::move(joint));
    return choice;
}

int JointChoice::misfitting() const
{
    return static_cast<int>(
        std::count_if(joints.begin(), joints.end(), [](const Facing& joint) { return joint.misfits; }));
}

bool split_sides(const std::vector<Facing>& joints, const std::vector<SideOf>& bent,
                 std::vector<SidedStone>& stones)
{
    Components components(joints);
    std::set<int> bent_components;
    for (const SideOf& key : bent) bent_components.insert(components.of(key));
    std::vector<std::pair<SideOf, std::vector<std::vector<int>>>> divisions;  // found before any side changes
    for (const auto& [key, opponents] : opponents_of(joints)) {
        if (!bent_components.contains(components.of(key))) continue;
        auto groups = divided(stones[key.stone].sides[key.side], opponents);
        if (groups.size() > 1) divisions.emplace_back(key, std::move(groups));
    }
    for (const auto& [key, groups] : divisions) {
        SidedStone& stone = stones[key.stone];
        for (std::size_t g = 0; g < groups.size(); ++g) {
            Side part = make_side(*stone.surface, groups[g]);
            if (g == 0)
                stone.sides[key.side] = std::move(part);
            else
                stone.sides.push_back(std::move(part));
        }
    }
    return !divisions.empty();
}

std::vector<SideOf> bent_sides(const std::vector<Facing>& joints, const std::vector<SidedStone>& stones,
                               const JointLimits& limits)
{
    std::vector<SideOf> bent;
    for (const Facing& joint : joints)
        for (const SideOf& key : {first_of(joint), second_of(joint)})
            if (!is_flat(stones, key, limits)) bent.push_back(key);
    return bent;
}

std::vector<SideOf> bent_sides(const std::vector<Facing>& joints, const std::vector<SidedStone>& stones,
                               const SharedShape& whole, const SharedShape& divided)
{
    Components components(joints);
    struct Moves {
        double whole = 0, divided = 0, allowed = 0;  // m
    };
    std::map<int, Moves> moves;
    for (const auto& [key, misfit] : whole.misfit) {
        const SidedStone& stone = stones[key.stone];
        const Side& side = stone.sides[key.side];
        Moves& of_component = moves[components.of(key)];
        of_component.allowed = std::max(of_component.allowed, nearly_flat * side.size);
        of_component.whole = std::max(of_component.whole, move_of(stone, side, whole.vertices[key.stone]));
        of_component.divided = std::max(of_component.divided, move_of(stone, side, divided.vertices[key.stone]));
    }
    std::vector<SideOf> bent = overbent_sides(joints, whole, stones);
    for (const auto& [key, misfit] : whole.misfit) {
        const Moves& of_component = moves.at(components.of(key));
        if (misfit > nearly_flat * stones[key.stone].sides[key.side].size ||
            of_component.whole > 2 * of_component.divided + of_component.allowed)
            bent.push_back(key);
    }
    return bent;
}

bool leave_bent_joints(const SharedShape& shape, const std::vector<SidedStone>& stones, JointChoice& choice)
{
    Components components(choice.joints);
    std::set<int> bent;
    for (const SideOf& key : overbent_sides(choice.joints, shape, stones)) bent.insert(components.of(key));
    if (bent.empty()) return false;
    const int before = choice.misfitting();
    std::erase_if(choice.joints,
                  [&](const Facing& joint) { return bent.contains(components.of(first_of(joint))); });
    choice.left += before - choice.misfitting();
    return true;
}

}  // namespace voussoir::importers::fit
