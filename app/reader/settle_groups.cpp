// Groups and materials of blocks, when all of them are known.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/reader/block_reading.h"
#include "app/reader/blocks.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{

using By = GroupRule::By;

constexpr std::size_t max_groups = 1000;  // more are a slip of the pen: there is a joint for every pair of them
constexpr double level = 1e-6;            // of the height of an entry's stones: at one level to rounding

/// Extent along z, model coordinates [m].
struct Height {
    double low = INFINITY, high = -INFINITY;
    void extend(double z)
    {
        low = std::min(low, z);
        high = std::max(high, z);
    }
};

Height height_of(const Block& block)
{
    Height height;
    for (const ConvexPolyhedron& part : block.parts)
        for (const Eigen::Vector3d& vertex : part.vertices) height.extend(block.moments.centroid.z() + vertex.z());
    for (const ConvexPolygon& outline : block.outlines)
        for (const Eigen::Vector2d& vertex : outline.vertices)
            height.extend(block.moments.centroid.z() + vertex.y());
    return height;
}

bool is_inside(const GroupRule& rule, const Block& block, const Model& model)
{
    const Eigen::Vector3d centroid = block.moments.centroid + model.origin;
    for (const int axis : axes_of(model.kinematics))
        if (centroid[axis] < rule.lower[axis] || centroid[axis] > rule.upper[axis]) return false;
    return true;
}

/// Does a rule that knows nothing of other groups fit a block? @param all of the entry's stones
bool fits(const GroupRule& rule, const Block& block, const Height& all, const Model& model)
{
    const double total = all.high - all.low;
    const double reach = (rule.is_share ? rule.reach * total : rule.reach) + level * total;
    switch (rule.by) {
        case By::name:
            return matches_pattern(block.name, rule.text);
        case By::lowest:
            return height_of(block).low <= all.low + reach;
        case By::highest:
            return height_of(block).high >= all.high - reach;
        case By::inside:
            return is_inside(rule, block, model);
        case By::touching:
            break;
    }
    return false;
}

/// The groups of all blocks while they are settled.
struct Groups {
    std::vector<std::string> names;  // of each block's
    std::vector<bool> by_rule;       // else it is the one for stones that no rule fits
};

void take_each_by_itself(EntryStones& entry, const Model& model, Groups& groups)
{
    std::vector<GroupRule>& rules = entry.belonging.rules;
    Height all;
    if (std::any_of(rules.begin(), rules.end(),
                    [](const GroupRule& rule) { return rule.by == By::lowest || rule.by == By::highest; }))
        for (std::size_t b = entry.first; b < entry.end; ++b) {
            const Height height = height_of(model.blocks[b]);
            all.extend(height.low);
            all.extend(height.high);
        }
    for (std::size_t b = entry.first; b < entry.end; ++b) {
        const auto rule = std::find_if(rules.begin(), rules.end(), [&](const GroupRule& one) {
            return fits(one, model.blocks[b], all, model);
        });
        groups.by_rule[b] = rule != rules.end();
        const bool has_own = entry.belonging.keeps_own_groups && !entry.own_groups[b - entry.first].empty();
        groups.names[b] = groups.by_rule[b] ? rule->group
                          : has_own         ? entry.own_groups[b - entry.first]
                                            : entry.belonging.group;
        if (groups.by_rule[b]) rule->used = true;
    }
}

/// The stones left over in an entry that touch a group, as it was before.
void take_by_touch(GroupRule& rule, const EntryStones& entry, const std::vector<std::vector<int>>& neighbours,
                   Groups& groups)
{
    std::vector<std::size_t> taken;
    for (std::size_t b = entry.first; b < entry.end; ++b) {
        const bool touches = std::any_of(neighbours[b].begin(), neighbours[b].end(),
                                         [&](int other) { return groups.names[other] == rule.text; });
        if (touches && !groups.by_rule[b]) taken.push_back(b);
    }
    for (const std::size_t b : taken) {
        groups.names[b] = rule.group;
        groups.by_rule[b] = true;
    }
    rule.used = !taken.empty();
}

