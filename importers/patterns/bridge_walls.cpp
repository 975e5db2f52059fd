// What stands on the arches of bridges: spandrel walls, backing, fill, parapets.
#include <algorithm>

#include "importers/patterns/bond.h"
#include "importers/patterns/bridge_parts.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{
namespace
{

/// Boxes of a course between two places along x, in rows across whose joints lie half a stone off.
struct CourseOfBoxes {
    std::string name, group;
    int number = 0;              // from 0
    double foot = 0, top = 0;    // m
    double from = 0, to = 0;     // m, along x
    std::vector<double> across;  // m, the rows
    double length = 1;           // m, of a block
};

void add_course(Pattern& pattern, const CourseOfBoxes& boxes)
{
    int number = 0;
    for (std::size_t row = 0; row + 1 < boxes.across.size(); ++row) {
        const std::vector<double> joints =
            joints_of_course(boxes.from, boxes.to, boxes.length, boxes.number + static_cast<int>(row));
        for (std::size_t i = 0; i + 1 < joints.size(); ++i)
            add_box(pattern, boxes.name + course_and_block(boxes.number + 1, ++number), boxes.group,
                    {joints[i], boxes.across[row], boxes.foot}, {joints[i + 1], boxes.across[row + 1], boxes.top});
    }
}

/// What stands in one course of a region.
struct Place {
    int region = 0, course = 0;  // numbers for names, from 0
    double foot = 0, top = 0;    // m
    double from = 0, to = 0;     // m, along x
    bool is_backing = false;     // is it low enough
};

/// Calls `each` with every place: in each bay from below, between its arches and then from its one end to the
/// other, and at last in the courses over the whole bridge.
template <class Each>
void in_places(const BridgeWork& work, const Each& each)
{
    for (const Bay& bay : work.bays) {
        const int backed = work.backing_courses(bay);
        for (int course = 0; course < bay.profile.courses(); ++course)
            for (int region = 0; region <= (course < bay.profile.crown_bed ? bay.arches : 0); ++region) {
                const auto [from, to] = work.reach(bay, region, course);
                each(Place{bay.first_region + region, course, bay.profile.beds[course],
                           bay.profile.beds[course + 1], from, to, course < backed});
            }
    }
    for (std::size_t k = 0; k + 1 < work.through.size(); ++k)
        each(Place{0, work.first_through() + static_cast<int>(k), work.through[k], work.through[k + 1],
                   work.left_end(), work.right_end(), false});
}

/// Adds the weight of the fill above a level rectangle to a stone.
void load(BridgeWork& work, const std::string& stone, double x0, double x1, double y0, double y1, double z)
{
    y0 = std::max(y0, -work.inner());
    y1 = std::min(y1, work.inner());
    const double volume = (x1 - x0) * (y1 - y0) * (work.road() - z);
    if (x1 <= x0 || y1 <= y0 || volume <= 0) return;
    work.pattern.masses.push_back(
        {stone, work.bridge.fill_density * volume, {(x0 + x1) / 2, (y0 + y1) / 2, (z + work.road()) / 2}});
}

/// A level rectangle.
struct Top {
    double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300, z = -1e300;
};

/// Round the corners of a stone that are higher than `above` [m].
Top round_corners(const PatternStone& stone, double above)
{
    Top top;
    for (const ConvexPolyhedron& part : stone.parts)
        for (const Eigen::Vector3d& x : part.vertices) {
            if (x.z() <= above) continue;
            top = {std::min(top.x0, x.x()), std::max(top.x1, x.x()), std::min(top.y0, x.y()),
                   std::max(top.y1, x.y()), std::max(top.z, x.z())};
        }
    return top;
}

/// The rectangle of the highest face of a stone.
Top top_of(const PatternStone& stone)
{
    return round_corners(stone, round_corners(stone, -1e300).z - 1e-9);
}

/// What of the fill rests on imposts and abutments: that beside the feet of the arches, where there is no backing.
void load_feet(BridgeWork& work, const PatternStone& stone)
{
    const Top top = round_corners(stone, -1e300);
    for (const Bay& bay : work.bays)
        for (int region = 0; region <= bay.arches && work.backing_courses(bay) == 0; ++region) {
            const auto [from, to] = work.reach(bay, region, 0);
            load(work, stone.name, std::max(top.x0, from), std::min(top.x1, to), top.y0, top.y1,
                 bay.profile.beds[0]);
        }
}

/// The bay that a place along x [m] is in.
const Bay& bay_at(const BridgeWork& work, double x)
{
    return *std::find_if(work.bays.begin(), work.bays.end() - 1, [x](const Bay& bay) { return x < bay.right; });
}

/// The fill rests on backs and imposts that the backing leaves free, and on the backing.
void add_fill_as_mass(BridgeWork& work)
{
    const std::vector<PatternStone> stones = work.pattern.stones;
    for (const PatternStone& stone : stones) {
        const bool is_foot =
            stone.name.find("_impost_") != std::string::npos || stone.name.find("abutment_") != std::string::npos;
        if (is_foot) load_feet(work, stone);
        if (stone.group != "voussoirs" && stone.group != "backing") continue;
        const Top top = top_of(stone);
        const Bay& bay = bay_at(work, (top.x0 + top.x1) / 2);
        const double backed = bay.profile.beds[work.backing_courses(bay)];
        if (top.z >= backed - 1e-9) load(work, stone.name, top.x0, top.x1, top.y0, top.y1, top.z);
    }
}

}  // namespace

void add_spandrels(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const double face = bridge.width / 2;
    for (const int side : {-1, 1}) {
        std::vector<double> across{side * face, side * work.inner()};
        std::sort(across.begin(), across.end());
        const std::string name = bridge.name + (side < 0 ? "spandrel_south_" : "spandrel_north_");
        in_places(work, [&](const Place& place) {
            add_course(work.pattern, {name + std::to_string(place.region + 1), "spandrel", place.course,
                                      place.foot, place.top, place.from, place.to, across, bridge.block.length});
        });
    }
}

void add_backing_and_fill(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const bool has_blocks = bridge.fill == Fill::blocks;
    in_places(work, [&](const Place& place) {
        if (!place.is_backing && !has_blocks) return;
        const std::string group = place.is_backing ? "backing" : "fill";
        const double length = bridge.block.length * (place.is_backing ? 1 : 2);
        const std::vector<double> across = joints_of_course(-work.inner(), work.inner(), length, place.course);
        add_course(work.pattern, {bridge.name + group + "_" + std::to_string(place.region + 1), group,
                                  place.course, place.foot, place.top, place.from, place.to, across, length});
    });
    if (bridge.fill == Fill::mass) add_fill_as_mass(work);
}

void add_parapets(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const double face = bridge.width / 2, road = work.road();
    const std::vector<double> joints =
        joints_of_course(work.left_end(), work.right_end(), 1.5 * bridge.block.length, 0);
    for (const int side : {-1, 1})
        for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
            const double outer = side * face, inner = side * (face - bridge.parapet_thickness);
            add_box(work.pattern,
                    bridge.name + (side < 0 ? "parapet_south_b" : "parapet_north_b") +
                        numbered(static_cast<int>(i) + 1, 99),
                    "parapet", {joints[i], std::min(outer, inner), road},
                    {joints[i + 1], std::max(outer, inner), to_nanometre(road + bridge.parapet_height)});
        }
}

}  // namespace voussoir::importers::patterns
