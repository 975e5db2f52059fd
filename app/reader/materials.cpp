#include "app/reader/materials.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string_view>

#include "app/words/nearest_word.h"
#include "libdda/model/standard_gravity.h"
#include "libdda/text/numbers.h"

namespace voussoir::app::reader
{
namespace
{

/// So many times the modulus of the stones over their depth: "300 E/L".
std::optional<double> times_modulus(const std::string& text)
{
    constexpr std::string_view unit = "E/L";
    if (!text.ends_with(unit)) return std::nullopt;
    std::string number = text.substr(0, text.size() - unit.size());
    number.erase(number.find_last_not_of(' ') + 1);
    const std::optional<double> times = text::parse_finite(number);
    return times && *times > 0 ? times : std::nullopt;
}

/// The three spellings are told apart by the unit, so a bare number says nothing.
ContactStiffness read_stiffness(YamlCursor& map)
{
    const std::optional<YamlCursor> value = map.find("contact_stiffness");
    if (!value) {
        map.took_default("contact_stiffness", "from the blocks' modulus and depth");
        return {};
    }
    if (value->is_scalar())
        if (const std::optional<double> times = times_modulus(value->as_text()))
            return {ContactStiffness::Kind::from_modulus, *times};
    const words::ParsedQuantity quantity =
        value->is_scalar() ? words::parse_quantity(value->as_text()) : words::ParsedQuantity{};
    if (quantity.problem.empty() && quantity.has(words::dimension::stiffness_per_point))
        return {ContactStiffness::Kind::per_point,
                value->as_quantity(words::dimension::stiffness_per_point, words::Range::positive())};
    if (quantity.problem.empty() && quantity.has(words::dimension::stiffness_per_area))
        return {ContactStiffness::Kind::per_area,
                value->as_quantity(words::dimension::stiffness_per_area, words::Range::positive())};
    value->fault(value->found() + (quantity.bare ? " has no unit; the unit determines the meaning" : ""),
                 "expected 50 MPa/m (per area), 1e8 N/m (per contact point) or 300 E/L (of the stones)");
    return {};
}

const words::Range friction_range{0, std::numbers::pi / 2, true, false};
constexpr double largest_coefficient = 1e6;  // an angle of less than 90 deg still, by 0.2 arc seconds

/// The angle of friction [rad], given as one or as `{coefficient: 0.7}`. A bare number is none of the two: half of
/// those who write 0.7 mean the tangent.
double as_friction(YamlCursor& value)
{
    if (value.is_map()) {
        const double coefficient =
            value.quantity("coefficient", words::dimension::number, {0, largest_coefficient, true, true});
        value.reject_unknown_keys();
        return std::atan(coefficient);
    }
    const words::ParsedQuantity quantity =
        value.is_scalar() ? words::parse_quantity(value.as_text()) : words::ParsedQuantity{};
    if (!quantity.problem.empty() || !words::lacks_unit(quantity, words::dimension::angle) || quantity.value < 0)
        return value.as_quantity(words::dimension::angle, friction_range);
    value.fault(value.found() + " has no unit",
                fmt::format("write {0} deg for an angle, or {{coefficient: {0}}}, which is {1:.4g} deg",
                            value.as_text(), std::atan(quantity.value) * 180 / std::numbers::pi));
    return std::numeric_limits<double>::quiet_NaN();
}

double read_friction(YamlCursor& map)
{
    std::optional<YamlCursor> value = map.require("friction", "an angle such as 35 deg, or {coefficient: 0.7}");
    return value ? as_friction(*value) : std::numeric_limits<double>::quiet_NaN();
}

/// How friction changes with the speed of slip: a list of {speed, friction}.
std::vector<FrictionAtSpeed> read_friction_at_speed(YamlCursor& map)
{
    std::vector<FrictionAtSpeed> points;
    const std::optional<YamlCursor> list = map.find("friction_at_speed");
    if (!list) return points;
    double last = 0;
    if (list->is_list_of(0)) list->fault("an empty list", "give a point, or omit friction_at_speed");
    for (YamlCursor& item : list->items("a list of {speed: 1 cm/s, friction: 20 deg}")) {
        if (!item.expect_map("a point {speed: 1 cm/s, friction: 20 deg}")) continue;
        FrictionAtSpeed point;
        point.speed = item.quantity("speed", words::dimension::velocity, words::Range::positive());
        point.angle = read_friction(item);
        item.reject_unknown_keys();
        if (point.speed <= last)
            item.fault(words::in_words(point.speed, words::dimension::velocity),
                       "speeds must be in ascending order");
        last = point.speed;
        points.push_back(point);
    }
    return points;
}

/// What stones keep of their approach speed. A relaxation time is another answer to the same question.
std::optional<double> read_restitution(YamlCursor& map, bool has_dashpot)
{
    const std::optional<YamlCursor> given = map.find("restitution");
    if (!given) return has_dashpot ? std::nullopt : JointMaterial{}.restitution;
    if (given->is_scalar() && given->as_text() == "none") return std::nullopt;
    const double restitution = given->as_quantity(words::dimension::number, {0, 1, true, true});
    if (has_dashpot)
        given->fault("restitution beside a relaxation_time",
                     "a joint has one or the other; or write restitution: none");
    return restitution;
}

/// A stiffness that was measured is that of a joint, which opens from its edge on; one per contact point is that
/// of the papers, whose points are the corners.
FaceLaw face_by_stiffness(ContactStiffness::Kind kind)
{
    switch (kind) {
        case ContactStiffness::Kind::per_area:
            return FaceLaw::linear;
        case ContactStiffness::Kind::per_point:
            return FaceLaw::corners;
        case ContactStiffness::Kind::from_modulus:
            return FaceLaw::points;
    }
    return FaceLaw::points;
}

JointMaterial read_joint(const std::string& name, YamlCursor& map)
{
    JointMaterial joint;
    joint.name = name;
    joint.friction_angle = read_friction(map);
    joint.friction_at_speed = read_friction_at_speed(map);
    joint.cohesion =
        map.quantity_or("cohesion", words::dimension::pressure, words::Range::non_negative(), joint.cohesion);
    joint.tensile_strength = map.quantity_or("tensile_strength", words::dimension::pressure,
                                             words::Range::non_negative(), joint.tensile_strength);
    joint.stiffness = read_stiffness(map);
    if (const std::optional<YamlCursor> factor = map.find("contact_stiffness_factor"))
        joint.stiffness.factor = factor->as_quantity(words::dimension::number, words::Range::positive());
    joint.shear_to_normal_stiffness = map.quantity_or("shear_to_normal_stiffness", words::dimension::number,
                                                      words::Range::positive(), joint.shear_to_normal_stiffness);
    joint.face = map.choice_or<FaceLaw>(
        "face", {{"corners", FaceLaw::corners}, {"points", FaceLaw::points}, {"linear", FaceLaw::linear}},
        face_by_stiffness(joint.stiffness.kind));
    joint.relaxation_time = map.quantity_or("relaxation_time", words::dimension::time,
                                            words::Range::non_negative(), joint.relaxation_time);
    joint.restitution = read_restitution(map, joint.relaxation_time > 0);
    map.reject_unknown_keys();
    return joint;
}

std::vector<std::string> names_of(const std::vector<JointMaterial>& joints)
{
    std::vector<std::string> names;
    names.reserve(joints.size());
    for (const JointMaterial& joint : joints) names.push_back(joint.name);
    return names;
}

/// Index of a name in a list, or -1 with a fault.
int find_name(const YamlCursor& value, const std::vector<std::string>& names, const std::string& what)
{
    const std::string name = value.as_text();
    if (name.empty()) return -1;
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) value.fault(fmt::format("no {} \"{}\"", what, name), words::suggestion(name, names));
    return at == names.end() ? -1 : static_cast<int>(at - names.begin());
}

int read_default_joint(YamlCursor& top, const std::vector<JointMaterial>& joints)
{
    if (const std::optional<YamlCursor> value = top.find("default_joint"))
        return find_name(*value, names_of(joints), "joint");
    if (joints.size() == 1) return 0;
    if (!joints.empty()) top.require("default_joint", "the joint used where no rule applies");
    return -1;
}

/// One rule: sets the joint on both sides of the diagonal.
void read_rule(YamlCursor& rule, const std::vector<JointMaterial>& joints, const std::vector<std::string>& groups,
               std::set<std::pair<int, int>>& ruled, std::vector<int>& joint_of_groups)
{
    if (!rule.expect_map("a rule {between: [group, group], joint: name}")) return;
    std::vector<int> pair;
    if (const auto between = rule.require("between", "the two groups, [group, group]"))
        for (const YamlCursor& group : between->items("two groups, [group, group]"))
            pair.push_back(find_name(group, groups, "group"));
    const auto joint = rule.require("joint", "a joint's name");
    const int index = joint ? find_name(*joint, names_of(joints), "joint") : -1;
    rule.reject_unknown_keys();
    if (pair.size() != 2) return rule.fault(fmt::format("{} groups", pair.size()), "a joint lies between two");
    if (pair[0] < 0 || pair[1] < 0 || index < 0) return;
    if (!ruled.insert(std::minmax(pair[0], pair[1])).second)
        return rule.fault("a second rule for the same two groups", "keep one of them");
    joint_of_groups[pair[0] * groups.size() + pair[1]] = index;
    joint_of_groups[pair[1] * groups.size() + pair[0]] = index;
}

}  // namespace

