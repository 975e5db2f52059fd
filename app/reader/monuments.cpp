// Gates, buttresses, steps, obelisks and pinnacles as a case file gives them.
#include <numbers>

#include "app/reader/arch_keys.h"
#include "importers/patterns/buttress.h"
#include "importers/patterns/gate.h"
#include "importers/patterns/spires.h"
#include "importers/patterns/steps.h"

namespace voussoir::app::reader
{

namespace patterns = importers::patterns;
using words::Range;
namespace dimension = words::dimension;

namespace
{

double length(YamlCursor& map, const char* key, double otherwise)
{
    return map.quantity_or(key, dimension::length, Range::positive(), otherwise);
}

double required_length(YamlCursor& map, const char* key)
{
    return map.quantity(key, dimension::length, Range::positive());
}

bool is_spatial(const char* what, const YamlCursor& map, const BlockReading& reading)
{
    const bool planar = is_planar(reading.model.kinematics);
    if (planar) map.fault(std::string(what) + " in a planar scene", "set kinematics to a spatial one");
    return !planar;
}

patterns::BlockFormat read_format(YamlCursor& map)
{
    const Eigen::Vector2d block = read_block_format(map);
    return {block.x(), block.y()};
}

/// Reads `imperfection`, then adds the stones that `draw` gives, made imperfect.
template <class Draw>
void finish(YamlCursor& entry, YamlCursor& map, std::size_t faults_before, const std::vector<std::string>& groups,
            const Draw& draw, BlockReading& reading)
{
    const patterns::StoneImperfection imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before, groups,
        [&] {
            patterns::Pattern pattern = draw();
            check_and_disturb(pattern, imperfection);
            return pattern;
        },
        reading);
}

patterns::ButtressStage read_stage(YamlCursor& map)
{
    patterns::ButtressStage stage;
    stage.height = required_length(map, "height");
    stage.depth = required_length(map, "depth");
    map.reject_unknown_keys();
    return stage;
}

/// `pier: {WIDE, height}`. @param wide the key of its extent along x
void read_pier(YamlCursor& map, const char* wide, double& extent, double& height)
{
    const auto pier = map.require("pier", std::string("a pier {") + wide + ", height}");
    YamlCursor keys = pier.value_or(map);
    if (!pier || !keys.expect_map(std::string("a pier {") + wide + ", height}")) return;
    extent = required_length(keys, wide);
    height = required_length(keys, "height");
    keys.reject_unknown_keys();
}

}  // namespace

void read_obelisk(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!is_spatial("an obelisk", map, reading) || !map.expect_map("an obelisk {height, width, ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::Obelisk asked;
    asked.height = required_length(map, "height");
    asked.width = required_length(map, "width");
    asked.top_width = length(map, "top_width", 0.7 * asked.width);
    asked.pyramidion = length(map, "pyramidion", asked.top_width);
    asked.stones = map.integer_or("stones", 1, 999, 1);
    if (auto pedestal = map.find("pedestal"); pedestal && pedestal->expect_map("a pedestal {height, width}")) {
        asked.pedestal_height = required_length(*pedestal, "height");
        asked.pedestal_width = required_length(*pedestal, "width");
        pedestal->reject_unknown_keys();
    }
    finish(
        entry, map, faults_before, {patterns::foundation_group, "pedestal", "shaft"},
        [&] { return patterns::obelisk(asked, name); }, reading);
}

void read_pinnacle(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!is_spatial("a pinnacle", map, reading) || !map.expect_map("a pinnacle {width, height, spire, ...}"))
        return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::Pinnacle asked;
    asked.width = required_length(map, "width");
    asked.height = required_length(map, "height");
    asked.courses = map.integer_or("courses", 1, 999, asked.courses);
    asked.spire = required_length(map, "spire");
    asked.spire_stones = map.integer_or("spire_stones", 1, 999, asked.spire_stones);
    finish(
        entry, map, faults_before, {patterns::foundation_group, "shaft", "spire"},
        [&] { return patterns::pinnacle(asked, name); }, reading);
}

void read_steps(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!is_spatial("steps", map, reading) || !map.expect_map("steps {number, rise, going, width, ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::Steps asked;
    if (map.require("number", "how many steps")) asked.number = map.integer_or("number", 1, 9999, 1);
    asked.rise = length(map, "rise", asked.rise);
    asked.going = length(map, "going", asked.going);
    asked.width = required_length(map, "width");
    asked.landing = length(map, "landing", 2 * asked.going);
    asked.stone_length = length(map, "stone_length", asked.stone_length);
    asked.depth = length(map, "depth", 1.5 * asked.going);
    finish(
        entry, map, faults_before, {patterns::foundation_group, "steps"},
        [&] { return patterns::steps(asked, name); }, reading);
}

void read_gate(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!is_spatial("a gate", map, reading) ||
        !map.expect_map("a gate {span, thickness, voussoirs, depth, pier, block, ...}"))
        return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::Gate asked;
    asked.curve = read_arch_curve(map);
    asked.depth = required_length(map, "depth");
    asked.block = read_format(map);
    read_pier(map, "width", asked.pier_width, asked.pier_height);
    asked.attic = map.quantity_or("attic", dimension::length, Range::non_negative(), asked.attic);
    asked.stones_across = map.integer_or("stones_across", 1, 999, 1);
    finish(
        entry, map, faults_before, {patterns::foundation_group, "pier", "voussoirs", "wall"},
        [&] { return patterns::gate(asked, name); }, reading);
}

void read_buttress(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!is_spatial("a buttress", map, reading) || !map.expect_map("a buttress {width, block, stages: [...]}"))
        return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::Buttress asked;
    asked.width = required_length(map, "width");
    asked.block = read_format(map);
    asked.weathering = map.quantity_or("weathering", dimension::angle, Range::positive(), std::numbers::pi / 4);
    if (const auto stages = map.require("stages", "stages from below, [{height: 3 m, depth: 1.2 m}]"))
        for (YamlCursor& item : stages->items("a list of stages {height, depth}"))
            if (item.expect_map("a stage {height, depth}")) asked.stages.push_back(read_stage(item));
    finish(
        entry, map, faults_before, {patterns::foundation_group, "buttress"},
        [&] { return patterns::buttress(asked, name); }, reading);
}

void read_flying_buttress(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!is_spatial("a flying buttress", map, reading) ||
        !map.expect_map("a flying buttress {span, rise, thickness, voussoirs, width, pier, block, ...}"))
        return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::FlyingButtress asked;
    asked.curve = read_half_arch_curve(map);
    asked.width = length(map, "width", asked.width);
    asked.block = read_format(map);
    read_pier(map, "depth", asked.pier_depth, asked.pier_height);
    asked.pinnacle = map.quantity_or("pinnacle", dimension::length, Range::non_negative(), 0);
    asked.wall_thickness = length(map, "wall_thickness", asked.wall_thickness);
    finish(
        entry, map, faults_before, {patterns::foundation_group, "voussoirs", "pier", "pinnacle"},
        [&] { return patterns::flying_buttress(asked, name); }, reading);
}

}  // namespace voussoir::app::reader
