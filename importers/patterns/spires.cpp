#include "importers/patterns/spires.h"

#include <vector>

#include "importers/patterns/parameter_checks.h"
#include "libdda/errors.h"

namespace voussoir::importers::patterns
{
namespace
{

void add_slab(Pattern& pattern, const std::string& name, double width)
{
    const double half = to_nanometre(width);
    pattern.stones.push_back(
        {name + "slab", foundation_group, {make_box({-half, -half, -to_nanometre(width / 2)}, {half, half, 0})}});
}

void add_square(Pattern& pattern, const std::string& name, const char* group, double width, double foot,
                double top)
{
    pattern.stones.push_back(
        {name, group, {prism_up(regular_outline({0, 0}, width, 4), foot, top, name)}, Play::level});
}

void check(const Obelisk& obelisk)
{
    std::vector<Fault> faults;
    check_positive("height", obelisk.height, faults);
    check_positive("width", obelisk.width, faults);
    check_positive("top_width", obelisk.top_width, faults);
    check_positive("pyramidion", obelisk.pyramidion, faults);
    check_number("stones", obelisk.stones, 1, faults);
    if (faults.empty() && obelisk.top_width > obelisk.width)
        faults.push_back({"top_width", std::to_string(obelisk.top_width) + " m", "must be at most width"});
    // The point must be steeper than the shaft leans, else the last stone is hollow at its shoulder.
    if (faults.empty() &&
        obelisk.top_width / 2 / obelisk.pyramidion <= (obelisk.width - obelisk.top_width) / 2 / obelisk.height)
        faults.push_back({"pyramidion", std::to_string(obelisk.pyramidion) + " m",
                          "must be blunter than the shaft, or the obelisk has no shoulder: give less"});
    if (obelisk.pedestal_height != 0) {
        check_positive("pedestal.height", obelisk.pedestal_height, faults);
        if (!(obelisk.pedestal_width >= obelisk.width))
            faults.push_back(
                {"pedestal.width", std::to_string(obelisk.pedestal_width) + " m", "must be at least width"});
    }
    if (!faults.empty()) throw InputError(faults);
}

void check(const Pinnacle& pinnacle)
{
    std::vector<Fault> faults;
    check_positive("width", pinnacle.width, faults);
    check_positive("height", pinnacle.height, faults);
    check_number("courses", pinnacle.courses, 1, faults);
    check_positive("spire", pinnacle.spire, faults);
    check_number("spire_stones", pinnacle.spire_stones, 1, faults);
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace

Pattern obelisk(const Obelisk& obelisk, const std::string& name)
{
    check(obelisk);
    Pattern pattern;
    const bool has_pedestal = obelisk.pedestal_height > 0;
    add_slab(pattern, name, has_pedestal ? obelisk.pedestal_width : obelisk.width);
    const double foot = to_nanometre(obelisk.pedestal_height);
    if (has_pedestal) add_square(pattern, name + "pedestal", "pedestal", obelisk.pedestal_width, 0, foot);
    const auto width_at = [&](int bed) {
        return obelisk.width + (obelisk.top_width - obelisk.width) * bed / obelisk.stones;
    };
    const auto level = [&](int bed) { return to_nanometre(foot + obelisk.height * bed / obelisk.stones); };
    for (int i = 0; i < obelisk.stones; ++i) {
        const std::string own = name + "shaft_" + std::to_string(i + 1);
        const std::vector<Point> lower = regular_outline({0, 0}, width_at(i), 4),
                                 upper = regular_outline({0, 0}, width_at(i + 1), 4);
        ConvexPolyhedron shape =
            i + 1 < obelisk.stones
                ? frustum(lower, level(i), upper, level(i + 1), own)
                : pointed_frustum(lower, level(i), upper, level(i + 1),
                                  to_nanometre(foot + obelisk.height + obelisk.pyramidion), own);
        pattern.stones.push_back({own, "shaft", {std::move(shape)}, Play::level});
    }
    return pattern;
}

Pattern pinnacle(const Pinnacle& pinnacle, const std::string& name)
{
    check(pinnacle);
    Pattern pattern;
    add_slab(pattern, name, pinnacle.width);
    const auto level = [&](int bed) { return to_nanometre(pinnacle.height * bed / pinnacle.courses); };
    for (int i = 0; i < pinnacle.courses; ++i)
        add_square(pattern, name + "shaft_" + std::to_string(i + 1), "shaft", pinnacle.width, level(i),
                   level(i + 1));
    const auto outline = [&](int bed) {
        return regular_outline({0, 0}, pinnacle.width * (pinnacle.spire_stones - bed) / pinnacle.spire_stones, 8);
    };
    const auto bed_of_spire = [&](int bed) {
        return to_nanometre(pinnacle.height + pinnacle.spire * bed / pinnacle.spire_stones);
    };
    for (int i = 0; i < pinnacle.spire_stones; ++i) {
        const std::string own = name + "spire_" + std::to_string(i + 1);
        ConvexPolyhedron shape =
            i + 1 < pinnacle.spire_stones
                ? frustum(outline(i), bed_of_spire(i), outline(i + 1), bed_of_spire(i + 1), own)
                : pointed_frustum(outline(i), bed_of_spire(i), {}, bed_of_spire(i), bed_of_spire(i + 1), own);
        pattern.stones.push_back({own, "spire", {std::move(shape)}, Play::level});
    }
    return pattern;
}

}  // namespace voussoir::importers::patterns
