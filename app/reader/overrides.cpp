#include "app/reader/overrides.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

#include "app/reader/renamed_keys.h"

namespace voussoir::app::reader
{
namespace
{

/// One step of a path: a key, or a position in a list.
struct PathStep {
    std::string key;
    int position = -1;  // >= 0: of a list
};

/// "stages[1].time_step" -> stages, [1], time_step. @returns empty when it is no path
std::vector<PathStep> split_path(std::string_view path)
{
    std::vector<PathStep> steps;
    while (!path.empty()) {
        if (path.front() == '[') {
            int position = -1;
            const auto [end, error] = std::from_chars(path.data() + 1, path.data() + path.size(), position);
            const bool closed = error == std::errc{} && end != path.data() + path.size() && *end == ']';
            if (!closed || position < 0 || steps.empty()) return {};
            path.remove_prefix(end + 1 - path.data());
            steps.push_back({"", position});
        } else {
            if (!steps.empty() && path.front() != '.') return {};
            if (!steps.empty()) path.remove_prefix(1);
            const std::size_t end = std::min(path.find_first_of(".["), path.size());
            if (end == 0) return {};
            steps.push_back({std::string(path.substr(0, end)), -1});
            path.remove_prefix(end);
            if (path == ".") return {};
        }
    }
    return steps;
}

void set_origin(YamlNode& node, const std::string& origin)
{
    node.origin = origin;
    for (YamlNode& item : node.items) set_origin(item, origin);
}

/// Position of a key in a map, or the number of its keys. One that stands there under its former name, or under
/// its present one when the former is asked for, takes the name that is asked for: the last word is the user's.
std::size_t position_of(YamlNode& map, const std::string& key)
{
    for (const std::string_view name : {std::string_view(key), former_name(key), present_name(key)}) {
        const auto at = name.empty() ? map.keys.end() : std::find(map.keys.begin(), map.keys.end(), name);
        if (at == map.keys.end()) continue;
        *at = key;
        return at - map.keys.begin();
    }
    return map.keys.size();
}

/// The child a step leads to, made if it is not there. @returns null with a fault when there is no way
YamlNode* step_into(YamlNode& node, const PathStep& step, const std::string& place, Findings& findings)
{
    const bool is_list = step.position >= 0;
    const YamlNode::Kind kind = is_list ? YamlNode::Kind::list : YamlNode::Kind::map;
    if (node.kind == YamlNode::Kind::null) node.kind = kind;
    if (node.kind != kind) {
        const std::string wanted = is_list ? fmt::format("[{}]", step.position) : step.key;
        findings.faults.push_back(
            {place, fmt::format("cannot set {} in {}", wanted, describe(node)),
             is_list ? "only lists have positions" : "only maps have keys; list items are written as name[0]"});
        return nullptr;
    }
    const std::size_t index = is_list ? step.position : position_of(node, step.key);
    if (index > node.items.size()) {
        findings.faults.push_back({place, fmt::format("no position [{}]", step.position),
                                   fmt::format("the list has {} entries, from [0]", node.items.size())});
        return nullptr;
    }
    if (index == node.items.size()) {
        node.items.emplace_back().origin = place;
        if (!is_list) node.keys.push_back(step.key);
    }
    return &node.items[index];
}

void take_away(YamlNode& parent, const PathStep& step)
{
    std::size_t index = step.position;
    if (step.position < 0) {
        index = std::find(parent.keys.begin(), parent.keys.end(), step.key) - parent.keys.begin();
        if (index < parent.keys.size())
            parent.keys.erase(parent.keys.begin() + static_cast<std::ptrdiff_t>(index));
    }
    if (index < parent.items.size()) parent.items.erase(parent.items.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace

void apply_override(const std::string& setting, YamlNode& root, Findings& findings)
{
    const std::size_t equals = setting.find('=');
    const std::string path = setting.substr(0, equals);
    const std::string place = "--set " + path;
    const std::vector<PathStep> steps = split_path(path);
    if (equals == std::string::npos || steps.empty()) {
        findings.faults.push_back({place, "not a setting", "write key=value, as in stages[1].time_step=\"1 ms\""});
        return;
    }
    YamlNode value;
    try {
        value = parse_yaml(setting.substr(equals + 1), place, false);
    } catch (const InputError& error) {
        findings.faults.insert(findings.faults.end(), error.faults.begin(), error.faults.end());
        return;
    }
    set_origin(value, place);
    YamlNode* parent = &root;
    for (std::size_t i = 0; i + 1 < steps.size() && parent != nullptr; ++i)
        parent = step_into(*parent, steps[i], place, findings);
    YamlNode* target = parent == nullptr ? nullptr : step_into(*parent, steps.back(), place, findings);
    if (target == nullptr) return;
    *target = std::move(value);
    if (target->kind == YamlNode::Kind::null) take_away(*parent, steps.back());
}

}  // namespace voussoir::app::reader
