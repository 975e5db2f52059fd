#include "app/reader/block_reading.h"
#include "app/reader/blocks.h"

namespace voussoir::app::reader
{

std::vector<GroupPattern> read_group_patterns(YamlCursor& entry)
{
    std::vector<GroupPattern> patterns;
    std::optional<YamlCursor> groups = entry.find("groups");
    if (!groups) {
        entry.took_default("groups", std::string("all ") + default_group);
        return patterns;
    }
    for (auto& [group, value] : groups->named_entries("groups by name, {foundation: \"abutment_*\"}")) {
        if (!value.is_list()) {
            patterns.push_back({group, value.as_text(), value});
            continue;
        }
        for (const YamlCursor& item : value.items("patterns")) patterns.push_back({group, item.as_text(), item});
    }
    return patterns;
}

std::string group_of(const std::string& stone, std::vector<GroupPattern>& patterns)
{
    for (GroupPattern& pattern : patterns)
        if (matches_pattern(stone, pattern.pattern)) {
            pattern.used = true;
            return pattern.group;
        }
    return default_group;
}

void refuse_unused_patterns(const std::vector<GroupPattern>& patterns, const std::string& how_stones_are_named)
{
    for (const GroupPattern& pattern : patterns)
        if (!pattern.used && !pattern.pattern.empty())
            pattern.written.fault("\"" + pattern.pattern + "\" matches no stone left over from earlier patterns",
                                  how_stones_are_named);
}

}  // namespace voussoir::app::reader
