#include "app/reader/bars.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "app/reader/foundation.h"
#include "app/reader/plane.h"
#include "app/words/nearest_word.h"
#include "libdda/analysis/joint_openings.h"

namespace voussoir::app::reader
{
namespace
{

using Eigen::Vector3d;

constexpr double steel = 2e11;              // Pa, the default of `young`
constexpr double shear_modulus = 1 / 2.6;   // of Young's modulus, of steel: 1 / (2 (1 + 0.3))
constexpr double beside = 1e-3;             // of a block's size: how far an end may lie outside of what is drawn
constexpr std::size_t most_bars = 200'000;  // as of blocks
constexpr double shortest = 1e-6;           // of a block's size: a shorter rod has no direction

/// Metal, and what of its forces a bar has.
struct Metal {
    double area = 0, young = steel;  // m2, Pa
    std::optional<double> yield;     // Pa
    bool tension = false, compression = false, shear = false;

    double limit(bool carried, double share = 1) const
    {
        if (!carried) return 0;
        return yield ? *yield * area * share : std::numeric_limits<double>::infinity();
    }
};

/// `carries: tension`, or `[tension, shear]`.
void read_carried(YamlCursor& map, bool is_rod, Metal& metal)
{
    const std::optional<YamlCursor> carries = map.find("carries");
    metal.tension = is_rod;
    metal.shear = !is_rod;
    if (!carries) return map.took_default("carries", is_rod ? "tension" : "shear");
    metal.tension = metal.shear = false;
    const std::vector<YamlCursor> words =
        carries->is_list() ? carries->items("a list of forces") : std::vector<YamlCursor>{*carries};
    for (const YamlCursor& entry : words) {
        const std::string word = entry.as_text();
        if (word == "tension")
            metal.tension = true;
        else if (word == "compression")
            metal.compression = true;
        else if (word == "shear" && !is_rod)
            metal.shear = true;
        else if (!word.empty())
            entry.fault("\"" + word + "\"", is_rod ? "a rod carries tension, compression or both"
                                                   : "expected tension, compression, shear or a list of them");
    }
    if (words.empty()) carries->fault("an empty list", "name what it carries");
}

Metal read_metal(YamlCursor& map, bool is_rod)
{
    Metal metal;
    const auto diameter = map.find_quantity("diameter", words::dimension::length, words::Range::positive());
    const auto area = map.find_quantity("area", words::dimension::area, words::Range::positive());
    if (diameter.has_value() == area.has_value())
        map.fault(area ? "both diameter and area" : "neither diameter nor area", "give one of them");
    metal.area = area ? *area : 0.25 * std::numbers::pi * std::pow(diameter.value_or(1), 2);
    metal.young = map.quantity_or("young", words::dimension::pressure, words::Range::positive(), steel);
    metal.yield = map.find_quantity("yield_strength", words::dimension::pressure, words::Range::positive());
    if (!metal.yield) map.took_default("yield_strength", "none: it stays elastic");
    read_carried(map, is_rod, metal);
    return metal;
}

/// What entries look up in the model, found once for all of them.
struct Lookup {
    explicit Lookup(const Model& model)
    {
        for (std::size_t b = 0; b < model.blocks.size(); ++b)
            block_of_name.emplace(model.blocks[b].name, static_cast<int>(b));
        for (const Foundation& foundation : model.foundations)
            if (foundation.fully_held()) held.insert(foundation.block);
    }
    const std::vector<WatchedJoint>& joints_of(const Model& model)
    {
        if (!joints) joints = joints_at_start(model, initial_state(model));
        return *joints;
    }

