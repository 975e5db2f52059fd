#include "importers/patterns/lantern.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "importers/patterns/grid_pattern.h"
#include "importers/patterns/parameter_checks.h"

namespace voussoir::importers::patterns
{
namespace
{

double azimuth_of(const Dome& dome, int edge)
{
    return std::numbers::pi * edge / dome.stones;  // two edges to a stone
}

/// The edges of the oculus, or those above them at a level.
class Rings
{
 public:
    Rings(const Dome& dome, StoneGrid& grid) : dome_(dome), grid_(grid) {}
    BedLine oculus() const
    {
        return line([&](const Eigen::Vector3d& x) { return x; });
    }
    BedLine at(double level) const
    {
        return line([&](const Eigen::Vector3d& x) { return Eigen::Vector3d(x.x(), x.y(), level); });
    }
    /// `steps` + 1 edges from the edge number `first`.
    static BedLine piece(const BedLine& ring, int first, int steps)
    {
        BedLine line;
        line.reserve(static_cast<std::size_t>(steps) + 1);
        for (int i = 0; i <= steps; ++i) line.push_back(ring[static_cast<std::size_t>(first + i) % ring.size()]);
        return line;
    }

 private:
    template <class Place>
    BedLine line(const Place& place) const
    {
        BedLine line;
        line.reserve(2 * static_cast<std::size_t>(dome_.stones));
        for (int i = 0; i < 2 * dome_.stones; ++i) {
            const auto corner = [&](double radius) {
                return grid_.corner(place(point_of(dome_, radius, dome_.oculus, azimuth_of(dome_, i))));
            };
            const int inner = corner(dome_.radius);
            line.push_back({inner, corner(dome_.radius + dome_.thickness)});
        }
        return line;
    }

    const Dome& dome_;
    StoneGrid& grid_;
};

/// One stone over the whole ring.
ConvexPolyhedron cap_of(const Dome& dome, double foot, const std::string& name)
{
    std::vector<Point> outline;
    outline.reserve(2 * static_cast<std::size_t>(dome.stones));
    for (int i = 0; i < 2 * dome.stones; ++i)
        outline.push_back(to_nanometre(
            Point(point_of(dome, dome.radius + dome.thickness, dome.oculus, azimuth_of(dome, i)).head<2>())));
    return pointed_frustum(outline, foot, {}, foot, to_nanometre(foot + dome.lantern.cap), name);
}

}  // namespace

Eigen::Vector3d point_of(const Dome& dome, double radius, double angle, double azimuth)
{
    const double centre = -dome.radius * std::cos(dome.springing);  // m, of the sphere
    const double r = radius * std::sin(angle);
    return {r * std::cos(azimuth), r * std::sin(azimuth), centre + radius * std::cos(angle)};
}

void check_lantern(const Dome& dome, std::vector<Fault>& faults)
{
    const Lantern& lantern = dome.lantern;
    if (lantern.height == 0) return;
    check_positive("lantern.height", lantern.height, faults);
    check_positive("lantern.ring", lantern.ring, faults);
    check_positive("lantern.cap", lantern.cap, faults);
    if (dome.keystone) faults.push_back({"lantern", "a lantern over a keystone", "leave one of them out"});
    if (!dome.bonded) faults.push_back({"lantern", "a lantern on a dome without bond", "leave out bonded: false"});
    if (dome.stones % 2 == 1)
        faults.push_back({"stones", std::to_string(dome.stones), "must be even under a lantern"});
}

void add_lantern(const Dome& dome, const std::string& prefix, Pattern& pattern)
{
    StoneGrid grid;
    const Rings rings(dome, grid);
    const Lantern& lantern = dome.lantern;
    const double outside = point_of(dome, dome.radius + dome.thickness, dome.oculus, 0).z();
    const double curb = to_nanometre(outside + lantern.ring), post = to_nanometre(curb + lantern.height),
                 top = to_nanometre(post + lantern.ring);
    const BedLine oculus = rings.oculus(), on_curb = rings.at(curb), on_post = rings.at(post),
                  on_top = rings.at(top);
    const auto add = [&](const char* name, int number, int first, int steps, const BedLine& lower,
                         const BedLine& upper) {
        grid.add_faces(grid.add_stone(std::string("lantern_") + name + "_b" + numbered(number, dome.stones)),
                       Rings::piece(lower, first, steps), Rings::piece(upper, first, steps));
    };
    for (int j = 0; j < dome.stones; ++j) add("curb", j + 1, 2 * j + (dome.courses + 1) % 2, 2, oculus, on_curb);
    for (int j = 0; j < dome.stones / 2; ++j) add("post", j + 1, 4 * j + 2 * dome.stones - 1, 2, on_curb, on_post);
    for (int j = 0; j < dome.stones / 2; ++j) add("ring", j + 1, 4 * j, 4, on_post, on_top);
    for (PatternStone& stone : pattern_of(grid, prefix, "lantern").stones)
        pattern.stones.push_back(std::move(stone));
    const std::string cap = prefix + "lantern_cap";
    pattern.stones.push_back({cap, "lantern", {cap_of(dome, top, cap)}});
}

}  // namespace voussoir::importers::patterns
