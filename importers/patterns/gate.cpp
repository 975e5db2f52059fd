#include "importers/patterns/gate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "importers/patterns/arch.h"
#include "importers/patterns/bond.h"
#include "importers/patterns/bridge_profile.h"
#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/stone_courses.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{
namespace
{

/// A gate while it is built.
struct GateWork {
    const Gate& gate;
    std::string name;
    BridgeProfile profile;
    Pattern pattern;

    double face() const { return to_nanometre(gate.curve.span / 2); }                    // of the piers, m
    double back() const { return to_nanometre(gate.curve.span / 2 + gate.pier_width); }  // m
    double half() const { return to_nanometre(gate.depth / 2); }
};

void check_sizes(const Gate& gate)
{
    std::vector<Fault> faults;
    check_curve(gate.curve, faults);
    check_positive("depth", gate.depth, faults);
    check_positive("block", gate.block.length, faults);
    check_positive("block", gate.block.height, faults);
    check_positive("pier.width", gate.pier_width, faults);
    check_positive("pier.height", gate.pier_height, faults);
    check_number("stones_across", gate.stones_across, 1, faults);
    if (!(gate.attic >= 0)) faults.push_back({"attic", std::to_string(gate.attic) + " m", "must be >= 0 m"});
    if (gate.curve.shape == ArchShape::pointed && gate.curve.voussoirs % 2 == 1)
        faults.push_back(
            {"voussoirs", "an odd number in a pointed gate", "give an even one: a joint in the crown"});
    if (!faults.empty()) throw InputError(faults);
    const double stone = gate.block.length * gate.block.length * gate.block.height;
    check_stones("block",
                 (gate.curve.span + 2 * gate.pier_width) * gate.depth *
                     (gate.curve.rise + gate.pier_height + gate.attic + 1) / stone,
                 faults);
    if (!faults.empty()) throw InputError(faults);
}

void check_room(const GateWork& work)
{
    const double least = work.profile.skewback() + 0.3 * work.gate.block.length;
    if (work.gate.pier_width < least)
        throw InputError("pier.width", std::to_string(work.gate.pier_width) + " m",
                         "the end of the arch and a stone beside it need " + std::to_string(least) + " m");
}

void add(GateWork& work, const std::string& own, const char* group, ConvexPolyhedron shape, Play play)
{
    work.pattern.stones.push_back({work.name + own, group, {std::move(shape)}, play});
}

/// @param side -1 on the left, 1 on the right
std::pair<double, double> sorted(int side, double inner, double outer)
{
    return side < 0 ? std::pair(-outer, -inner) : std::pair(inner, outer);
}

void add_pier(GateWork& work, int side)
{
    const Gate& gate = work.gate;
    const std::string which = side < 0 ? "left" : "right";
    const double half = work.half(), foot = to_nanometre(-gate.pier_height),
                 more = to_nanometre(gate.block.height / 2);
    const int courses = std::max(1, static_cast<int>(std::lround(gate.pier_height / gate.block.height)));
    const double bed = to_nanometre(-gate.pier_height / courses);
    const auto slab = sorted(side, work.face() - more, work.back() + more),
               pier = sorted(side, work.face(), work.back());
    add(work, "slab_" + which, foundation_group,
        make_box({slab.first, -half - more, foot - 2 * more}, {slab.second, half + more, foot}), Play::none);
    if (bed > foot)
        add_courses(work.pattern,
                    {work.name + "pier_" + which, "pier", pier, {-half, half}, {foot, bed}, gate.block});
    const Point& end = work.profile.joints.back().extrados;
    std::vector<Point> outline{
        {work.face(), bed}, {work.back(), bed}, {work.back(), end.y()}, end, {work.face(), 0}};
    for (Point& x : outline) x.x() *= side;
    const std::string own = "pier_" + which + "_impost";
    add(work, own, "pier", prism_along_y(outline, -half, half, work.name + own), Play::across);
}

void add_voussoirs(GateWork& work)
{
    const Gate& gate = work.gate;
    const int count = gate.curve.voussoirs;
    for (int i = 0; i < count; ++i) {
        const std::string voussoir = voussoir_name(i + 1, count);
        const std::vector<double> across =
            joints_of_course(-work.half(), work.half(), gate.depth / gate.stones_across, i);
        for (std::size_t b = 0; b + 1 < across.size(); ++b) {
            const std::string own =
                gate.stones_across == 1 ? voussoir : voussoir + "_b" + numbered(static_cast<int>(b) + 1, 99);
            add(work, own, "voussoirs",
                prism_along_y(work.profile.outline(i), across[b], across[b + 1], work.name + own), Play::across);
        }
    }
}

/// The courses beside the arch and over it.
void add_walls(GateWork& work)
{
    const Gate& gate = work.gate;
    for (int course = 0; course < work.profile.courses(); ++course) {
        const std::pair<double, double> level{work.profile.beds[course], work.profile.beds[course + 1]};
        const bool is_over = course >= work.profile.crown_bed;
        const int number = 1 + course - (is_over ? work.profile.crown_bed : 0);
        for (const int side : {-1, 1}) {
            if (is_over && side > 0) continue;
            const double end = is_over ? 0 : -work.profile.end_of_course(course);
            const auto reach = is_over ? std::pair(-work.back(), work.back()) : sorted(side, end, work.back());
            const std::string own = is_over ? "attic" : side < 0 ? "wall_left" : "wall_right";
            add_course(work.pattern,
                       {work.name + own, "wall", reach, {-work.half(), work.half()}, level, gate.block}, number);
        }
    }
}

}  // namespace

Pattern gate(const Gate& gate, const std::string& name)
{
    check_sizes(gate);
    GateWork work{gate, name, profile_of(gate.curve, gate.block.height), {}};
    work.profile.carry_on(to_nanometre(work.profile.crown() + gate.attic), gate.block.height);
    check_room(work);
    for (const int side : {-1, 1}) add_pier(work, side);
    add_voussoirs(work);
    add_walls(work);
    return std::move(work.pattern);
}

}  // namespace voussoir::importers::patterns