    std::map<std::string, int> block_of_name;
    std::set<int> held;
    std::optional<std::vector<WatchedJoint>> joints;
};

/// An end of a rod.
struct End {
    int block = -1;
    Vector3d lever = Vector3d::Zero();  // m, from the centroid
};

/// Whether a point lies in the box around a block, or on it.
bool is_at(const Model& model, int block, const Vector3d& lever)
{
    const double tolerance = beside * size_of(model, block);
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    const auto add = [&](const Vector3d& vertex) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    };
    for (const ConvexPolyhedron& part : model.blocks[block].parts)
        for (const Vector3d& vertex : part.vertices) add(vertex);
    for (const ConvexPolygon& outline : model.blocks[block].outlines)
        for (const Eigen::Vector2d& vertex : outline.vertices) add(to_space(vertex));
    for (const int axis : axes_of(model.kinematics))
        if (lever[axis] < low[axis] - tolerance || lever[axis] > high[axis] + tolerance) return false;
    return true;
}

End read_end(YamlCursor& map, const std::string& key, const Model& model, const Lookup& lookup)
{
    End end;
    std::optional<YamlCursor> given = map.require(key, "an end of the rod, {block: pier, at: [x, y, z]}");
    if (!given || !given->expect_map("an end of the rod, {block: pier, at: [x, y, z]}")) return end;
    const auto block = given->require("block", "the name of a block");
    const auto at = given->require("at", "a point of it [x, y, z]");
    given->reject_unknown_keys();
    if (!block || !at) return end;
    const Vector3d place = read_place(*at, model.kinematics) - model.origin;
    const std::string name = block->as_text();
    const auto found = lookup.block_of_name.find(name);
    if (found == lookup.block_of_name.end()) {
        std::vector<std::string> names;
        for (const Block& known : model.blocks) names.push_back(known.name);
        // Without blocks there are faults already, and a missing one is only their echo.
        if (!names.empty() && !name.empty())
            block->fault("no block \"" + name + "\"", words::suggestion(name, names));
        return end;
    }
    end.block = found->second;
    end.lever = place - model.blocks[end.block].moments.centroid;
    if (!is_at(model, end.block, end.lever))
        at->fault("a point outside of block " + name, "give a point within it, or on its surface");
    return end;
}

void refuse_more(const YamlCursor& entry)
{
    entry.fault(fmt::format("more than {} bars in all", most_bars), "use fewer, or a strength of joints");
}

/// Neither zero nor infinite by the sizes that were given.
bool is_usable(const Bar& bar)
{
    const auto is_sound = [](double stiffness) { return stiffness == 0 || std::isnormal(stiffness); };
    return is_sound(bar.axial) && is_sound(bar.lateral) && bar.axial + bar.lateral > 0 && bar.shear > 0 &&
           std::isfinite(bar.prestress);
}

void add_rod(YamlCursor& map, const std::string& name, const Lookup& lookup, Model& model)
{
    const std::size_t faults = map.fault_count();
    const End from = read_end(map, "from", model, lookup), to = read_end(map, "to", model, lookup);
    const Metal metal = read_metal(map, true);
    const double prestress =
        map.quantity_or("prestress", words::dimension::pressure, words::Range::non_negative(), 0);
    map.reject_unknown_keys();
    if (map.fault_count() != faults || from.block < 0 || to.block < 0) return;
    Bar bar;
    bar.name = name;
    bar.block_a = from.block;
    bar.block_b = to.block;
    bar.anchor_a = from.lever;
    bar.anchor_b = to.lever;
    bar.length = (model.blocks[to.block].moments.centroid + to.lever - model.blocks[from.block].moments.centroid -
                  from.lever)
                     .norm();
    if (from.block == to.block) return map.fault("both ends in the same block", "give two blocks");
    if (lookup.held.count(from.block) && lookup.held.count(to.block))
        return map.fault("both ends in blocks that are held", "it would carry nothing that moves");
    if (bar.length < shortest * size_of(model, from.block))
        return map.fault("both ends at the same place", "give two places, or dowels: between: [GROUP, GROUP]");
    bar.axial = metal.young * metal.area / bar.length;
    bar.tension = metal.limit(metal.tension);
    bar.compression = metal.limit(metal.compression);
    bar.prestress = prestress * metal.area;
    if (!is_usable(bar) || !(prestress < metal.young))
        return map.fault("a stiffness or a strength that is no number a computation can use",
                         "check diameter, area, young and yield_strength");
    if (bar.prestress > bar.tension)
        return map.fault("a prestress above the yield strength, or of a rod without tension",
                         "give a smaller one");
    if (model.bars.size() >= most_bars) return refuse_more(map);
    model.bars.push_back(std::move(bar));
}

/// The two groups of `between`.
std::vector<std::set<int>> read_between(const YamlCursor& between, const Model& model)
{
    std::vector<std::set<int>> groups;
    const std::vector<YamlCursor> names = between.items("two groups, such as [drums, drums]");
    if (between.is_list() && names.size() != 2)
        between.fault(fmt::format("a list of {}", names.size()), "give two groups, such as [drums, drums]");
    for (const YamlCursor& name : names) {
        const std::vector<int> blocks = blocks_of_group(name, model);
        groups.emplace_back(blocks.begin(), blocks.end());
    }
    return groups;
}

void add_dowels(YamlCursor& map, const std::string& name, const YamlCursor& between, Lookup& lookup, Model& model)
{
    const std::size_t faults = map.fault_count();
    const std::vector<std::set<int>> groups = read_between(between, model);
    const Metal metal = read_metal(map, false);
    const double length = map.quantity("length", words::dimension::length, words::Range::positive());
    const double lateral =
        map.quantity_or("shear_stiffness", words::dimension::stiffness_per_point, words::Range::positive(),
                        shear_modulus * metal.young * metal.area / length);
    map.reject_unknown_keys();
    if (map.fault_count() != faults || groups.size() != 2) return;
    Bar bar;
    bar.is_rod = false;
    bar.axial = metal.tension || metal.compression ? metal.young * metal.area / length : 0;
    bar.lateral = metal.shear ? lateral : 0;
    bar.tension = metal.limit(metal.tension);
    bar.compression = metal.limit(metal.compression);
    bar.shear = metal.limit(metal.shear, 1 / std::sqrt(3.0));
    bar.hold = 0.5 * length;
    if (!is_usable(bar))
        return map.fault("a stiffness or a strength that is no number a computation can use",
                         "check diameter, area, length, young and yield_strength");
    if (map.fault_count() > 0) return;  // joints are sought in a model without faults
    const std::size_t before = model.bars.size();
    for (const WatchedJoint& joint : lookup.joints_of(model)) {
        const int a = joint.block_a, b = joint.block_b;
        const bool is_between =
            (groups[0].count(a) && groups[1].count(b)) || (groups[1].count(a) && groups[0].count(b));
        if (!is_between) continue;
        if (model.bars.size() >= most_bars) return refuse_more(map);
        bar.name = name + " " + model.blocks[a].name + " " + model.blocks[b].name;
        bar.block_a = a;
        bar.block_b = b;
        bar.anchor_a = joint.centre - model.blocks[a].moments.centroid;
        bar.anchor_b = joint.centre - model.blocks[b].moments.centroid;
        // The normal looks from b to a, a bar from a to b: it is pulled where they part.
        bar.axis = -joint.normal;
        model.bars.push_back(bar);
    }
    if (model.bars.size() == before && !groups[0].empty() && !groups[1].empty())
        between.fault("no joint between these groups", "name groups whose blocks touch");
}

}  // namespace

void read_bars(YamlCursor& top, Model& model)
{
    const std::optional<YamlCursor> section = top.find("bars");
    if (!section) return;
    Lookup lookup(model);
    std::set<std::string> names;
    for (YamlCursor& item : section->items("a list of rods {name, from, to} and dowels {name, between}")) {
        if (!item.expect_map("a rod {name, from, to} or dowels {name, between}")) continue;
        const std::optional<YamlCursor> between = item.find("between");
        const std::string name =
            item.find_text("name").value_or(fmt::format("{} {}", between ? "dowels" : "rod", names.size() + 1));
        if (!names.insert(name).second) item.fault("a second entry named " + name, "give each its own name");
        if (between)
            add_dowels(item, name, *between, lookup, model);
        else
            add_rod(item, name, lookup, model);
    }
}

void refuse_bars(const YamlCursor& written, const Model& model, const Stage& stage)
{
    if (stage.control.open_close == OpenClose::published && !model.bars.empty())
        written.fault("bars with open_close: published, which knows none", "use open_close: newton");
}

}  // namespace voussoir::app::reader
