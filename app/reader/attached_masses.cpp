#include "app/reader/attached_masses.h"

#include <algorithm>

#include "app/reader/blocks.h"
#include "app/reader/plane.h"
#include "app/words/nearest_word.h"

namespace voussoir::app::reader
{
namespace
{

/// Highest point of a block over its reference point, model coordinates.
Eigen::Vector3d top_of(const Block& block)
{
    double height = 0;
    for (const ConvexPolyhedron& part : block.parts)
        for (const Eigen::Vector3d& x : part.vertices) height = std::max(height, x.z());
    for (const ConvexPolygon& outline : block.outlines)
        for (const Eigen::Vector2d& x : outline.vertices) height = std::max(height, x.y());
    return block.moments.centroid + Eigen::Vector3d(0, 0, height);
}

std::vector<int> matching_blocks(YamlCursor& entry, const Model& model)
{
    std::vector<int> blocks;
    const std::optional<YamlCursor> pattern = entry.require("blocks", "names of blocks; * matches any characters");
    if (!pattern) return blocks;
    const std::string wanted = pattern->as_text();
    std::vector<std::string> names;
    for (int i = 0; i < static_cast<int>(model.blocks.size()); ++i) {
        names.push_back(model.blocks[i].name);
        if (matches_pattern(names.back(), wanted)) blocks.push_back(i);
    }
    // Without blocks there are faults already, and this would only be their echo.
    if (blocks.empty() && !names.empty() && !wanted.empty())
        pattern->fault("\"" + wanted + "\" matches no block", words::suggestion(wanted, names));
    return blocks;
}

struct Place {
    bool at_top = false;
    std::optional<Eigen::Vector3d> point;  // model coordinates
};

Place place_of_mass(YamlCursor& entry, const Model& model)
{
    Place place;
    const std::optional<YamlCursor> at = entry.find("at");
    if (at && at->is_list())
        place.point = read_place(*at, model.kinematics) - model.origin;
    else
        place.at_top = entry.choice_or<bool>("at", {{"centroid", false}, {"top", true}}, false);
    return place;
}

void read_entry(YamlCursor& entry, Model& model)
{
    if (!entry.expect_map("an attached mass {blocks, mass, at}")) return;
    const std::vector<int> blocks = matching_blocks(entry, model);
    const std::optional<double> each =
        entry.find_quantity("mass", words::dimension::mass, words::Range::positive());
    const std::optional<double> total =
        entry.find_quantity("total", words::dimension::mass, words::Range::positive());
    const Place place = place_of_mass(entry, model);
    entry.reject_unknown_keys();
    if (each.has_value() == total.has_value())
        return entry.fault(each ? "both mass and total" : "neither mass nor total",
                           "give mass, for each block, or total, divided equally among all");
    if (blocks.empty()) return;
    const double mass = each ? *each : *total / static_cast<double>(blocks.size());
    for (const int block : blocks) {
        const Block& own = model.blocks[block];
        attach_mass(model, block, mass, place.point.value_or(place.at_top ? top_of(own) : own.moments.centroid));
    }
}

}  // namespace

void read_attached_masses(YamlCursor& top, Model& model)
{
    const std::optional<YamlCursor> section = top.find("attached_masses");
    if (!section) return;
    for (YamlCursor& entry : section->items("a list of attached masses")) read_entry(entry, model);
}

}  // namespace voussoir::app::reader
