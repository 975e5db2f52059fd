#include "app/reader/pattern_keys.h"

#include <fmt/core.h>

#include <charconv>
#include <limits>
#include <map>

#include "libdda/geometry/plane.h"

namespace voussoir::app::reader
{
namespace
{

/// The value a path such as "storeys[1].height" or "lintel.height" leads to, or the last one on the way that
/// exists.
YamlCursor follow(YamlCursor from, std::string_view path)
{
    const std::size_t end = path.find_first_of(".[");
    std::optional<YamlCursor> next = from.find(std::string(path.substr(0, end)));
    if (!next || end == std::string_view::npos) return next.value_or(from);
    if (path[end] == '.') return follow(*next, path.substr(end + 1));
    std::size_t index = 0;
    std::from_chars(path.data() + end + 1, path.data() + path.size(), index);
    if (!next->is_list()) return *next;
    const std::vector<YamlCursor> items = next->items("a list");
    if (index >= items.size()) return *next;
    const std::size_t dot = path.find('.', end);  // "storeys[1].height" goes on
    return dot == std::string_view::npos ? items[index] : follow(items[index], path.substr(dot + 1));
}

}  // namespace

std::string read_pattern_name(YamlCursor& map, const std::string& otherwise)
{
    const std::optional<std::string> name = map.find_text("name");
    if (!name) map.took_default("name", otherwise);
    return name.value_or(otherwise);
}

Eigen::Vector2d read_block_format(YamlCursor& map)
{
    Eigen::Vector2d format = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
    const std::optional<YamlCursor> value = map.require("block", "length and height of a block, [60 cm, 30 cm]");
    if (!value) return format;
    if (!value->is_list_of(2)) {
        value->fault(value->found(), "expected length and height of a block, [60 cm, 30 cm]");
        return format;
    }
    const std::vector<YamlCursor> sizes = value->items("length and height of a block");
    for (int i = 0; i < 2; ++i)
        format[i] = sizes[i].as_quantity(words::dimension::length, words::Range::positive());
    return format;
}

importers::patterns::Opening read_opening(YamlCursor& map)
{
    importers::patterns::Opening opening;
    opening.at = map.quantity("at", words::dimension::length, words::Range::non_negative());
    opening.sill = map.quantity_or("sill", words::dimension::length, words::Range::non_negative(), 0);
    opening.width = map.quantity("width", words::dimension::length, words::Range::positive());
    opening.height = map.quantity("height", words::dimension::length, words::Range::positive());
    map.reject_unknown_keys();
    return opening;
}

importers::patterns::Lintel read_lintel(YamlCursor& map, const Eigen::Vector2d& block, bool needed)
{
    importers::patterns::Lintel lintel{block.y(), block.x() / 2};
    std::optional<YamlCursor> keys = map.find("lintel");
    if (!keys) {
        if (needed)
            map.took_default("lintel",
                             fmt::format("{{height: {:g} m, bearing: {:g} m}}", lintel.height, lintel.bearing));
        return lintel;
    }
    if (!keys->expect_map("a lintel {height, bearing}")) return lintel;
    lintel.height = keys->quantity_or("height", words::dimension::length, words::Range::positive(), lintel.height);
    lintel.bearing =
        keys->quantity_or("bearing", words::dimension::length, words::Range::positive(), lintel.bearing);
    keys->reject_unknown_keys();
    return lintel;
}

importers::patterns::MasonryBase read_base(YamlCursor& map, double otherwise)
{
    std::optional<YamlCursor> keys = map.find("base");
    if (!keys) {
        map.took_default("base", otherwise > 0 ? fmt::format("{{height: {:g} m}}", otherwise) : "none");
        return {otherwise, 0};
    }
    if (!keys->expect_map("a base {height, projection}")) return {};
    importers::patterns::MasonryBase base;
    base.height = keys->quantity("height", words::dimension::length, words::Range::positive());
    base.projection = keys->quantity_or("projection", words::dimension::length, words::Range::non_negative(), 0);
    keys->reject_unknown_keys();
    return base;
}

importers::patterns::Imperfection read_imperfection(YamlCursor& map)
{
    importers::patterns::Imperfection imperfection;
    std::optional<YamlCursor> keys = map.find("imperfection");
    if (!keys || !keys->expect_map("imperfections {seed, size, joint, friction}")) return imperfection;
    imperfection.seed =
        static_cast<std::uint64_t>(keys->integer_or("seed", 0, std::numeric_limits<int>::max(), 1));
    imperfection.size = keys->quantity_or("size", words::dimension::number, words::Range::non_negative(), 0);
    imperfection.joint = keys->quantity_or("joint", words::dimension::length, words::Range::non_negative(), 0);
    imperfection.friction =
        keys->quantity_or("friction", words::dimension::number, words::Range::non_negative(), 0);
    keys->reject_unknown_keys();
    return imperfection;
}

importers::patterns::Placement read_placement(YamlCursor& map, const BlockReading& reading)
{
    const bool planar = is_planar(reading.model.kinematics);
    importers::patterns::Placement placement;
    if (const std::optional<YamlCursor> origin = map.find("origin"))
        placement.origin = planar && origin->is_list_of(2)
                               ? to_space(origin->as_plane_vector(words::dimension::length))
                               : origin->as_vector(words::dimension::length);
    else
        map.took_default("origin", "[0, 0, 0]");
    if (planar)
        map.forbid("direction", "a wall of a planar scene runs along x");
    else
        placement.direction = map.quantity_or("direction", words::dimension::angle, words::Range::any(), 0);
    return placement;
}

void place_faults(const InputError& error, const YamlCursor& map)
{
    for (const Fault& fault : error.faults) follow(map, fault.place).fault(fault.found, fault.expected);
}

namespace
{

/// A fault if a block of one of these names is there already.
bool refuse_known_names(const std::vector<DrawnStone>& stones, const YamlCursor& map, const Belonging& belonging,
                        const BlockReading& reading)
{
    for (const PlacedCopy& copy : belonging.copies)
        for (const DrawnStone& stone : stones) {
            const auto known = reading.places.find(stone.name + copy.suffix);
            if (known == reading.places.end()) continue;
            map.fault("a second block named " + known->first,
                      "the first one is at " + known->second + ": give one of them another name");
            return true;
        }
    return false;
}

void add_drawn(std::vector<DrawnStone> stones, const YamlCursor& map, Belonging belonging, BlockReading& reading)
{
    if (stones.empty()) return map.fault("no block remains", "reduce the openings");
    if (refuse_known_names(stones, map, belonging, reading)) return;
    const std::string naming = "blocks are named " + stones.front().name + ", ..., " + stones.back().name;
    add_stones(std::move(stones), map, std::move(belonging), naming, reading);
}

std::vector<DrawnStone> drawn(importers::patterns::Pattern pattern)
{
    std::vector<DrawnStone> stones;
    std::map<std::string, std::size_t> numbers;
    for (importers::patterns::PatternStone& stone : pattern.stones) {
        numbers[stone.name] = stones.size();
        stones.push_back({stone.name, std::move(stone.parts), {}, stone.friction_factor, stone.group, {}});
    }
    for (const importers::patterns::PatternMass& mass : pattern.masses)
        stones[numbers.at(mass.stone)].masses.push_back({mass.mass, mass.at});
    return stones;
}

}  // namespace

importers::patterns::StoneImperfection read_stone_imperfection(YamlCursor& map)
{
    importers::patterns::StoneImperfection imperfection;
    std::optional<YamlCursor> keys = map.find("imperfection");
    if (!keys || !keys->expect_map("imperfections {seed, size, joint, position, friction}")) return imperfection;
    const auto share = [&](const std::string& key) {
        return keys->quantity_or(key, words::dimension::number, words::Range::non_negative(), 0);
    };
    imperfection.seed =
        static_cast<std::uint64_t>(keys->integer_or("seed", 0, std::numeric_limits<int>::max(), 1));
    imperfection.size = share("size");
    imperfection.joint = keys->quantity_or("joint", words::dimension::length, words::Range::non_negative(), 0);
    imperfection.position = share("position");
    imperfection.friction = share("friction");
    keys->reject_unknown_keys();
    return imperfection;
}

std::string read_name_prefix(YamlCursor& map)
{
    const std::optional<std::string> name = map.find_text("name");
    return name && !name->empty() ? *name + "_" : "";
}

void finish_pattern(YamlCursor& entry, const YamlCursor& map, std::size_t faults_before,
                    const std::vector<std::string>& groups,
                    const std::function<importers::patterns::Pattern()>& make, BlockReading& reading)
{
    map.reject_unknown_keys();
    Belonging belonging = read_belonging(entry, reading.model, false, groups);
    entry.reject_unknown_keys();
    if (reading.findings.faults.size() > faults_before) return;
    try {
        add_drawn(drawn(make()), map, std::move(belonging), reading);
    } catch (const InputError& error) {
        place_faults(error, map);
    }
}

void add_pattern(const std::vector<importers::patterns::MasonryBlock>& blocks, const YamlCursor& map,
                 Belonging belonging, BlockReading& reading)
{
    std::vector<DrawnStone> stones;
    stones.reserve(blocks.size());
    try {
        for (const importers::patterns::MasonryBlock& block : blocks)
            stones.push_back({block.name, {importers::patterns::to_polyhedron(block)}, {}, block.friction_factor});
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults) map.fault(fault.place + ": " + fault.found, fault.expected);
    }
    add_drawn(std::move(stones), map, std::move(belonging), reading);
}

}  // namespace voussoir::app::reader
