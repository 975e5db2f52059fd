// Rock cut by joint sets as a case file gives it.
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "app/reader/pattern_keys.h"
#include "importers/helper/rock.h"
#include "importers/patterns/convex_outlines.h"
#include "importers/patterns/max_blocks.h"
#include "importers/patterns/stone_grid.h"
#include "libdda/geometry/moments.h"

namespace voussoir::app::reader
{

namespace patterns = importers::patterns;
namespace exact = importers::exact;
using words::Range;
namespace dimension = words::dimension;

namespace
{

/// `outline: [[x, z], ...]` and `width` along y, about y = 0.
std::vector<ConvexPolyhedron> read_domain(YamlCursor& map)
{
    const auto outline = map.require("outline", "corners of the rock's elevation, [[x, z], ...]");
    const double width = map.quantity_or("width", dimension::length, Range::positive(), 1);
    if (!outline) return {};
    std::vector<patterns::Point> corners;
    const std::size_t before = map.fault_count();
    for (const YamlCursor& corner : outline->items("corners [[x, z], ...]"))
        corners.push_back(corner.as_plane_vector(dimension::length));
    if (map.fault_count() > before) return {};
    std::vector<ConvexPolyhedron> parts;
    const std::vector<std::vector<patterns::Point>> outlines = patterns::convex_outlines(corners);
    for (const std::vector<patterns::Point>& part : outlines)
        parts.push_back(patterns::prism_along_y(part, -width / 2, width / 2, "outline"));
    // Sides that two outlines share lie inside the rock.
    for (std::size_t p = 0; p < outlines.size(); ++p) {
        const std::size_t n = outlines[p].size();
        for (std::size_t i = 0; i < n; ++i) {
            const patterns::Point &a = outlines[p][i], &b = outlines[p][(i + 1) % n];
            for (std::size_t q = 0; q < outlines.size(); ++q)
                for (std::size_t k = 0; k < outlines[q].size() && q != p; ++k)
                    if (outlines[q][k] == b && outlines[q][(k + 1) % outlines[q].size()] == a)
                        patterns::glue(parts[p], {a.x(), 0, a.y()}, {b.y() - a.y(), 0, a.x() - b.x()});
        }
    }
    return parts;
}

/// `{dip, dip_direction, spacing, origin, scatter, persistence}`.
exact::JointSet read_set(YamlCursor& map)
{
    exact::JointSet set;
    const double dip = map.quantity("dip", dimension::angle, Range{0, std::numbers::pi / 2, true, true});
    const double direction =
        map.quantity_or("dip_direction", dimension::angle, Range::any(), std::numbers::pi / 2);
    set.spacing = map.quantity("spacing", dimension::length, Range::positive());
    if (const auto origin = map.find("origin")) set.origin = origin->as_vector(dimension::length);
    set.scatter = map.quantity_or("scatter", dimension::number, Range{0, 0.5, true, false}, 0);
    set.persistence = map.quantity_or("persistence", dimension::number, Range{0, 1, true, true}, 1);
    // The azimuth runs from north (y) to east (x); what is 0 but for the rounding of pi is 0.
    const auto cleaned = [](double x) { return std::abs(x) < 1e-15 ? 0.0 : x; };
    set.normal = {std::sin(dip) * cleaned(std::sin(direction)), std::sin(dip) * cleaned(std::cos(direction)),
                  cleaned(std::cos(dip))};
    map.reject_unknown_keys();
    return set;
}

patterns::Pattern rock_of(const exact::RockRequest& request, const std::string& name, const YamlCursor& map)
{
    const exact::CutRock rock = importers::helper::ask_for_rock(request, {});
    if (rock.removed > 0)
        map.warn(fmt::format("{} blocks smaller than {:.3g} m3 were left out, {:.3g} m3 in all", rock.removed,
                             request.smallest, rock.removed_volume));
    if (rock.merged > 0)
        map.warn(
            fmt::format("{} blocks smaller than {:.3g} m3 were merged with their neighbours, {:.3g} m3 in all",
                        rock.merged, request.smallest, rock.merged_volume));
    patterns::Pattern pattern;
    const int count = static_cast<int>(rock.blocks.size());
    for (int i = 0; i < count; ++i)
        pattern.stones.push_back(
            {name + "block_" + patterns::numbered(i + 1, count), "rock", rock.blocks[i].parts});
    return pattern;
}

}  // namespace

void read_rock(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!map.expect_map("rock {outline: [[x, z], ...], sets: [{dip, dip_direction, spacing}]}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    const std::string name = read_name_prefix(map);
    exact::RockRequest request;
    try {
        request.domain = read_domain(map);
    } catch (const InputError& error) {
        place_faults(error, map);
    }
    if (const auto sets = map.require("sets", "joint sets, [{dip: 35 deg, dip_direction: 90 deg, spacing: 10 m}]"))
        for (YamlCursor& item : sets->items("a list of joint sets {dip, dip_direction, spacing, ...}"))
            if (item.expect_map("a joint set {dip, dip_direction, spacing, ...}"))
                request.sets.push_back(read_set(item));
    request.seed = static_cast<std::uint64_t>(map.integer_or("seed", 0, 2147483647, 1));
    double volume = 0;
    for (const ConvexPolyhedron& part : request.domain) volume += moments_of(part).volume;
    // A size is the cube root of a volume.
    request.smallest = std::pow(
        map.quantity_or("smallest", dimension::length, Range::non_negative(), 1e-3 * std::cbrt(volume)), 3);
    request.merge = map.choice_or<bool>("small", {{"remove", false}, {"merge", true}}, false);
    request.most = patterns::max_blocks;
    finish_pattern(
        entry, map, faults_before, {"rock"}, [&] { return rock_of(request, name, map); }, reading);
}

}  // namespace voussoir::app::reader
