// Arches, domes and vaults as a case file gives them.
#include <cmath>
#include <numbers>

#include "app/reader/arch_keys.h"
#include "importers/patterns/arch.h"
#include "importers/patterns/grid_pattern.h"

namespace voussoir::app::reader
{

namespace patterns = importers::patterns;
using words::Range;
namespace dimension = words::dimension;

namespace
{

constexpr double degree = std::numbers::pi / 180;

/// `rise`, or of a circular arch `embrace`; a semicircle without either.
double read_rise(YamlCursor& map, patterns::ArchShape shape, double span)
{
    const std::optional<double> rise = map.find_quantity("rise", dimension::length, Range::positive());
    const std::optional<double> embrace =
        map.find_quantity("embrace", dimension::angle, Range{0, std::numbers::pi, false, true});
    if (rise && embrace) map.fault("both rise and embrace", "give one of them");
    if (embrace && shape != patterns::ArchShape::circular)
        map.fault("embrace of an arch that is not circular", "give rise");
    if (rise) return *rise;
    if (embrace) return span / 2 * std::tan(*embrace / 4);
    const double otherwise = shape == patterns::ArchShape::pointed    ? span * std::sqrt(0.75)
                             : shape == patterns::ArchShape::circular ? span / 2
                                                                      : span / 3;
    map.took_default("rise", std::to_string(otherwise) + " m");
    return otherwise;
}

/// The keys of one thing and, for what they leave out, those of all its like.
struct OwnOrCommon {
    YamlCursor &own, &common;

