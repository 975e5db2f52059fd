// Bridges as a case file gives them.
#include <algorithm>

#include "app/reader/arch_keys.h"
#include "importers/patterns/bridge.h"

namespace voussoir::app::reader
{

namespace patterns = importers::patterns;
using words::Range;
namespace dimension = words::dimension;

namespace
{

void read_parapet(YamlCursor& map, patterns::Bridge& asked)
{
    std::optional<YamlCursor> keys = map.find("parapet");
    if (!keys || !keys->expect_map("a parapet {height, thickness}")) return;
    asked.parapet_height = keys->quantity("height", dimension::length, Range::positive());
    asked.parapet_thickness =
        keys->quantity_or("thickness", dimension::length, Range::positive(), asked.spandrel_thickness);
    keys->reject_unknown_keys();
}

void read_fill(YamlCursor& map, patterns::Bridge& asked)
{
    using patterns::Fill;
    asked.fill = map.choice_or<Fill>(
        "fill", {{"none", Fill::none}, {"mass", Fill::mass}, {"blocks", Fill::blocks}}, Fill::none);
    asked.fill_density =
        map.quantity_or("fill_density", dimension::density, Range::positive(), asked.fill_density);
}

/// `spans: 3`, or `spans: [{span: 6 m, voussoirs: 15}, ...]`: what an arch does not say itself, the bridge says.
std::vector<patterns::ArchCurve> read_arches(YamlCursor& map)
{
    const std::optional<YamlCursor> spans = map.find("spans");
    if (!spans || !spans->is_list()) {
        const int number = map.integer_or("spans", 1, 999, 1);
        return std::vector<patterns::ArchCurve>(static_cast<std::size_t>(std::max(number, 0)),
                                                read_arch_curve(map));
    }
    std::vector<patterns::ArchCurve> arches;
    for (YamlCursor& item : spans->items("arches from left to right, [{span: 6 m, voussoirs: 15}, ...]")) {
        if (!item.expect_map("an arch {span, rise, thickness, voussoirs, ...}")) continue;
        arches.push_back(read_arch_curve(item, map));
        item.reject_unknown_keys();
    }
    if (arches.empty()) spans->fault("no arch", "give at least one");
    if (std::none_of(arches.begin(), arches.end(), [](const patterns::ArchCurve& arch) {
            return arch.shape == patterns::ArchShape::polycentric;
        }))
        map.forbid("side_arc", "only a polycentric arch has side arcs");
    return arches;
}

}  // namespace

void read_bridge(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (is_planar(reading.model.kinematics))
        return map.fault("a bridge in a planar scene", "use an arch, or set kinematics to a spatial one");
    if (!map.expect_map("a bridge {spans, span, thickness, voussoirs, width, ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const auto length = [&](const char* key, double otherwise, const Range& range) {
        return map.quantity_or(key, dimension::length, range, otherwise);
    };
    patterns::Bridge asked;
    asked.name = read_name_prefix(map);
    asked.arches = read_arches(map);
    asked.width = map.quantity("width", dimension::length, Range::positive());
    asked.stones_across = map.integer_or("stones_across", 1, 999, asked.stones_across);
    const Eigen::Vector2d block = read_block_format(map);
    asked.block = {block.x(), block.y()};
    asked.abutment_length = length("abutment_length", asked.abutment_length, Range::positive());
    asked.pier_width = length("pier_width", asked.pier_width, Range::positive());
    asked.pier_height = length("pier_height", asked.pier_height, Range::positive());
    asked.cutwater = length("cutwater", 0, Range::non_negative());
    asked.spandrel_thickness = length("spandrel_thickness", 0, Range::non_negative());
    asked.backing = length("backing", 0, Range::non_negative());
    asked.cover = length("cover", 0, Range::non_negative());
    read_parapet(map, asked);
    read_fill(map, asked);
    asked.imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before,
        {patterns::foundation_group, "voussoirs", "pier", "spandrel", "backing", "fill", "parapet"},
        [&] { return patterns::bridge(asked); }, reading);
}

}  // namespace voussoir::app::reader