double read_density(YamlCursor& map)
{
    const std::optional<YamlCursor> value = map.require("density", "a density such as 2400 kg/m3");
    if (!value) return 0;
    const bool is_weight =
        value->is_scalar() && words::parse_quantity(value->as_text()).has(words::dimension::unit_weight);
    if (!is_weight) return value->as_quantity(words::dimension::density, words::Range::positive());
    const double density =
        value->as_quantity(words::dimension::unit_weight, words::Range::positive()) / standard_gravity;
    map.took_default("density", fmt::format("{} / 9.80665 m/s2 = {:g} kg/m3", value->as_text(), density));
    return density;
}

RayleighDamping read_rayleigh(YamlCursor& map)
{
    if (!map.expect_map("rayleigh {ratio: 0.05, at: [1 Hz, 10 Hz]}")) return {};
    const words::Range shares{0, 1, true, false};
    const std::size_t faults = map.fault_count();
    std::vector<double> ratios, omegas;
    if (const auto given = map.require("ratio", "the share of critical damping, such as 0.05, or two of them")) {
        if (!given->is_list())
            ratios.assign(2, given->as_quantity(words::dimension::number, shares));
        else
            for (const YamlCursor& ratio : given->items("two ratios"))
                ratios.push_back(ratio.as_quantity(words::dimension::number, shares));
    }
    const auto at = map.require("at", "the two frequencies at which it holds, such as [1 Hz, 10 Hz]");
    if (at)
        for (const YamlCursor& frequency : at->items("two frequencies, [1 Hz, 10 Hz]"))
            omegas.push_back(2 * std::numbers::pi *
                             frequency.as_quantity(words::dimension::frequency, words::Range::positive()));
    map.reject_unknown_keys();
    if (map.fault_count() != faults) return {};
    if (ratios.size() != 2 || omegas.size() != 2 || !(omegas[0] < omegas[1])) {
        map.fault(fmt::format("{} ratios at {} frequencies", ratios.size(), omegas.size()),
                  "give two frequencies in ascending order, and one ratio or two");
        return {};
    }
    const double square = omegas[1] * omegas[1] - omegas[0] * omegas[0];
    const RayleighDamping damping{
        2 * omegas[0] * omegas[1] * (ratios[0] * omegas[1] - ratios[1] * omegas[0]) / square,
        2 * (ratios[1] * omegas[1] - ratios[0] * omegas[0]) / square};
    if (damping.of_mass < 0 || damping.of_stiffness < 0)
        map.fault("two ratios that need a negative share of mass or of stiffness",
                  "bring the ratios nearer to one another, or the frequencies farther apart");
    return damping;
}

