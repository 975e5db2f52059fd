#include "importers/assembly/assembly.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "importers/assembly/assembly_contacts.h"
#include "importers/assembly/assembly_shapes.h"
#include "importers/assembly/assembly_words.h"
#include "libdda/model/disjoint_sets.h"

namespace voussoir::importers::assembly
{
namespace
{

using Eigen::Vector3d;

constexpr double same_width = 1.1;  // gaps of one group differ by at most this factor

void find_components(Assembly& assembly)
{
    const int count = static_cast<int>(assembly.stones.size());
    DisjointSets sets(assembly.stones.size());
    std::vector<bool> touches(count, false);
    for (const StoneContact& contact : assembly.contacts) {
        sets.join(contact.b, contact.a);
        touches[contact.a] = touches[contact.b] = true;
    }
    std::vector<std::vector<int>> members(count);
    for (int i = 0; i < count; ++i) {
        members[sets.root_of(i)].push_back(i);
        if (!touches[i] && count > 1) assembly.floating.push_back(i);
    }
    for (std::vector<int>& component : members)
        if (!component.empty()) assembly.components.push_back(std::move(component));
    std::stable_sort(assembly.components.begin(), assembly.components.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
}

double lowest_point(const AssemblyStone& stone)
{
    double lowest = INFINITY;
    for (const ConvexPolyhedron& part : stone.parts)
        for (const Vector3d& x : part.vertices) lowest = std::min(lowest, x.z());
    return lowest;
}

void find_ground(Assembly& assembly)
{
    double level = INFINITY;
    std::vector<double> lowest;
    for (const AssemblyStone& stone : assembly.stones) {
        assembly.ground_given = assembly.ground_given || stone.foundation;
        lowest.push_back(lowest_point(stone));
        level = std::min(level, lowest.back());
    }
    for (int i = 0; i < static_cast<int>(assembly.stones.size()); ++i) {
        const AssemblyStone& stone = assembly.stones[i];
        const bool reaches = lowest[i] <= level + assembly_tolerance::ground * std::cbrt(stone.volume);
        if (assembly.ground_given ? stone.foundation : reaches) assembly.ground.push_back(i);
    }
}

void find_unsupported(Assembly& assembly)
{
    const auto is_ground = [&](int stone) {
        return std::binary_search(assembly.ground.begin(), assembly.ground.end(), stone);
    };
    for (const std::vector<int>& component : assembly.components)
        if (std::none_of(component.begin(), component.end(), is_ground))
            assembly.unsupported.insert(assembly.unsupported.end(), component.begin(), component.end());
    std::sort(assembly.unsupported.begin(), assembly.unsupported.end());
}

void group_gaps(Assembly& assembly)
{
    std::vector<int> order(assembly.gaps.size());
    std::iota(order.begin(), order.end(), 0);
    const auto width = [&](int gap) { return assembly.gaps[gap].width; };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return width(a) < width(b); });
    for (const int gap : order) {
        if (assembly.gap_groups.empty() || width(gap) > same_width * assembly.gap_groups.back().narrowest)
            assembly.gap_groups.push_back({width(gap), width(gap), {}});
        GapGroup& group = assembly.gap_groups.back();
        group.widest = std::max(group.widest, assembly.gaps[gap].widest);
        group.gaps.push_back(gap);
    }
    for (GapGroup& group : assembly.gap_groups) std::sort(group.gaps.begin(), group.gaps.end());
}

double shared_volume(const AssemblyStone& a, const AssemblyStone& b)
{
    double volume = 0;
    for (const ConvexPolyhedron& part_a : a.parts)
        for (const ConvexPolyhedron& part_b : b.parts) volume += volume_inside(shared_region(part_a, part_b));
    return volume;
}

/// The overlaps that are known, with their depths, and those that only the contact search has seen.
void find_overlaps(const std::vector<StoneOverlap>& known, Assembly& assembly)
{
    std::map<std::pair<int, int>, StoneOverlap> pairs;
    for (const StoneOverlap& overlap : known) {
        const auto [a, b] = std::minmax(overlap.a, overlap.b);
        pairs[{a, b}] = {a, b, overlap.volume, overlap.depth};
    }
    for (const StoneContact& contact : assembly.contacts) {
        const AssemblyStone& a = assembly.stones[contact.a];
        const AssemblyStone& b = assembly.stones[contact.b];
        const double depth = -contact.smallest_gap;
        const auto overlap = pairs.find({contact.a, contact.b});
        if (overlap != pairs.end())
            overlap->second.depth = std::max(overlap->second.depth, depth);
        else if (depth > assembly_tolerance::contact * std::cbrt(std::min(a.volume, b.volume)))
            pairs[{contact.a, contact.b}] = {contact.a, contact.b, shared_volume(a, b), depth};
    }
    for (const auto& [pair, overlap] : pairs) assembly.overlaps.push_back(overlap);
}

}  // namespace

Assembly examine_assembly(std::vector<AssemblyStone> stones, const std::vector<StoneOverlap>& overlaps,
                          const AssemblyOrigin& origin)
{
    Assembly assembly;
    assembly.stones = std::move(stones);
    if (assembly.stones.empty()) return assembly;
    find_contacts_and_gaps(assembly);
    group_gaps(assembly);
    find_components(assembly);
    find_ground(assembly);
    find_unsupported(assembly);
    judge_shapes(assembly);
    find_overlaps(overlaps, assembly);
    assembly.findings = findings_in_words(assembly, origin);
    return assembly;
}

}  // namespace voussoir::importers::assembly
