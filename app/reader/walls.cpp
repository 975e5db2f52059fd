// Walls and houses as a case file gives them.
#include "app/reader/pattern_keys.h"
#include "importers/patterns/house.h"
#include "importers/patterns/wall.h"

namespace voussoir::app::reader
{
namespace
{

/// The keys both have, after their own ones. @param has_base has the pattern a base by default?
template <class Pattern>
void read_common_keys(YamlCursor& map, bool has_base, Pattern& pattern, const BlockReading& reading)
{
    const Eigen::Vector2d block = read_block_format(map);
    pattern.block_length = block.x();
    pattern.block_height = block.y();
    map.choice_or<bool>("bond", {{"running", true}}, true);
    pattern.lintel = read_lintel(map, block, !pattern.openings.empty());
    pattern.base = read_base(map, has_base ? block.y() : 0);
    pattern.imperfection = read_imperfection(map);
    pattern.placement = read_placement(map, reading);
    map.reject_unknown_keys();
}

/// Makes the blocks with `make` and adds them, unless faults were found since there were `faults_before`.
template <class Make>
void finish(const YamlCursor& map, YamlCursor& entry, std::size_t faults_before, BlockReading& reading,
            const Make& make)
{
    Belonging beside = read_belonging(entry, reading.model, false);
    entry.reject_unknown_keys();
    if (reading.findings.faults.size() > faults_before) return;
    try {
        add_pattern(make(), map, std::move(beside), reading);
    } catch (const InputError& error) {
        place_faults(error, map);
    }
}

importers::patterns::HouseOpening read_house_opening(YamlCursor& map)
{
    importers::patterns::HouseOpening opening;
    const std::optional<importers::patterns::Side> side =
        map.find_choice<importers::patterns::Side>("wall", {{"south", importers::patterns::Side::south},
                                                            {"east", importers::patterns::Side::east},
                                                            {"north", importers::patterns::Side::north},
                                                            {"west", importers::patterns::Side::west}});
    if (!side) map.require("wall", "south, east, north or west");
    opening.side = side.value_or(importers::patterns::Side::south);
    opening.opening = read_opening(map);
    return opening;
}

/// `leaves`: their number, or their thicknesses.
void read_leaves(YamlCursor& map, importers::patterns::Wall& wall)
{
    const std::optional<YamlCursor> leaves = map.find("leaves");
    if (!leaves || !leaves->is_list()) {
        wall.leaves = map.integer_or("leaves", 1, 99, 1);
        return;
    }
    for (const YamlCursor& leaf : leaves->items("the thicknesses of the leaves, [30 cm, 50 cm, 30 cm]"))
        wall.leaf_thickness.push_back(leaf.as_quantity(words::dimension::length, words::Range::positive()));
    wall.leaves = static_cast<int>(wall.leaf_thickness.size());
}

}  // namespace

void read_wall(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!map.expect_map("a wall {length, height, thickness, block: [length, height], ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    importers::patterns::Wall asked;
    asked.name = read_pattern_name(map, "wall");
    asked.length = map.quantity("length", words::dimension::length, words::Range::positive());
    asked.height = map.quantity("height", words::dimension::length, words::Range::positive());
    asked.thickness = map.quantity("thickness", words::dimension::length, words::Range::positive());
    read_leaves(map, asked);
    if (asked.leaves > 1) asked.header_every = map.integer_or("header_every", 0, 1000, 0);
    if (const auto openings = map.find("openings"))
        for (YamlCursor& item : openings->items("a list of openings {at, sill, width, height}"))
            if (item.expect_map("an opening {at, sill, width, height}"))
                asked.openings.push_back(read_opening(item));
    read_common_keys(map, false, asked, reading);
    asked.flat = is_planar(reading.model.kinematics);
    finish(map, entry, faults_before, reading, [&] { return importers::patterns::wall(asked); });
}

void read_house(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (is_planar(reading.model.kinematics))
        return map.fault("a house in a planar scene", "use a wall, or set kinematics to a spatial one");
    if (!map.expect_map("a house {length, width, height, wall_thickness, block: [length, height], ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    importers::patterns::House asked;
    asked.name = read_pattern_name(map, "house");
    asked.length = map.quantity("length", words::dimension::length, words::Range::positive());
    asked.width = map.quantity("width", words::dimension::length, words::Range::positive());
    asked.height = map.quantity("height", words::dimension::length, words::Range::positive());
    asked.wall_thickness = map.quantity("wall_thickness", words::dimension::length, words::Range::positive());
    if (const auto openings = map.find("openings"))
        for (YamlCursor& item : openings->items("a list of openings {wall, at, sill, width, height}"))
            if (item.expect_map("an opening {wall, at, sill, width, height}"))
                asked.openings.push_back(read_house_opening(item));
    read_common_keys(map, true, asked, reading);
    finish(map, entry, faults_before, reading, [&] { return importers::patterns::house(asked); });
}

}  // namespace voussoir::app::reader