void read_hysteretic(YamlCursor& map, BlockMaterial& material)
{
    if (!map.expect_map("hysteretic {ratio: 5 %, band: [1 Hz, 10 Hz]}")) return;
    const std::size_t faults = map.fault_count();
    const double ratio = map.quantity("ratio", words::dimension::number, {0, most_hysteretic_ratio, false, true});
    std::vector<double> band;
    if (const auto given = map.require("band", "the lowest and the highest frequency, such as [1 Hz, 10 Hz]"))
        for (const YamlCursor& frequency : given->items("two frequencies, [1 Hz, 10 Hz]"))
            band.push_back(frequency.as_quantity(words::dimension::frequency, words::Range::positive()));
    map.reject_unknown_keys();
    if (map.fault_count() != faults) return;
    if (band.size() != 2 || !(band[0] < band[1]) || band[1] > widest_band * band[0])
        return map.fault(
            fmt::format("a band of {} frequencies", band.size()),
            fmt::format("give the lower and the higher one, at most {:g} times as high", widest_band));
    material.branches = hysteretic_branches(ratio, band[0], band[1]);
    if (material.branches.empty())
        return map.fault("a ratio and a band that no branches fit", "give a lower ratio or a narrower band");
    const double middle = std::sqrt(band[0] * band[1]),
                 stiffer = modulus_over_rest(material.branches, 2 * std::numbers::pi * middle).real();
    material.young /= stiffer;
    map.took_default(
        "at rest", fmt::format("softer by {:.3g}: what is given is the modulus at {:.3g} Hz; {} branches", stiffer,
                               middle, material.branches.size()));
}

