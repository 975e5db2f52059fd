#include <algorithm>

#include "app/reader/block_reading.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{

/// Index of the material that a value names; the first one, with a fault, if there is none.
int material_at(const YamlCursor& value, const std::vector<std::string>& names)
{
    const std::string name = value.as_text();
    const auto at = std::find(names.begin(), names.end(), name);
    if (at != names.end()) return static_cast<int>(at - names.begin());
    if (!name.empty()) value.fault("no material \"" + name + "\"", words::suggestion(name, names));
    return 0;
}

/// `{voussoirs: granite, default: brick}`; groups are those of the entry.
MaterialChoice read_materials_by_group(YamlCursor& value, const std::vector<std::string>& names,
                                       const Belonging& belonging, std::vector<std::string> groups)
{
    groups.push_back(belonging.group);
    for (const GroupRule& rule : belonging.rules)
        if (std::find(groups.begin(), groups.end(), rule.group) == groups.end()) groups.push_back(rule.group);
    MaterialChoice choice;
    for (auto& [group, name] : value.named_entries("materials by group, {voussoirs: granite, default: brick}")) {
        if (std::find(groups.begin(), groups.end(), group) != groups.end())
            choice.of_group[group] = material_at(name, names);
        else if (group == "default")
            choice.common = material_at(name, names);
        else
            name.fault("no group \"" + group + "\" in this entry", words::suggestion(group, groups));
    }
    return choice;
}

MaterialChoice read_material(YamlCursor& entry, const std::vector<BlockMaterial>& materials,
                             const Belonging& belonging, const std::vector<std::string>& own_groups)
{
    std::vector<std::string> names;
    names.reserve(materials.size());
    for (const BlockMaterial& material : materials) names.push_back(material.name);
    std::optional<YamlCursor> value = entry.find("material");
    if (!value && names.size() == 1) {
        entry.took_default("material", names[0]);
        return {0, {}};
    }
    if (!value) {
        entry.require("material", "a material's name");
        return {0, {}};
    }
    if (value->is_map()) return read_materials_by_group(*value, names, belonging, own_groups);
    return {material_at(*value, names), {}};
}

}  // namespace

Belonging read_belonging(YamlCursor& entry, const Model& model, bool has_name,
                         const std::vector<std::string>& own_groups)
{
    Belonging belonging{entry, {}, default_group, {}, {}, false};
    const std::optional<std::string> group = entry.find_text("group");
    belonging.group = group.value_or(default_group);
    belonging.keeps_own_groups = !group && !own_groups.empty();
    belonging.rules = read_group_rules(entry, model.kinematics);
    belonging.material =
        read_material(entry, model.materials, belonging, group ? std::vector<std::string>() : own_groups);
    if (!group && has_name) entry.took_default("group", default_group);
    if (!group && !has_name && own_groups.empty() && belonging.rules.empty())
        entry.took_default("groups", std::string("all ") + default_group);
    belonging.copies = read_placing(entry, model.kinematics);
    return belonging;
}

}  // namespace voussoir::app::reader
