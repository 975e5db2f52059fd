#include "importers/patterns/bridge.h"

#include <algorithm>
#include <cmath>

#include "importers/patterns/arch.h"
#include "importers/patterns/bond.h"
#include "importers/patterns/bridge_parts.h"
#include "importers/patterns/parameter_checks.h"

namespace voussoir::importers::patterns
{
namespace
{

void check_sizes(const Bridge& bridge, std::vector<Fault>& faults)
{
    check_positive("width", bridge.width, faults);
    check_number("stones_across", bridge.stones_across, 1, faults);
    check_positive("block", bridge.block.length, faults);
    check_positive("block", bridge.block.height, faults);
    check_positive("abutment_length", bridge.abutment_length, faults);
    check_positive("pier_width", bridge.pier_width, faults);
    check_positive("pier_height", bridge.pier_height, faults);
    check_positive("fill_density", bridge.fill_density, faults);
    const auto at_least_0 = [&](const char* name, double value) {
        if (!(value >= 0 && std::isfinite(value)))
            faults.push_back({name, std::to_string(value), "must be >= 0 m"});
    };
    at_least_0("cutwater", bridge.cutwater);
    at_least_0("spandrel_thickness", bridge.spandrel_thickness);
    at_least_0("backing", bridge.backing);
    at_least_0("cover", bridge.cover);
    at_least_0("parapet", bridge.parapet_height);
}

bool are_alike(const ArchCurve& a, const ArchCurve& b)
{
    return a.shape == b.shape && a.span == b.span && a.rise == b.rise && a.side_arc == b.side_arc &&
           a.thickness == b.thickness && a.springing_thickness == b.springing_thickness &&
           a.voussoirs == b.voussoirs;
}

/// Faults of equal arches are named by the bridge's own keys, those of others by "spans[1].rise".
void check_arches(const Bridge& bridge, std::vector<Fault>& faults)
{
    check_number("spans", static_cast<int>(bridge.arches.size()), 1, faults);
    const bool equal = std::all_of(bridge.arches.begin(), bridge.arches.end(),
                                   [&](const ArchCurve& arch) { return are_alike(arch, bridge.arches[0]); });
    for (std::size_t a = 0; a < (equal ? std::min<std::size_t>(1, bridge.arches.size()) : bridge.arches.size());
         ++a) {
        std::vector<Fault> own;
        check_curve(bridge.arches[a], own);
        if (bridge.arches[a].shape == ArchShape::pointed && bridge.arches[a].voussoirs % 2 == 1)
            own.push_back(
                {"voussoirs", "an odd number in a pointed bridge", "give an even one: a joint in the crown"});
        for (Fault& fault : own) {
            if (!equal) fault.place = "spans[" + std::to_string(a) + "]." + fault.place;
            faults.push_back(std::move(fault));
        }
    }
}

void check_walls(const Bridge& bridge, std::vector<Fault>& faults)
{
    const bool has_walls = bridge.spandrel_thickness > 0;
    if (bridge.spandrel_thickness > 0.4 * bridge.width)
        faults.push_back({"spandrel_thickness", std::to_string(bridge.spandrel_thickness) + " m",
                          "must be at most two fifths of the width"});
    if (!has_walls && (bridge.fill != Fill::none || bridge.parapet_height > 0))
        faults.push_back({"spandrel_thickness", "no spandrel walls", "fill and parapets need them"});
    if (bridge.parapet_height > 0 && bridge.parapet_thickness > bridge.spandrel_thickness + 1e-9)
        faults.push_back({"parapet", "thicker than the wall below it", "must be at most spandrel_thickness"});
}

void check(const Bridge& bridge)
{
    std::vector<Fault> faults;
    check_arches(bridge, faults);
    check_sizes(bridge, faults);
    check_stone_imperfection(bridge.imperfection, faults);
    check_walls(bridge, faults);
    if (bridge.block.height > bridge.pier_height)
        faults.push_back(
            {"pier_height", std::to_string(bridge.pier_height) + " m", "must be at least one course"});
    if (!faults.empty()) throw InputError(faults);
    double length = 2 * bridge.abutment_length, rise = 0;
    for (const ArchCurve& arch : bridge.arches) {
        length += arch.span + bridge.pier_width;
        rise = std::max(rise, arch.rise);
    }
    const double volume = length * bridge.width * (rise + bridge.pier_height + bridge.cover + 1);
    check_stones("block", volume / (bridge.block.length * bridge.block.length * bridge.block.height), faults);
    if (!faults.empty()) throw InputError(faults);
}

void check_room(const BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const double least = 0.3 * bridge.block.length;
    std::vector<Fault> faults;
    double widest = 0, at_ends = 0;  // m, what arches take of a pier, and of an abutment
    for (int a = 0; a < work.spans(); ++a) {
        const double reach = work.bay_of(a).profile.skewback();
        if (a > 0) widest = std::max(widest, reach + work.bay_of(a - 1).profile.skewback());
        if (a == 0 || a + 1 == work.spans()) at_ends = std::max(at_ends, reach);
    }
    if (work.spans() > 1 && bridge.pier_width < widest + least)
        faults.push_back(
            {"pier_width", std::to_string(bridge.pier_width) + " m",
             "the arches on both sides and a stone between them need " + std::to_string(widest + least) + " m"});
    if (bridge.abutment_length < at_ends + least)
        faults.push_back({"abutment_length", std::to_string(bridge.abutment_length) + " m",
                          "must be at least " + std::to_string(at_ends + least) + " m"});
    if (!faults.empty()) throw InputError(faults);
}

std::vector<double> middles_of(const Bridge& bridge)
{
    double length = -bridge.pier_width;
    for (const ArchCurve& arch : bridge.arches) length += arch.span + bridge.pier_width;
    std::vector<double> middles;
    double at = -length / 2;
    for (const ArchCurve& arch : bridge.arches) {
        middles.push_back(to_nanometre(at + arch.span / 2));
        at += arch.span + bridge.pier_width;
    }
    return middles;
}

/// Profiles whose crowns lie less than this share of a course below the highest one are drawn up to it.
constexpr double least_course = 0.3;

void add_bays(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const double course = bridge.block.height;
    double crown = 0;
    for (int a = 0; a < work.spans(); ++a) {
        if (a > 0 && are_alike(bridge.arches[a], bridge.arches[a - 1])) {
            ++work.bays.back().arches;
            continue;
        }
        const int region = a == 0 ? 0 : work.bays.back().first_region + work.bays.back().arches + 1;
        work.bays.push_back({a, 1, region, 0, 0, profile_of(bridge.arches[a], course)});
        crown = std::max(crown, work.bays.back().profile.crown());
    }
    for (Bay& bay : work.bays) {
        if (bay.profile.crown() > crown - least_course * course)
            bay.profile = profile_of(bridge.arches[bay.first], course, crown);
        bay.profile.carry_on(crown, course);
        bay.left = bay.first == 0 ? work.left_end() : work.pier_middle(bay.first - 1);
        bay.right = bay.end() == work.spans() ? work.right_end() : work.pier_middle(bay.end() - 1);
    }
    BridgeProfile over{{}, {}, {crown}, 0};
    over.carry_on(to_nanometre(crown + bridge.cover), course);
    work.through = over.beds;
}

}  // namespace

void add_box(Pattern& pattern, const std::string& name, const std::string& group, const Eigen::Vector3d& lower,
             const Eigen::Vector3d& upper)
{
    pattern.stones.push_back({name, group, {make_box(lower, upper)}, Play::level});
}

std::string course_and_block(int course, int block)
{
    return "_c" + numbered(course, 99) + "_b" + numbered(block, 99);
}

void add_arches(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    for (int a = 0; a < work.spans(); ++a) {
        const int count = bridge.arches[a].voussoirs;
        for (int i = 0; i < count; ++i) {
            const std::string name =
                bridge.name + "arch_" + std::to_string(a + 1) + "_" + voussoir_name(i + 1, count);
            std::vector<Point> outline = work.bay_of(a).profile.outline(i);
            for (Point& x : outline) x.x() = to_nanometre(x.x() + work.middles[a]);
            const std::vector<double> across =
                joints_of_course(-bridge.width / 2, bridge.width / 2, bridge.width / bridge.stones_across, i);
            for (std::size_t b = 0; b + 1 < across.size(); ++b) {
                const std::string own =
                    bridge.stones_across == 1 ? name : name + "_b" + numbered(static_cast<int>(b) + 1, 99);
                work.pattern.stones.push_back(
                    {own, "voussoirs", {prism_along_y(outline, across[b], across[b + 1], own)}, Play::across});
            }
        }
    }
}

void add_abutments(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    for (const int side : {1, -1}) {  // the right one is drawn as the image of a left one
        const bool is_left = side > 0;
        const ArchJoint& joint = (is_left ? work.bays.front() : work.bays.back()).profile.joints.front();
        const double middle = is_left ? work.middles.front() : -work.middles.back();
        const double end = is_left ? work.left_end() : -work.right_end();
        const std::string name = bridge.name + (is_left ? "abutment_left" : "abutment_right");
        std::vector<Point> outline{{end, -bridge.pier_height},
                                   {joint.intrados.x() + middle, -bridge.pier_height},
                                   joint.intrados + Point(middle, 0),
                                   joint.extrados + Point(middle, 0),
                                   {end, joint.extrados.y()}};
        for (Point& x : outline) x = to_nanometre(Point(side * x.x(), x.y()));
        work.pattern.stones.push_back(
            {name, foundation_group, {prism_along_y(outline, -bridge.width / 2, bridge.width / 2, name)}});
    }
}

Pattern bridge(const Bridge& bridge)
{
    check(bridge);
    BridgeWork work{bridge, middles_of(bridge), {}, {}, {}};
    add_bays(work);
    check_room(work);
    add_abutments(work);
    add_piers(work);
    add_arches(work);
    if (bridge.spandrel_thickness > 0) add_spandrels(work);
    add_backing_and_fill(work);
    if (bridge.parapet_height > 0) add_parapets(work);
    disturb(work.pattern, bridge.imperfection);
    return std::move(work.pattern);
}

}  // namespace voussoir::importers::patterns