std::vector<BlockMaterial> read_materials(YamlCursor& top, Kinematics kinematics)
{
    std::vector<BlockMaterial> materials;
    std::optional<YamlCursor> section = top.require("materials", "the block materials, {name: {density: ...}}");
    if (!section) return materials;
    for (auto& [name, map] : section->named_entries("materials by name")) {
        if (!map.expect_map("a material {density, young, poisson}")) continue;
        BlockMaterial material;
        material.name = name;
        material.density = read_density(map);
        material.young = map.quantity("young", words::dimension::pressure, words::Range::positive());
        material.poisson = map.quantity("poisson", words::dimension::number, {-1, 0.5, false, false});
        material.compressive_strength =
            map.find_quantity("compressive_strength", words::dimension::pressure, words::Range::positive())
                .value_or(0);
        if (std::optional<YamlCursor> rayleigh = map.find("rayleigh"))
            material.rayleigh = read_rayleigh(*rayleigh);
        if (std::optional<YamlCursor> hysteretic = map.find("hysteretic")) {
            if (is_deformable(kinematics))
                read_hysteretic(*hysteretic, material);
            else
                hysteretic->fault("rigid blocks, which are not strained",
                                  "choose spatial_deformable or planar_deformable");
        }
        map.reject_unknown_keys();
        materials.push_back(material);
    }
    if (materials.empty() && section->is_map()) section->fault("no material", "give at least one");
    return materials;
}

std::vector<JointMaterial> read_joints(YamlCursor& top)
{
    std::vector<JointMaterial> joints;
    std::optional<YamlCursor> section = top.require("joints", "the joint laws, {name: {friction: 30 deg}}");
    if (!section) return joints;
    for (auto& [name, map] : section->named_entries("joints by name"))
        if (map.expect_map("a joint {friction: ...}")) joints.push_back(read_joint(name, map));
    if (joints.empty() && section->is_map()) section->fault("no joint", "give at least one");
    return joints;
}

std::vector<int> read_joint_rules(YamlCursor& top, const std::vector<JointMaterial>& joints,
                                  const std::vector<std::string>& groups)
{
    std::vector<int> joint_of_groups(groups.size() * groups.size(), read_default_joint(top, joints));
    std::set<std::pair<int, int>> ruled;
    if (const std::optional<YamlCursor> rules = top.find("joint_rules"))
        for (YamlCursor& rule : rules->items("a list of rules"))
            read_rule(rule, joints, groups, ruled, joint_of_groups);
    return joint_of_groups;
}

}  // namespace voussoir::app::reader
