// `groups` of an entry, as it is written.
#include <array>
#include <cmath>

#include "app/reader/block_reading.h"
#include "app/reader/plane.h"

namespace voussoir::app::reader
{
namespace
{

/// `5 %` of the height, or `10 cm`.
void read_reach(const YamlCursor& value, GroupRule& rule)
{
    const std::string expected = "expected a share of the height such as 5 %, or a length such as 10 cm";
    const std::string text = value.is_scalar() ? value.as_text() : "";
    const words::ParsedQuantity quantity = words::parse_quantity(text);
    rule.text = text;
    rule.reach = quantity.value;
    rule.is_share = quantity.has(words::dimension::number);
    if (text.empty() || !quantity.problem.empty() || quantity.bare) {
        const bool lacks_unit = !text.empty() && quantity.problem.empty();
        value.fault(value.found() + (lacks_unit ? " has no unit; the unit determines the meaning" : ""), expected);
    } else if (!rule.is_share && !quantity.has(words::dimension::length)) {
        value.fault(value.found() + " has the wrong dimension", expected);
    } else if (quantity.value < 0 || (rule.is_share && quantity.value > 1)) {
        value.fault(text, rule.is_share ? "must be >= 0 and at most 100 %" : "must be >= 0");
    }
}

/// `{lower: [x, y, z], upper: [x, y, z]}`
void read_room(YamlCursor& room, Kinematics kinematics, GroupRule& rule)
{
    if (!room.expect_map("a box {lower: [x, y, z], upper: [x, y, z]}")) return;
    const auto corner = [&](const std::string& key) -> Eigen::Vector3d {
        const auto value = room.require(key, "the " + key + " corner [x, y, z]");
        return value ? read_place(*value, kinematics) : Eigen::Vector3d::Constant(std::nan(""));
    };
    rule.lower = corner("lower");
    rule.upper = corner("upper");
    room.reject_unknown_keys();
    if ((rule.upper.array() < rule.lower.array()).any())
        room.fault("no volume", "upper must exceed lower along every axis");
    rule.text = "this box";
}

/// `{lowest: 5 %}`, `{inside: {lower, upper}}`, ...: one of the four.
void read_place_rule(YamlCursor& map, Kinematics kinematics, GroupRule& rule)
{
    using By = GroupRule::By;
    constexpr std::array<std::pair<const char*, By>, 4> kinds = {
        {{"lowest", By::lowest}, {"highest", By::highest}, {"inside", By::inside}, {"touching", By::touching}}};
    std::optional<YamlCursor> chosen;
    int count = 0;
    for (const auto& [key, by] : kinds) {
        std::optional<YamlCursor> value = map.find(key);
        if (!value) continue;
        ++count;
        rule.by = by;
        chosen = std::move(value);
    }
    map.reject_unknown_keys();
    if (count != 1)
        return map.fault(count == 0 ? "no rule" : "more than one rule",
                         "give lowest, highest, inside or touching; several rules are a list");
    rule.written = *chosen;
    if (rule.by == By::inside)
        read_room(*chosen, kinematics, rule);
    else if (rule.by == By::touching)
        rule.text = chosen->as_text();
    else
        read_reach(*chosen, rule);
}

GroupRule read_rule(const std::string& group, YamlCursor value, Kinematics kinematics)
{
    GroupRule rule{group, value, {}};
    if (value.is_map())
        read_place_rule(value, kinematics, rule);
    else
        rule.text = value.as_text();
    return rule;
}

}  // namespace

std::vector<GroupRule> read_group_rules(YamlCursor& entry, Kinematics kinematics)
{
    std::vector<GroupRule> rules;
    std::optional<YamlCursor> groups = entry.find("groups");
    if (!groups) return rules;
    for (auto& [group, value] : groups->named_entries("groups by name, {foundation: \"abutment_*\"}")) {
        if (!value.is_list()) {
            rules.push_back(read_rule(group, value, kinematics));
            continue;
        }
        for (const YamlCursor& item : value.items("patterns")) rules.push_back(read_rule(group, item, kinematics));
    }
    return rules;
}

}  // namespace voussoir::app::reader