    YamlCursor& of(const std::string& key) const
    {
        const bool is_own = own.find(key).has_value();
        common.find(key);  // it is known there, whoever says it
        return is_own ? own : common;
    }
};

/// `thickness`, or its share of the mean radius, by which the literature names limits: `thickness_over_radius`.
/// @param radius of the intrados [m]; 0: it is no circle
double read_thickness(YamlCursor& map, double radius)
{
    const std::optional<double> ratio =
        map.find_quantity("thickness_over_radius", dimension::number, Range{0, 1, false, false});
    if (!ratio) return map.quantity("thickness", dimension::length, Range::positive());
    if (map.find("thickness")) map.fault("both thickness and thickness_over_radius", "give one of them");
    if (radius == 0) map.fault("thickness_over_radius of an arch that is not circular", "give thickness");
    return radius * *ratio / (1 - *ratio / 2);
}

void read_thickness_and_number(const OwnOrCommon& keys, int most, patterns::ArchCurve& curve)
{
    const bool is_circle = curve.shape == patterns::ArchShape::circular;
    const double half = curve.span / 2;
    // Either of its own takes the place of both that are common.
    YamlCursor &with_length = keys.of("thickness"), &with_ratio = keys.of("thickness_over_radius");
    curve.thickness = read_thickness(&with_length == &keys.own ? keys.own : with_ratio,
                                     is_circle ? (half * half + curve.rise * curve.rise) / (2 * curve.rise) : 0);
    curve.springing_thickness = curve.thickness;
    YamlCursor& with_ends = keys.of("springing_thickness");
    if (const auto ends = with_ends.find_quantity("springing_thickness", dimension::length, Range::positive()))
        curve.springing_thickness = *ends;
    YamlCursor& numbered = keys.of("voussoirs");
    if (numbered.require("voussoirs", "number of voussoirs"))
        curve.voussoirs = numbered.integer_or("voussoirs", 2, most, 0);
}

/// `ribs: {width, depth}`.
void read_ribs(YamlCursor& map, patterns::CrossVault& vault)
{
    std::optional<YamlCursor> keys = map.find("ribs");
    if (!keys || !keys->expect_map("ribs {width, depth}")) return;
    vault.rib_width = keys->quantity("width", dimension::length, Range::positive());
    vault.rib_depth = keys->quantity_or("depth", dimension::length, Range::positive(), vault.rib_width);
    keys->reject_unknown_keys();
}

/// `lantern: {height, ring, cap}`.
void read_lantern(YamlCursor& map, patterns::Dome& dome)
{
    std::optional<YamlCursor> keys = map.find("lantern");
    if (!keys || !keys->expect_map("a lantern {height, ring, cap}")) return;
    patterns::Lantern& lantern = dome.lantern;
    lantern.height = keys->quantity("height", dimension::length, Range::positive());
    lantern.ring = keys->quantity_or("ring", dimension::length, Range::positive(), lantern.ring);
    lantern.cap = keys->quantity_or("cap", dimension::length, Range::positive(), lantern.height);
    keys->reject_unknown_keys();
}

}  // namespace

patterns::ArchCurve read_half_arch_curve(YamlCursor& map)
{
    using patterns::ArchShape;
    patterns::ArchCurve curve;
    const double span = map.quantity("span", dimension::length, Range::positive());
    curve.rise = map.quantity_or("rise", dimension::length, Range::positive(), span);
    curve.shape = map.choice_or<ArchShape>(
        "shape", {{"circular", ArchShape::circular}, {"elliptic", ArchShape::elliptic}}, ArchShape::circular);
    curve.span = 2 * span;
    read_thickness_and_number({map, map}, 4999, curve);
    curve.voussoirs *= 2;
    return curve;
}

patterns::ArchCurve read_arch_curve(YamlCursor& own, YamlCursor& common)
{
    using patterns::ArchShape;
    const OwnOrCommon keys{own, common};
    patterns::ArchCurve curve;
    curve.shape = keys.of("shape").choice_or<ArchShape>("shape",
                                                        {{"circular", ArchShape::circular},
                                                         {"pointed", ArchShape::pointed},
                                                         {"elliptic", ArchShape::elliptic},
                                                         {"polycentric", ArchShape::polycentric}},
                                                        ArchShape::circular);
    curve.span = keys.of("span").quantity("span", dimension::length, Range::positive());
    // One of them of its own takes the place of both that are common.
    YamlCursor &with_rise = keys.of("rise"), &with_embrace = keys.of("embrace");
    curve.rise = read_rise(&with_embrace == &own ? own : with_rise, curve.shape, curve.span);
    if (curve.shape == ArchShape::polycentric)
        curve.side_arc =
            keys.of("side_arc").quantity_or("side_arc", dimension::angle, Range::positive(), 60 * degree);
    else
        own.forbid("side_arc", "only a polycentric arch has side arcs");
    read_thickness_and_number(keys, 9999, curve);
    return curve;
}

patterns::ArchCurve read_arch_curve(YamlCursor& map)
{
    return read_arch_curve(map, map);
}

void read_arch(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!map.expect_map("an arch {span, thickness, voussoirs, width, ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    patterns::Arch asked;
    asked.name = read_name_prefix(map);
    asked.curve = read_arch_curve(map);
    asked.width = map.quantity_or("width", dimension::length, Range::positive(), 1);
    asked.stones_across = map.integer_or("stones_across", 1, 999, 1);
    asked.springing_height =
        map.quantity_or("springing_height", dimension::length, Range::positive(), asked.springing_height);
    asked.imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before, {patterns::foundation_group, "voussoirs"},
        [&] { return patterns::arch(asked); }, reading);
}

void read_dome(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!map.expect_map("a dome {radius, thickness, courses, stones, ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::Dome asked;
    asked.radius = map.quantity("radius", dimension::length, Range::positive());
    asked.thickness = read_thickness(map, asked.radius);
    asked.oculus = map.quantity_or("oculus", dimension::angle, Range::positive(), 15 * degree);
    asked.springing = map.quantity_or("springing", dimension::angle, Range::positive(), 90 * degree);
    if (std::abs(asked.springing - std::numbers::pi / 2) < 1e-12) asked.springing = std::numbers::pi / 2;
    asked.courses = map.integer_or("courses", 1, 999, asked.courses);
    asked.stones = map.integer_or("stones", 3, 9999, asked.stones);
    asked.bonded = map.boolean_or("bonded", true);
    asked.keystone = map.boolean_or("keystone", false);
    asked.support = map.quantity_or("support", dimension::length, Range::positive(), asked.support);
    asked.half = map.boolean_or("half", false);
    if (!asked.half && map.find("front"))
        map.fault("front of a whole dome", "only half a dome has an arch before it");
    asked.front = map.quantity_or("front", dimension::length, Range::positive(), asked.thickness);
    read_lantern(map, asked);
    const patterns::StoneImperfection imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before, {patterns::foundation_group, "dome", "front", "lantern"},
        [&] {
            patterns::Pattern pattern = dome_pattern(asked, name);
            check_and_disturb(pattern, imperfection);
            return pattern;
        },
        reading);
}

void read_barrel_vault(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!map.expect_map("a barrel vault {span, rise, thickness, length, courses, stones, ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::BarrelVault asked;
    asked.span = map.quantity("span", dimension::length, Range::positive());
    asked.rise = map.quantity_or("rise", dimension::length, Range::positive(), asked.span / 2);
    asked.thickness =
        read_thickness(map, (asked.span * asked.span / 4 + asked.rise * asked.rise) / (2 * asked.rise));
    asked.length = map.quantity("length", dimension::length, Range::positive());
    asked.courses = map.integer_or("courses", 2, 9999, asked.courses);
    asked.stones = map.integer_or("stones", 1, 9999, asked.stones);
    asked.bonded = map.boolean_or("bonded", true);
    asked.support = map.quantity_or("support", dimension::length, Range::positive(), asked.support);
    const patterns::StoneImperfection imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before, {patterns::foundation_group, "vault"},
        [&] {
            patterns::Pattern pattern = pattern_of(patterns::barrel_vault(asked), name, "vault");
            check_and_disturb(pattern, imperfection);
            return pattern;
        },
        reading);
}

void read_cross_vault(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!map.expect_map("a cross vault {span, rise, thickness, courses, stones, ...}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    patterns::CrossVault asked;
    asked.span = map.quantity("span", dimension::length, Range::positive());
    asked.rise = map.quantity_or("rise", dimension::length, Range::positive(), asked.span / 2);
    asked.thickness = map.quantity("thickness", dimension::length, Range::positive());
    asked.margin = map.quantity_or("margin", dimension::length, Range::positive(), asked.margin);
    asked.courses = map.integer_or("courses", 2, 9999, asked.courses);
    asked.stones = map.integer_or("stones", 1, 9999, asked.stones);
    asked.support = map.quantity_or("support", dimension::length, Range::positive(), asked.support);
    read_ribs(map, asked);
    const patterns::StoneImperfection imperfection = read_stone_imperfection(map);
    finish_pattern(
        entry, map, faults_before, {patterns::foundation_group, "vault", "ribs"},
        [&] {
            patterns::Pattern pattern = cross_vault_pattern(asked, name);
            check_and_disturb(pattern, imperfection);
            return pattern;
        },
        reading);
}

}  // namespace voussoir::app::reader