/// A rule that touches a group without blocks: misspelt, or filled by a later rule.
void refuse_unknown(const GroupRule& rule, const Groups& groups, const std::vector<EntryStones>& entries)
{
    bool comes_later = false;
    for (const EntryStones& entry : entries)
        for (const GroupRule& other : entry.belonging.rules)
            comes_later = comes_later || (other.by == By::touching && other.group == rule.text);
    const std::set<std::string> known(groups.names.begin(), groups.names.end());
    rule.written.fault(fmt::format("no block is in group \"{}\"{}", rule.text, comes_later ? " yet" : ""),
                       comes_later ? "rules by touch act in the order of writing: write that of the group first"
                                   : words::suggestion(rule.text, {known.begin(), known.end()}));
}

void take_by_touch(BlockReading& reading, Groups& groups)
{
    std::vector<std::vector<int>> neighbours;
    for (EntryStones& entry : reading.entries)
        for (GroupRule& rule : entry.belonging.rules) {
            if (rule.by != By::touching) continue;
            if (std::find(groups.names.begin(), groups.names.end(), rule.text) == groups.names.end()) {
                rule.used = true;  // this fault is enough
                refuse_unknown(rule, groups, reading.entries);
                continue;
            }
            if (neighbours.empty()) neighbours = neighbours_of(reading.model);
            take_by_touch(rule, entry, neighbours, groups);
        }
}

void refuse_unused(const EntryStones& entry)
{
    for (const GroupRule& rule : entry.belonging.rules) {
        if (rule.used || rule.text.empty()) continue;
        const bool by_name = rule.by == By::name;
        rule.written.fault(
            fmt::format("{} matches no stone left over from earlier {}",
                        by_name || rule.by == By::touching ? "\"" + rule.text + "\"" : rule.text,
                        by_name ? "patterns" : "rules"),
            by_name ? entry.naming : "a stone belongs to the first rule that fits it, by touch last");
    }
}

/// Index of a group, which is new or known; a fault and the first one for one too many.
int group_index(const std::string& name, const Block& block, BlockReading& reading)
{
    std::vector<std::string>& groups = reading.model.groups;
    const auto at = std::find(groups.begin(), groups.end(), name);
    const auto index = at - groups.begin();
    if (at != groups.end()) return static_cast<int>(index);
    if (groups.size() == max_groups) {
        reading.findings.faults.push_back({reading.places.at(block.name),
                                           fmt::format("more than {} groups", max_groups),
                                           "groups are for blocks that are treated alike"});
        return 0;
    }
    groups.push_back(name);
    return static_cast<int>(index);
}

void give_materials(const EntryStones& entry, const Groups& groups, BlockReading& reading)
{
    const MaterialChoice& choice = entry.belonging.material;
    for (std::size_t b = entry.first; b < entry.end; ++b) {
        const auto own = choice.of_group.find(groups.names[b]);
        if (own == choice.of_group.end() && !choice.common) {
            entry.belonging.entry.fault(
                fmt::format("no material for group \"{}\", of {}", groups.names[b], reading.model.blocks[b].name),
                "name it in material, or give a default there");
            return;
        }
        reading.model.blocks[b].material = own == choice.of_group.end() ? *choice.common : own->second;
    }
}

}  // namespace

void settle_groups(BlockReading& reading)
{
    Model& model = reading.model;
    if (model.blocks.empty()) return;
    Groups groups{std::vector<std::string>(model.blocks.size(), default_group),
                  std::vector<bool>(model.blocks.size(), false)};
    for (EntryStones& entry : reading.entries) take_each_by_itself(entry, model, groups);
    const bool is_sound = reading.findings.faults.empty();  // else touch is no touch, and the rest an echo
    if (is_sound) take_by_touch(reading, groups);
    for (const EntryStones& entry : reading.entries) {
        refuse_unused(entry);
        give_materials(entry, groups, reading);
    }
    for (std::size_t b = 0; b < model.blocks.size(); ++b)
        model.blocks[b].group = group_index(groups.names[b], model.blocks[b], reading);
}

}  // namespace voussoir::app::reader
