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
    int arch = 0;       // behind which it stands, from 0
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

/// The elevation of a half of an impost on one side, from the middle of the pier outwards (-1: to the left).
std::vector<Point> half_impost(const PierWork& pier, int side)
{
    const BridgeProfile& profile = pier.work.bay_of(side < 0 ? pier.arch : pier.arch + 1).profile;
    const double half = pier.half(), inside = to_nanometre(half - profile.skewback());
    return {{0, -pier.impost},
            {side * half, -pier.impost},
            {side * half, 0},
            {side * inside, profile.beds[0]},
            {0, profile.beds[0]}};
}

/// The elevation of an impost: of two outlines, glued in the middle, where the arches end at different levels.
std::vector<std::vector<Point>> impost_outlines(const PierWork& pier)
{
    std::vector<Point> left = half_impost(pier, -1), right = half_impost(pier, 1);
    for (std::vector<Point>* half : {&left, &right})
        for (Point& x : *half) x.x() = to_nanometre(x.x() + pier.middle);
    if (left.back().y() != right.back().y()) return {left, right};
    std::vector<Point> whole(right.begin() + 1, right.end() - 1);
    whole.insert(whole.end(), left.rbegin() + 1, left.rend() - 1);
    return {whole};
}

/// The stones that carry both arches.
void add_impost(PierWork& pier, int course)
{
    const Bridge& bridge = pier.bridge();
    const std::vector<std::vector<Point>> outlines = impost_outlines(pier);
    const std::vector<double> joints = joints_of_course(-pier.face(), pier.face(), bridge.block.length, course);
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const std::string name = pier.name + "_impost_b" + numbered(static_cast<int>(i) + 1, 99);
        PatternStone stone{name, "pier", {}, Play::across};
        for (const std::vector<Point>& outline : outlines)
            stone.parts.push_back(prism_along_y(outline, joints[i], joints[i + 1], name));
        if (outlines.size() > 1)
            for (ConvexPolyhedron& part : stone.parts) glue(part, {pier.middle, 0, 0}, {1, 0, 0});
        pier.work.pattern.stones.push_back(std::move(stone));
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
    for (int p = 0; p + 1 < work.spans(); ++p) {
        PierWork pier{work, bridge.name + "pier_" + std::to_string(p + 1), p, work.pier_middle(p),
                      to_nanometre(height)};
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
