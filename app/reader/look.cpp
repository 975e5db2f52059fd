#include "app/reader/look.h"

#include <algorithm>
#include <functional>
#include <numbers>

#include "app/words/look_words.h"
#include "importers/helper/stone_choice.h"

namespace voussoir::app::reader
{
namespace
{

using importers::helper::matches_pattern;

/// One text, or a list of them. @param take of each, with its place
void read_texts(YamlCursor& map, const char* key, const char* example,
                const std::function<void(const YamlCursor& place, const std::string& text)>& take)
{
    const std::optional<YamlCursor> value = map.find(key);
    if (!value) return;
    if (!value->is_list()) return take(*value, value->as_text());
    for (const YamlCursor& item : value->items(example)) take(item, item.as_text());
}

bool has_name(const Block& block, const Model& model, const std::string& pattern, bool groups)
{
    const auto group = static_cast<std::size_t>(block.group);
    return matches_pattern(block.name, pattern) ||
           (groups && group < model.groups.size() && matches_pattern(model.groups[group], pattern));
}

/// A pattern that some stone has. Without blocks there are faults already, and this would be their echo.
void expect_named(const YamlCursor& place, const std::string& pattern, const Model& model, bool groups)
{
    const bool found = std::any_of(model.blocks.begin(), model.blocks.end(),
                                   [&](const Block& block) { return has_name(block, model, pattern, groups); });
    if (found || model.blocks.empty() || pattern.empty()) return;
    place.fault("\"" + pattern + "\" is the name of no stone" + (groups ? " and of no group" : ""),
                "give names, or patterns with * and ?");
}

/// Stones that are hidden must leave one.
void expect_a_stone(const YamlCursor& map, const Model& model, const LookOptions& look)
{
    if (model.blocks.empty() || (look.hidden.empty() && look.cuts.empty())) return;
    const auto is_hidden = [&](const Block& block) {
        const bool named = std::any_of(look.hidden.begin(), look.hidden.end(), [&](const std::string& pattern) {
            return has_name(block, model, pattern, true);
        });
        return named || std::any_of(look.cuts.begin(), look.cuts.end(), [&](const std::string& text) {
                   const std::optional<words::Cut> cut = words::cut_named(text);
                   return cut && cut->takes(block.moments.centroid);
               });
    };
    if (std::all_of(model.blocks.begin(), model.blocks.end(), is_hidden))
        map.fault("no stone is left", "hide fewer, or cut less away");
}

void read_stones(YamlCursor& map, const Model& model, LookOptions& look)
{
    read_texts(map, "hide", "names, [roof, \"wall_*\"]", [&](const YamlCursor& place, const std::string& text) {
        expect_named(place, text, model, true);
        look.hidden.push_back(text);
    });
    read_texts(map, "cut", "places, [\"y<0.3\"]", [&](const YamlCursor& place, const std::string& text) {
        if (!words::cut_named(text)) return place.fault("\"" + text + "\"", words::cut_expected);
        look.cuts.push_back(text);
    });
    read_texts(map, "label", "names, [keystone]", [&](const YamlCursor& place, const std::string& text) {
        expect_named(place, text, model, false);
        look.labels.push_back(text);
    });
    expect_a_stone(map, model, look);
}

bool shakes_a_foundation(const std::vector<Stage>& stages)
{
    return std::any_of(stages.begin(), stages.end(), [](const Stage& stage) { return !stage.motions.empty(); });
}

}  // namespace

LookOptions read_look(YamlCursor& map, const Model& model, const std::vector<Stage>& stages, bool film)
{
    LookOptions look;
    read_stones(map, model, look);
    if (const std::optional<YamlCursor> view = map.find("view")) {
        look.view = view->as_text();
        if (!words::view_named(look.view)) view->fault("\"" + look.view + "\"", words::view_expected);
    }
    if (const std::optional<YamlCursor> follow = map.find("follow")) {
        look.follow = follow->as_text();
        if (look.follow != words::whole_structure)
            expect_named(*follow, look.follow, model, true);
        else if (!model.blocks.empty() && model.foundations.size() == model.blocks.size())
            follow->fault("a scene of foundations alone", "follow nothing");
    }
    if (map.find("orthographic")) look.orthographic = map.boolean_or("orthographic", false);
    if (map.find("forces")) look.forces = map.boolean_or("forces", false);
    if (const std::optional<YamlCursor> ground = map.find("ground")) {
        look.ground = map.boolean_or("ground", false);
        if (look.ground && !stages.empty() && !shakes_a_foundation(stages))
            ground->fault("an arrow where no foundation follows a motion", "leave ground out");
    }
    if (film && map.find("orbit"))
        look.orbit =
            map.quantity_or("orbit", words::dimension::angle, words::Range::any(), 0) * 180 / std::numbers::pi;
    return look;
}

}  // namespace voussoir::app::reader
