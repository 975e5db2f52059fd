// Columns and temple fronts as a case file gives them.
#include "app/reader/pattern_keys.h"
#include "importers/patterns/column.h"

namespace voussoir::app::reader
{

namespace patterns = importers::patterns;
using words::Range;
namespace dimension = words::dimension;

namespace
{

patterns::Column read_column_keys(YamlCursor& map)
{
    patterns::Column column;
    column.height = map.quantity("height", dimension::length, Range::positive());
    column.diameter = map.quantity("diameter", dimension::length, Range::positive());
    column.top_diameter = map.quantity_or("top_diameter", dimension::length, Range::positive(), column.diameter);
    column.entasis = map.quantity_or("entasis", dimension::length, Range::non_negative(), 0);
    column.drums = map.integer_or("drums", 1, 999, column.drums);
    column.sides = map.integer_or("sides", 4, 64, column.sides);
    std::optional<YamlCursor> capital = map.find("capital");
    if (!capital || !capital->expect_map("a capital {height, width}")) return column;
    column.capital_height = capital->quantity("height", dimension::length, Range::positive());
    column.capital_width = capital->quantity("width", dimension::length, Range::positive());
    capital->reject_unknown_keys();
    return column;
}

bool is_spatial(const YamlCursor& map, const BlockReading& reading)
{
    if (is_planar(reading.model.kinematics))
        map.fault("a column in a planar scene", "set kinematics to a spatial one");
    return !is_planar(reading.model.kinematics);
}

}  // namespace

void read_column(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!is_spatial(map, reading) || !map.expect_map("a column {height, diameter, drums, ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    const patterns::Column asked = read_column_keys(map);
    const patterns::StoneImperfection imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before, {patterns::foundation_group, "drums", "capital"},
        [&] {
            patterns::Pattern pattern = patterns::column(asked, name);
            check_and_disturb(pattern, imperfection);
            return pattern;
        },
        reading);
}

void read_temple_front(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!is_spatial(map, reading) || !map.expect_map("a temple front {columns, spacing, height, diameter, ...}"))
        return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    const auto length = [&](const char* key, double otherwise) {
        return map.quantity_or(key, dimension::length, Range::non_negative(), otherwise);
    };
    patterns::TempleFront asked;
    asked.column = read_column_keys(map);
    asked.columns = map.integer_or("columns", 1, 999, asked.columns);
    asked.spacing = map.quantity("spacing", dimension::length, Range::positive());
    asked.architrave = length("architrave", asked.architrave);
    asked.frieze = length("frieze", 0);
    asked.pediment = length("pediment", 0);
    asked.pediment_edge = length("pediment_edge", asked.pediment_edge);
    asked.depth = length("depth", 0);
    const patterns::StoneImperfection imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before, {patterns::foundation_group, "drums", "capital", "entablature", "pediment"},
        [&] {
            patterns::Pattern pattern = patterns::temple_front(asked, name);
            check_and_disturb(pattern, imperfection);
            return pattern;
        },
        reading);
}

}  // namespace voussoir::app::reader
