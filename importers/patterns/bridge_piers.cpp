// Piers of bridges, with cutwaters and imposts.
#include <cmath>

#include "importers/patterns/bond.h"
#include "importers/patterns/bridge_parts.h"
#include "importers/patterns/stone_grid.h"

namespace voussoir::importers::patterns
{
namespace
{

/// One pier while it is built.
struct PierWork {
    BridgeWork& work;
    std::string name;   // "pier_1"
    double middle = 0;  // m, along x
    double impost = 0;  // m, height of the top course, which has the skewbacks

    const Bridge& bridge() const { return work.bridge; }
    double half() const { return bridge().pier_width / 2; }
    double face() const { return bridge().width / 2; }
};

/// The plan of a stone of a course across the pier, its ends with the edges of the cutwaters.
std::vector<Point> plan(const PierWork& pier, double from, double to)
{
    const double left = pier.middle - pier.half(), right = pier.middle + pier.half();
    const double edge = pier.bridge().cutwater;
    std::vector<Point> outline{{left, from}};
    if (from == -pier.face()) outline.emplace_back(pier.middle, from - edge);
    outline.insert(outline.end(), {{right, from}, {right, to}});
    if (to == pier.face()) outline.emplace_back(pier.middle, to + edge);
    outline.emplace_back(left, to);
    return outline;
}

/// Stones through the pier in even courses; in the others those inside are two, side by side, in a wide pier.
void add_course(PierWork& pier, int course, double foot, double top)
{
    const Bridge& bridge = pier.bridge();
    const std::vector<double> joints = joints_of_course(-pier.face(), pier.face(), bridge.block.length, course);
    int number = 0;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const bool is_end = i == 0 || i + 2 == joints.size();
        const bool is_split = !is_end && course % 2 == 1 && bridge.pier_width > 1.5 * bridge.block.length;
        const std::vector<Point> whole = plan(pier, joints[i], joints[i + 1]);
        for (int piece = 0; piece < (is_split ? 2 : 1); ++piece) {
            std::vector<Point> outline = whole;
            if (is_split)
                for (Point& x : outline)
                    if ((x.x() < pier.middle) == (piece == 1)) x.x() = pier.middle;
            const std::string name = pier.name + course_and_block(course + 1, ++number);
            pier.work.pattern.stones.push_back({name, "pier", {prism_up(outline, foot, top, name)}, Play::level});
        }
    }
}

/// The stones that carry both arches.
void add_impost(PierWork& pier, int course)
{
    const Bridge& bridge = pier.bridge();
    const BridgeProfile& profile = pier.work.profile;
    const double half = pier.half(), inside = to_nanometre(half - profile.skewback());
    const double bed = profile.beds[0];
    std::vector<Point> outline{{-half, -pier.impost}, {half, -pier.impost}, {half, 0},
                               {inside, bed},         {-inside, bed},       {-half, 0}};
    for (Point& x : outline) x.x() = to_nanometre(x.x() + pier.middle);
    const std::vector<double> joints = joints_of_course(-pier.face(), pier.face(), bridge.block.length, course);
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const std::string name = pier.name + "_impost_b" + numbered(static_cast<int>(i) + 1, 99);
        pier.work.pattern.stones.push_back(
            {name, "pier", {prism_along_y(outline, joints[i], joints[i + 1], name)}, Play::across});
    }
}

/// The hood of a cutwater: a pyramid on its top against the impost.
void add_hood(PierWork& pier, int side)
{
    const double y = side * pier.face(), tip = y + side * pier.bridge().cutwater, z = -pier.impost;
    const double height = std::min(pier.impost, pier.bridge().cutwater);
    const std::string name = pier.name + (side < 0 ? "_cutwater_south" : "_cutwater_north");
    std::vector<Eigen::Vector3d> x{{pier.middle - pier.half(), y, z},
                                   {pier.middle + pier.half(), y, z},
                                   {pier.middle, tip, z},
                                   {pier.middle, y, z + height}};
    std::vector<std::vector<int>> faces{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    if (side > 0) faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    pier.work.pattern.stones.push_back({name, "pier", {make_convex_polyhedron(x, faces, name)}});
}

/// The slab under a pier.
void add_slab(PierWork& pier)
{
    const Bridge& bridge = pier.bridge();
    const double more = bridge.block.height / 2, foot = -bridge.pier_height;
    const double y = pier.face() + bridge.cutwater + more;
    const std::string name = pier.name + "_slab";
    pier.work.pattern.stones.push_back(
        {name,
         foundation_group,
         {make_box({pier.middle - pier.half() - more, -y, foot - bridge.block.height},
                   {pier.middle + pier.half() + more, y, foot})}});
}

}  // namespace

void add_piers(BridgeWork& work)
{
    const Bridge& bridge = work.bridge;
    const int courses = std::max(1, static_cast<int>(std::lround(bridge.pier_height / bridge.block.height)));
    const double height = bridge.pier_height / courses;
    for (int p = 0; p + 1 < bridge.spans; ++p) {
        PierWork pier{work, bridge.name + "pier_" + std::to_string(p + 1),
                      to_nanometre((work.middle(p) + work.middle(p + 1)) / 2), to_nanometre(height)};
        add_slab(pier);
        const auto bed = [&](int course) {
            return to_nanometre(-bridge.pier_height + (bridge.pier_height - pier.impost) * course / (courses - 1));
        };
        for (int course = 0; course + 1 < courses; ++course)
            add_course(pier, course, bed(course), bed(course + 1));
        add_impost(pier, courses - 1);
        if (bridge.cutwater > 0 && courses > 1)
            for (const int side : {-1, 1}) add_hood(pier, side);
    }
}

}  // namespace voussoir::importers::patterns
