// Towers as a case file gives them.
#include "app/reader/pattern_keys.h"
#include "importers/patterns/tower.h"

namespace voussoir::app::reader
{

namespace patterns = importers::patterns;
using words::Range;
namespace dimension = words::dimension;

namespace
{

patterns::TowerOpening read_tower_opening(YamlCursor& map, int sides)
{
    patterns::TowerOpening opening;
    if (sides == 8)
        opening.side = map.choice_or<int>("side",
                                          {{"south", 0},
                                           {"southeast", 1},
                                           {"east", 2},
                                           {"northeast", 3},
                                           {"north", 4},
                                           {"northwest", 5},
                                           {"west", 6},
                                           {"southwest", 7}},
                                          0);
    else
        opening.side = map.choice_or<int>("side", {{"south", 0}, {"east", 1}, {"north", 2}, {"west", 3}}, 0);
    opening.sill = map.quantity_or("sill", dimension::length, Range::non_negative(), 0);
    opening.width = map.quantity("width", dimension::length, Range::positive());
    opening.height = map.quantity("height", dimension::length, Range::positive());
    map.reject_unknown_keys();
    return opening;
}

patterns::Storey read_storey(YamlCursor& map, int sides, int number)
{
    patterns::Storey storey;
    storey.name = map.find_text("name").value_or("storey_" + std::to_string(number));
    storey.height = map.quantity("height", dimension::length, Range::positive());
    storey.thickness = map.quantity("thickness", dimension::length, Range::positive());
    storey.floor = map.quantity_or("floor", dimension::mass, Range::non_negative(), 0);
    const std::string form = "a list of openings {side, sill, width, height}";
    if (const auto openings = map.find("openings"))
        for (YamlCursor& item : openings->items(form))
            if (item.expect_map("an opening {side, sill, width, height}"))
                storey.openings.push_back(read_tower_opening(item, sides));
    map.reject_unknown_keys();
    return storey;
}

}  // namespace

void read_tower(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (is_planar(reading.model.kinematics))
        return map.fault("a tower in a planar scene", "use a wall, or set kinematics to a spatial one");
    if (!map.expect_map("a tower {plan, width, block: [length, height], storeys: [...]}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    patterns::Tower asked;
    asked.name = read_name_prefix(map);
    asked.sides = map.choice_or<int>("plan", {{"square", 4}, {"octagonal", 8}, {"round", 0}}, 4);
    asked.width = map.quantity("width", dimension::length, Range::positive());
    const Eigen::Vector2d block = read_block_format(map);
    asked.block = {block.x(), block.y()};
    asked.bearing = map.quantity_or("bearing", dimension::length, Range::positive(), block.x() / 2);
    std::vector<std::string> groups{patterns::foundation_group};
    if (const auto storeys = map.require("storeys", "storeys from below, [{height: 5 m, thickness: 1 m}]"))
        for (YamlCursor& item : storeys->items("a list of storeys {height, thickness, openings, floor}"))
            if (item.expect_map("a storey {height, thickness, openings, floor}")) {
                asked.storeys.push_back(
                    read_storey(item, asked.sides, static_cast<int>(asked.storeys.size()) + 1));
                groups.push_back(asked.storeys.back().name);
            }
    const patterns::MasonryBase base = read_base(map, asked.base_height);
    asked.base_height = base.height;
    asked.base_projection = base.projection;
    asked.imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before, groups, [&] { return patterns::tower(asked); }, reading);
}

}  // namespace voussoir::app::reader
