// Rock cut by joint sets as a case file gives it.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>

#include "app/reader/pattern_keys.h"
#include "app/reader/polyhedra.h"
#include "importers/helper/geometry.h"
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

/// Marks the sides that two outlines share: they lie inside the rock.
void glue_common_sides(const std::vector<std::vector<patterns::Point>>& outlines,
                       std::vector<ConvexPolyhedron>& parts)
{
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
}

/// `outline: [[x, z], ...]`, drawn along y about y = 0.
std::vector<ConvexPolyhedron> read_outline(const YamlCursor& outline, double width)
{
    std::vector<patterns::Point> corners;
    const std::size_t before = outline.fault_count();
    for (const YamlCursor& corner : outline.items("corners [[x, z], ...]"))
        corners.push_back(corner.as_plane_vector(dimension::length));
    if (outline.fault_count() > before) return {};
    std::vector<ConvexPolyhedron> parts;
    const std::vector<std::vector<patterns::Point>> outlines = patterns::convex_outlines(corners);
    parts.reserve(outlines.size());
    for (const std::vector<patterns::Point>& part : outlines)
        parts.push_back(patterns::prism_along_y(part, -width / 2, width / 2, "outline"));
    glue_common_sides(outlines, parts);
    return parts;
}

/// `mesh: hill.obj`, a file of one closed surface.
std::vector<ConvexPolyhedron> read_body(const YamlCursor& mesh, const BlockReading& reading)
{
    const std::filesystem::path file = reading.folder / mesh.as_text();
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) {
        mesh.fault("no mesh file " + file.string(), "paths are relative to the case file");
        return {};
    }
    const importers::helper::Geometry geometry = importers::helper::import_geometry({{.file = file}}, {});
    const importers::helper::ImportedMesh& drawn = geometry.meshes.at(0);
    if (drawn.stones.size() > 1) {
        mesh.fault(fmt::format("{} bodies", drawn.stones.size()), "rock is cut from one");
        return {};
    }
    if (!drawn.accepted) {
        mesh.fault(drawn.stones.empty() || drawn.stones[0].reason.empty() ? drawn.reason : drawn.stones[0].reason,
                   "give one closed surface");
        return {};
    }
    if (drawn.stones[0].volume_error > 0)
        mesh.warn(fmt::format("the convex parts of the body exceed its volume by {:.2g} %",
                              100 * drawn.stones[0].volume_error));
    std::vector<ConvexPolyhedron> parts;
    for (const ConvexPolyhedron& part : drawn.stones[0].parts) parts.push_back(translated(part, geometry.origin));
    return parts;
}

/// Whether each glued face of a part is a whole face of another one too.
bool share_whole_faces(const std::vector<ConvexPolyhedron>& parts)
{
    std::map<std::vector<std::array<double, 3>>, int> sides;
    for (const ConvexPolyhedron& part : parts)
        for (std::size_t f = 0; f < part.faces.size(); ++f) {
            if (!part.is_glued(static_cast<int>(f))) continue;
            std::vector<std::array<double, 3>> corners;
            for (const int v : part.faces[f])
                corners.push_back({part.vertices[v].x(), part.vertices[v].y(), part.vertices[v].z()});
            std::sort(corners.begin(), corners.end());
            ++sides[corners];
        }
    return std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 2; });
}

/// The body that is cut: by `outline` and `width`, by its `parts`, or from a `mesh`.
std::vector<ConvexPolyhedron> read_domain(YamlCursor& map, const BlockReading& reading)
{
    const auto outline = map.find("outline"), own = map.find("parts"), mesh = map.find("mesh");
    if (outline.has_value() + own.has_value() + mesh.has_value() != 1) {
        map.fault(outline || own || mesh ? "more than one body" : "no body",
                  "give outline: [[x, z], ...], the corners of its elevation, or parts, or a mesh");
        return {};
    }
    if (outline) return read_outline(*outline, map.quantity_or("width", dimension::length, Range::positive(), 1));
    map.forbid("width", "it belongs to an outline");
    std::vector<ConvexPolyhedron> parts = own ? read_convex_parts(*own, "rock") : read_body(*mesh, reading);
    if (share_whole_faces(parts)) return parts;
    (own ? *own : *mesh)
        .fault("parts that are glued do not share whole faces", "give convex bodies, each in an entry of its own");
    return {};
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
        request.domain = read_domain(map, reading);
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
