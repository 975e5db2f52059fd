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
    int region = 0, course = 0;  // from 0
    std::vector<double> across;  // m, the rows
    double length = 1;           // m, of a block
};

void add_course(BridgeWork& work, const CourseOfBoxes& boxes)
{
    const auto [from, to] = work.reach(boxes.region, boxes.course);
    const double foot = work.profile.beds[boxes.course], top = work.profile.beds[boxes.course + 1];
    int number = 0;
    for (std::size_t row = 0; row + 1 < boxes.across.size(); ++row) {
        const std::vector<double> joints =
            joints_of_course(from, to, boxes.length, boxes.course + static_cast<int>(row));
        for (std::size_t i = 0; i + 1 < joints.size(); ++i)
            add_box(work.pattern, boxes.name + course_and_block(boxes.course + 1, ++number), boxes.group,
                    {joints[i], boxes.across[row], foot}, {joints[i + 1], boxes.across[row + 1], top});
    }
}

/// Calls `each` with every region of a course: between the arches, or one from end to end above them.
template <class Each>
void in_regions(const BridgeWork& work, int course, const Each& each)
{
    const int regions = course < work.profile.crown_bed ? work.bridge.spans + 1 : 1;
    for (int region = 0; region < regions; ++region) each(region);
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

/// The level top of a stone: the rectangle of its highest face.
struct Top {
    double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300, z = -1e300;
};

Top top_of(const PatternStone& stone)
{
    Top top;
    for (const Eigen::Vector3d& x : stone.parts[0].vertices) top.z = std::max(top.z, x.z());
    for (const Eigen::Vector3d& x : stone.parts[0].vertices)
        if (x.z() > top.z - 1e-9) {
            top.x0 = std::min(top.x0, x.x());
            top.x1 = std::max(top.x1, x.x());
            top.y0 = std::min(top.y0, x.y());
            top.y1 = std::max(top.y1, x.y());
        }
    return top;
}

/// The fill rests on backs and imposts that the backing leaves free, and on the backing.
void add_fill_as_mass(BridgeWork& work)
{
    const double backed = work.profile.beds[work.backing_courses()];
    const bool has_backing = work.backing_courses() > 0;
    const std::vector<PatternStone> stones = work.pattern.stones;
    for (const PatternStone& stone : stones) {
        const bool bears = stone.group == "voussoirs" || stone.name.find("_impost_") != std::string::npos ||
                           stone.group == "backing" || stone.group == foundation_group;
        if (!bears) continue;
        const Top top = top_of(stone);
        const bool is_free = has_backing ? top.z >= backed - 1e-9 : top.z >= work.profile.beds[0] - 1e-9;
        if (!is_free) continue;
        if (stone.group == "voussoirs" || stone.group == "backing") {
            load(work, stone.name, top.x0, top.x1, top.y0, top.y1, top.z);
            continue;
        }
        for (int region = 0; region <= work.bridge.spans; ++region) {  // beside the feet of the arches
            const auto [from, to] = work.reach(region, 0);
            load(work, stone.name, std::max(top.x0, from), std::min(top.x1, to), top.y0, top.y1, top.z);
        }
    }
}

}  // namespace

void add_spandrels(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const double face = bridge.width / 2;
    for (const int side : {-1, 1})
        for (int course = 0; course < work.profile.courses(); ++course)
            in_regions(work, course, [&](int region) {
                std::vector<double> across{side * face, side * work.inner()};
                std::sort(across.begin(), across.end());
                add_course(work, {bridge.name + (side < 0 ? "spandrel_south_" : "spandrel_north_") +
                                      std::to_string(region + 1),
                                  "spandrel", region, course, across, bridge.block.length});
            });
}

void add_backing_and_fill(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const int backed = work.backing_courses();
    const bool has_blocks = bridge.fill == Fill::blocks;
    for (int course = 0; course < (has_blocks ? work.profile.courses() : backed); ++course)
        in_regions(work, course, [&](int region) {
            const bool is_backing = course < backed;
            const double length = bridge.block.length * (is_backing ? 1 : 2);
            const std::vector<double> across = joints_of_course(-work.inner(), work.inner(), length, course);
            add_course(work, {bridge.name + (is_backing ? "backing_" : "fill_") + std::to_string(region + 1),
                              is_backing ? "backing" : "fill", region, course, across, length});
        });
    if (bridge.fill == Fill::mass) add_fill_as_mass(work);
}

void add_parapets(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const double face = bridge.width / 2, road = work.road();
    const std::vector<double> joints =
        joints_of_course(work.left_end(), -work.left_end(), 1.5 * bridge.block.length, 0);
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
