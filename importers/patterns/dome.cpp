#include <cmath>
#include <numbers>

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
    if (faults.empty()) check_stones("stones", (dome.courses + 1.0) * dome.stones, faults);
    if (!faults.empty()) throw InputError(faults);
}

/// All edges of a bed, counter-clockwise from the x axis. @param angle from the axis [rad]
BedLine ring(StoneGrid& grid, const Dome& dome, double angle, int edges)
{
    const double centre = -dome.radius * std::cos(dome.springing);  // m, of the sphere
    const auto point = [&](double radius, double azimuth) {
        const double r = radius * std::sin(angle);
        return grid.corner({r * std::cos(azimuth), r * std::sin(azimuth), centre + radius * std::cos(angle)});
    };
    BedLine line;
    for (int i = 0; i < edges; ++i) {
        const double azimuth = 2 * std::numbers::pi * i / edges;
        const int inner = point(dome.radius, azimuth);
        line.push_back({inner, point(dome.radius + dome.thickness, azimuth)});
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

}  // namespace

StoneGrid dome(const Dome& dome)
{
    check(dome);
    StoneGrid grid;
    const int steps = dome.bonded ? 2 : 1;  // from head joint to head joint
    std::vector<BedLine> beds;
    for (int i = 0; i <= dome.courses; ++i) {
        const double angle = dome.springing + (dome.oculus - dome.springing) * i / dome.courses;
        beds.push_back(ring(grid, dome, angle, steps * dome.stones));
    }
    BedLine feet;
    for (const ThroughEdge& edge : beds[0]) feet.push_back(grid.foot(edge, -dome.support));
    for (int i = 0; i <= dome.courses; ++i)
        for (int j = 0; j < dome.stones; ++j) {
            const int first = steps * j + (dome.bonded ? i % 2 : 0);
            const std::string number = numbered(j + 1, dome.stones);
            const int stone = grid.add_stone(i == 0 ? "support_" + number
                                                    : "dome_c" + numbered(i, dome.courses) + "_b" + number);
            grid.add_faces(stone, piece(i == 0 ? feet : beds[i - 1], first, steps), piece(beds[i], first, steps));
        }
    if (dome.keystone) grid.add_plug(grid.add_stone("keystone"), beds.back());
    return grid;
}

}  // namespace voussoir::importers::patterns
