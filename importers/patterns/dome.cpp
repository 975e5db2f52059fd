#include <cmath>
#include <numbers>

#include "importers/patterns/lantern.h"
#include "importers/patterns/parameter_checks.h"
#include "importers/patterns/vaults.h"

namespace voussoir::importers::patterns
{
namespace
{

void check(const Dome& dome)
{
    constexpr double right_angle = std::numbers::pi / 2;
    std::vector<Fault> faults;
    check_positive("radius", dome.radius, faults);
    check_positive("thickness", dome.thickness, faults);
    check_positive("support", dome.support, faults);
    if (!(dome.oculus > 0 && dome.oculus < right_angle))
        faults.push_back({"oculus", in_degrees(dome.oculus), "must be > 0 and < 90 deg from the axis"});
    if (!(dome.springing > dome.oculus && dome.springing <= right_angle))
        faults.push_back({"springing", in_degrees(dome.springing),
                          "must be farther from the axis than the oculus, and at most 90 deg"});
    check_number("courses", dome.courses, 1, faults);
    check_number("stones", dome.stones, 3, faults);
    if (dome.half) {
        check_positive("front", dome.front, faults);
        if (dome.keystone) faults.push_back({"keystone", "a keystone in half a dome", "leave it out"});
        if (dome.lantern.height > 0) faults.push_back({"lantern", "a lantern on half a dome", "leave it out"});
    }
    check_lantern(dome, faults);
    if (faults.empty()) check_stones("stones", (dome.courses + 1.0) * dome.stones, faults);
    if (!faults.empty()) throw InputError(faults);
}

/// Edges from head joint to head joint.
int steps_of(const Dome& dome)
{
    return dome.bonded ? 2 : 1;
}

/// All edges of a bed, counter-clockwise from the x axis; those of half a dome end at it. @param angle from the
/// axis of the dome [rad]
BedLine ring(StoneGrid& grid, const Dome& dome, double angle, int edges)
{
    BedLine line;
    line.reserve(static_cast<std::size_t>(edges) + 1);
    for (int i = 0; i < (dome.half ? edges + 1 : edges); ++i) {
        const double azimuth = (dome.half ? 1 : 2) * std::numbers::pi * i / edges;
        const int inner = grid.corner(point_of(dome, dome.radius, angle, azimuth));
        line.push_back({inner, grid.corner(point_of(dome, dome.radius + dome.thickness, angle, azimuth))});
    }
    return line;
}

/// `steps` + 1 edges of a ring from the edge number `first`.
BedLine piece(const BedLine& ring, int first, int steps)
{
    BedLine line;
    for (int i = 0; i <= steps; ++i) line.push_back(ring[(first + i) % static_cast<int>(ring.size())]);
    return line;
}

/// @param i its number, 0 of the supports; odd ones are turned by half a stone where the dome is bonded
void add_course(StoneGrid& grid, const Dome& dome, const std::string& name, int i, const BedLine& lower,
                const BedLine& upper)
{
    const int steps = steps_of(dome);
    for (int j = 0; j < dome.stones; ++j) {
        const int first = steps * j + (dome.bonded ? i % 2 : 0);
        grid.add_faces(grid.add_stone(name + numbered(j + 1, dome.stones)), piece(lower, first, steps),
                       piece(upper, first, steps));
    }
}

void add_half_course(StoneGrid& grid, const Dome& dome, const std::string& name, int i, const BedLine& lower,
                     const BedLine& upper)
{
    const int steps = steps_of(dome), all = steps * dome.stones;
    std::vector<int> heads{0};
    for (int head = dome.bonded && i % 2 == 1 ? 1 : steps; head < all; head += steps) heads.push_back(head);
    heads.push_back(all);
    for (std::size_t j = 0; j + 1 < heads.size(); ++j)
        grid.add_faces(grid.add_stone(name + numbered(static_cast<int>(j) + 1, dome.stones + 1)),
                       piece(lower, heads[j], heads[j + 1] - heads[j]),
                       piece(upper, heads[j], heads[j + 1] - heads[j]));
}

/// The arch before half a dome: a stone before each end of each course, one in the crown.
void add_front(StoneGrid& grid, const Dome& dome, const BedLine& feet, const std::vector<BedLine>& beds)
{
    const auto forward = [&](int corner, bool is_foot) {
        const Eigen::Vector3d x = grid.corners()[corner] - Eigen::Vector3d(0, dome.front, 0);
        const int number = grid.corner(x);
        return is_foot ? grid.foot(number, x.z()) : number;
    };
    const auto line = [&](const ThroughEdge& edge, bool is_foot = false) {
        return BedLine{{forward(edge.inner, is_foot), forward(edge.outer, is_foot)}, edge};
    };
    for (const bool east : {true, false}) {
        const auto end = [&](const BedLine& bed) { return east ? bed.front() : bed.back(); };
        const std::string side = east ? "front_east" : "front_west";
        grid.add_faces(grid.add_stone("support_" + side), line(end(feet), true), line(end(beds[0])));
        for (int i = 1; i <= dome.courses; ++i)
            grid.add_faces(grid.add_stone(side + "_c" + numbered(i, dome.courses)), line(end(beds[i - 1])),
                           line(end(beds[i])));
    }
    grid.add_faces(grid.add_stone("front_keystone"), line(beds.back().front()), line(beds.back().back()));
}

}  // namespace

StoneGrid dome(const Dome& dome)
{
    check(dome);
    StoneGrid grid;
    const int steps = steps_of(dome);
    std::vector<BedLine> beds;
    for (int i = 0; i <= dome.courses; ++i) {
        const double angle = dome.springing + (dome.oculus - dome.springing) * i / dome.courses;
        beds.push_back(ring(grid, dome, angle, steps * dome.stones));
    }
    BedLine feet;
    for (const ThroughEdge& edge : beds[0]) feet.push_back(grid.foot(edge, -dome.support));
    for (int i = 0; i <= dome.courses; ++i) {
        const BedLine &lower = i == 0 ? feet : beds[i - 1], &upper = beds[i];
        const std::string course = i == 0 ? "support_" : "dome_c" + numbered(i, dome.courses) + "_b";
        if (dome.half)
            add_half_course(grid, dome, course, i, lower, upper);
        else
            add_course(grid, dome, course, i, lower, upper);
    }
    if (dome.half) add_front(grid, dome, feet, beds);
    if (dome.keystone) grid.add_plug(grid.add_stone("keystone"), beds.back());
    return grid;
}

}  // namespace voussoir::importers::patterns
