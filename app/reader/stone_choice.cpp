#include "app/reader/stone_choice.h"

#include <algorithm>

#include "app/words/nearest_word.h"
#include "libdda/errors.h"

namespace voussoir::app::reader
{
namespace
{

using importers::helper::RepairRule;
using importers::helper::StoneSimplification;

constexpr int most_parts = 64, most_triangles = 10'000'000;

/// A pattern or a list of them.
std::vector<std::string> read_patterns(YamlCursor& map, const std::string& key, const std::string& path,
                                       std::vector<ChosenPattern>& all)
{
    std::vector<std::string> patterns;
    const std::optional<YamlCursor> value = map.find(key);
    if (!value) return patterns;
    const std::vector<YamlCursor> items =
        value->is_list() ? value->items("names of stones, [\"keystone*\"]") : std::vector<YamlCursor>{*value};
    if (items.empty()) value->fault("no pattern", "give the name of a stone, in which * and ? stand for others");
    for (const YamlCursor& item : items) {
        patterns.push_back(item.as_text());
        if (patterns.back().empty()) continue;  // is a fault already
        all.push_back({path, patterns.back(), item});
    }
    return patterns;
}

/// 0 when the key is absent, and no default is told: then something else says how far to go.
int read_count(YamlCursor& map, const std::string& key, int lowest, int highest)
{
    YamlCursor look = map;
    return look.find(key) ? map.integer_or(key, lowest, highest, lowest) : (map.find(key), 0);
}

StoneSimplification read_simplification(YamlCursor& value, std::vector<ChosenPattern>& patterns)
{
    StoneSimplification simplify;
    if (value.is_scalar()) {
        simplify.hull = value.as_text() == "hull";
        if (!simplify.hull)
            value.fault("\"" + value.found() + "\" is no way to simplify",
                        "expected hull or {parts: 12, volume_error: 2 %}");
        return simplify;
    }
    if (!value.expect_map("hull or {parts: 12, volume_error: 2 %}")) return simplify;
    simplify.parts = read_count(value, "parts", 1, most_parts);
    simplify.volume_error =
        value.find_quantity("volume_error", words::dimension::number, words::Range{0, 1, false, true}).value_or(0);
    simplify.triangles = read_count(value, "triangles", 4, most_triangles);
    simplify.stones = read_patterns(value, "stones", "simplify.stones", patterns);
    value.reject_unknown_keys();
    if (!simplify.is_asked()) value.fault("nothing to simplify to", "give parts, volume_error or triangles");
    return simplify;
}

}  // namespace

std::vector<ChosenPattern> read_stone_choice(YamlCursor& entry, importers::helper::MeshRequest& request)
{
    std::vector<ChosenPattern> patterns;
    importers::helper::StoneChoice& choice = request.choice;
    choice.skip = read_patterns(entry, "skip", "skip", patterns);
    choice.only = read_patterns(entry, "only", "only", patterns);
    choice.hull = read_patterns(entry, "hull", "hull", patterns);
    choice.skip_types = read_patterns(entry, "skip_types", "skip_types", patterns);
    choice.repair = entry.choice_or<RepairRule>(
        "repair", {{"refuse", RepairRule::refuse}, {"hull", RepairRule::hull}, {"skip", RepairRule::skip}},
        RepairRule::refuse);
    YamlCursor look = entry;
    if (const std::optional<YamlCursor> word = look.find("simplify"); word && word->is_scalar())
        request.simplify.hull = entry.find_choice<bool>("simplify", {{"hull", true}}).value_or(false);
    else if (std::optional<YamlCursor> simplify = entry.find("simplify"))
        request.simplify = read_simplification(*simplify, patterns);
    return patterns;
}

std::vector<std::string> names_of_stones(const importers::helper::ImportedMesh& mesh)
{
    std::vector<std::string> names;
    for (const importers::helper::Stone& stone : mesh.stones) names.push_back(stone.name);
    for (const importers::helper::SkippedStone& stone : mesh.skipped) names.push_back(stone.name);
    return names;
}

void refuse_unmatched_patterns(const std::vector<ChosenPattern>& patterns,
                               const importers::helper::ImportedMesh& mesh)
{
    for (const importers::helper::UnmatchedPattern& unmatched : mesh.unmatched)
        for (const ChosenPattern& pattern : patterns)
            if (pattern.key == unmatched.key && pattern.pattern == unmatched.pattern)
                pattern.written.fault("\"" + pattern.pattern + "\" matches no stone",
                                      words::suggestion(pattern.pattern, names_of_stones(mesh)));
}

std::string cure_of(const importers::helper::Stone& stone)
{
    const std::string name = "\"" + stone.name + "\"";
    if (stone.cure == "simplify")
        return "repair it, or give simplify: {parts: 16, stones: " + name + "}, hull: " + name +
               " or skip: " + name;
    if (stone.cure == "hull") return "repair it, or give hull: " + name + " or skip: " + name;
    return "repair it, or give skip: " + name;
}

StoneSimplification parse_simplification(const std::string& text, const std::string& option)
{
    Findings findings;
    findings.file = option;
    std::vector<ChosenPattern> patterns;
    const YamlNode tree = parse_yaml(text, option, false);
    YamlCursor value(tree, "", findings);
    StoneSimplification simplify = read_simplification(value, patterns);
    if (!findings.faults.empty()) throw InputError(std::move(findings.faults));
    return simplify;
}

}  // namespace voussoir::app::reader
