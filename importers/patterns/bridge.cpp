#include "importers/patterns/bridge.h"

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
    check_number("spans", bridge.spans, 1, faults);
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

void check(const Bridge& bridge)
{
    std::vector<Fault> faults;
    check_curve(bridge.curve, faults);
    check_sizes(bridge, faults);
    check_stone_imperfection(bridge.imperfection, faults);
    const bool has_walls = bridge.spandrel_thickness > 0;
    if (bridge.curve.shape == ArchShape::pointed && bridge.curve.voussoirs % 2 == 1)
        faults.push_back(
            {"voussoirs", "an odd number in a pointed bridge", "give an even one: a joint in the crown"});
    if (bridge.spandrel_thickness > 0.4 * bridge.width)
        faults.push_back({"spandrel_thickness", std::to_string(bridge.spandrel_thickness) + " m",
                          "must be at most two fifths of the width"});
    if (!has_walls && (bridge.fill != Fill::none || bridge.parapet_height > 0))
        faults.push_back({"spandrel_thickness", "no spandrel walls", "fill and parapets need them"});
    if (bridge.parapet_height > 0 && bridge.parapet_thickness > bridge.spandrel_thickness + 1e-9)
        faults.push_back({"parapet", "thicker than the wall below it", "must be at most spandrel_thickness"});
    if (bridge.block.height > bridge.pier_height)
        faults.push_back(
            {"pier_height", std::to_string(bridge.pier_height) + " m", "must be at least one course"});
    if (!faults.empty()) throw InputError(faults);
    const double volume = bridge.spans * (bridge.curve.span + bridge.pier_width + 2 * bridge.abutment_length) *
                          bridge.width * (bridge.curve.rise + bridge.pier_height + bridge.cover + 1);
    check_stones("block", volume / (bridge.block.length * bridge.block.length * bridge.block.height), faults);
    if (!faults.empty()) throw InputError(faults);
}

void check_room(const BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const double least = 0.3 * bridge.block.length, reach = work.profile.skewback();
    std::vector<Fault> faults;
    if (bridge.spans > 1 && bridge.pier_width < 2 * reach + least)
        faults.push_back({"pier_width", std::to_string(bridge.pier_width) + " m",
                          "the arches on both sides and a stone between them need " +
                              std::to_string(2 * reach + least) + " m"});
    if (bridge.abutment_length < reach + least)
        faults.push_back({"abutment_length", std::to_string(bridge.abutment_length) + " m",
                          "must be at least " + std::to_string(reach + least) + " m"});
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace

std::pair<double, double> BridgeWork::reach(int region, int course) const
{
    if (course >= profile.crown_bed) return {left_end(), -left_end()};
    const double from_middle = profile.end_of_course(course);  // < 0
    return {region == 0 ? left_end() : middle(region - 1) - from_middle,
            region == bridge.spans ? -left_end() : middle(region) + from_middle};
}

int BridgeWork::backing_courses() const
{
    int courses = 0;
    while (courses < profile.crown_bed && profile.beds[courses + 1] <= profile.beds[0] + bridge.backing + 1e-6)
        ++courses;
    return courses;
}

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
    const int count = bridge.curve.voussoirs;
    for (int a = 0; a < bridge.spans; ++a)
        for (int i = 0; i < count; ++i) {
            const std::string name =
                bridge.name + "arch_" + std::to_string(a + 1) + "_" + voussoir_name(i + 1, count);
            std::vector<Point> outline = work.profile.outline(i);
            for (Point& x : outline) x.x() = to_nanometre(x.x() + work.middle(a));
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

void add_abutments(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const ArchJoint& joint = work.profile.joints.front();
    for (const int side : {1, -1}) {
        const std::string name = bridge.name + (side > 0 ? "abutment_left" : "abutment_right");
        std::vector<Point> outline{{work.left_end(), -bridge.pier_height},
                                   {joint.intrados.x() + work.middle(0), -bridge.pier_height},
                                   joint.intrados + Point(work.middle(0), 0),
                                   joint.extrados + Point(work.middle(0), 0),
                                   {work.left_end(), joint.extrados.y()}};
        for (Point& x : outline) x = to_nanometre(Point(side * x.x(), x.y()));
        work.pattern.stones.push_back(
            {name, foundation_group, {prism_along_y(outline, -bridge.width / 2, bridge.width / 2, name)}});
    }
}

Pattern bridge(const Bridge& bridge)
{
    check(bridge);
    BridgeWork work{bridge, profile_of(bridge), {}};
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
