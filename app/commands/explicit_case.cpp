#include "app/commands/explicit_case.h"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "app/words/lines.h"
#include "importers/patterns/pattern.h"
#include "libdda/errors.h"
#include "libdda/geometry/plane.h"

namespace voussoir::app::commands
{
namespace
{

using Eigen::Vector3d;

/// The shortest decimals that read back to the same bits.
std::string spelled(double number)
{
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number + 0.0).ptr};
}

std::string spelled(const Vector3d& x)
{
    return "[" + spelled(x.x()) + ", " + spelled(x.y()) + ", " + spelled(x.z()) + "]";
}

std::string quoted(const std::string& text)
{
    return nlohmann::json(text).dump();
}

template <class Item, class Spell>
std::string listed(const std::vector<Item>& items, const Spell& spell)
{
    std::string text = "[";
    for (std::size_t i = 0; i < items.size(); ++i) text += (i > 0 ? ", " : "") + spell(items[i]);
    return text + "]";
}

std::string part_text(const ConvexPolyhedron& part, const Vector3d& place)
{
    std::vector<int> glued;
    for (std::size_t f = 0; f < part.faces.size(); ++f)
        if (part.is_glued(static_cast<int>(f))) glued.push_back(static_cast<int>(f));
    const auto number = [](int i) { return std::to_string(i); };
    return "{vertices: " + listed(part.vertices, [&](const Vector3d& x) { return spelled(Vector3d(x + place)); }) +
           ", faces: " + listed(part.faces, [&](const std::vector<int>& face) { return listed(face, number); }) +
           (glued.empty() ? "" : ", glued: " + listed(glued, number)) + "}";
}

/// The one point at which a mass makes the block what it is.
Vector3d place_of_mass(const Model& model, const Block& block)
{
    const Vector3d own = make_block(block.name, 0, 0, block.parts).moments.centroid;  // from the common centre
    const double stone = model.materials[block.material].density * block.moments.volume;
    return block.moments.centroid + model.origin - own * (stone / block.attached_mass);
}

std::string shape_text(const Model& model, const Block& block)
{
    const Vector3d place = block.moments.centroid + model.origin;
    if (!is_planar(model.kinematics)) {
        std::string text = "{polyhedron: {name: " + quoted(block.name) + ", parts: " +
                           listed(block.parts, [&](const auto& part) { return part_text(part, place); });
        if (block.friction_factor != 1) text += ", friction_factor: " + spelled(block.friction_factor);
        if (block.attached_mass > 0)
            text += ", mass: {mass: " + spelled(block.attached_mass) +
                    ", at: " + spelled(place_of_mass(model, block)) + "}";
        return text + "}";
    }
    if (block.outlines.size() != 1 || block.attached_mass > 0 || block.friction_factor != 1)
        throw InputError(block.name, "a planar block of several outlines, with a mass or a friction factor",
                         "write OBJ, or set kinematics to a spatial one");
    return "{polygon: {name: " + quoted(block.name) + ", corners: " +
           listed(block.outlines[0].vertices,
                  [&](const Eigen::Vector2d& x) {
                      return "[" + spelled(x.x() + place.x()) + ", " + spelled(x.y() + place.z()) + "]";
                  }) +
           "}";
}

std::string blocks_text(const Model& model)
{
    std::string text = "blocks:\n";
    for (const Block& block : model.blocks)
        text += "  - " + shape_text(model, block) + ", group: " + quoted(model.groups[block.group]) +
                ", material: " + quoted(model.materials[block.material].name) + "}\n";
    return text;
}

/// The key that a line begins at the top of a case; empty if it begins none.
std::string top_key(const std::string& line)
{
    if (line.empty() || line[0] == ' ' || line[0] == '#' || line[0] == '-') return "";
    const std::size_t colon = line.find(':');
    return colon == std::string::npos ? "" : line.substr(0, colon);
}

}  // namespace

std::string explicit_case(const Case& the_case)
{
    std::string text;
    bool is_left_out = false, has_blocks = false;
    for (const std::string& line : words::lines_of(the_case.text)) {
        const std::string key = top_key(line);
        if (key == "initial_state")
            throw InputError(the_case.file.string(), "initial_state",
                             "remove it first: blocks that begin turned would be turned twice");
        if (!key.empty()) is_left_out = key == "blocks" || key == "attached_masses";
        if (key == "blocks") text += blocks_text(the_case.model);
        has_blocks = has_blocks || key == "blocks";
        if (!is_left_out) text += line + "\n";
    }
    if (!has_blocks)
        throw InputError(the_case.file.string(),
                         "no line begins with blocks:", "write the case with its keys at the beginning of lines");
    return text;
}

std::vector<importers::mesh::PolygonSurface> surfaces_of(const Model& model)
{
    std::vector<importers::mesh::PolygonSurface> surfaces;
    for (const Block& block : model.blocks) {
        const Vector3d place = block.moments.centroid + model.origin;
        std::vector<ConvexPolyhedron> parts;
        for (const ConvexPolyhedron& part : block.parts) parts.push_back(translated(part, place));
        for (const ConvexPolygon& outline : block.outlines) {
            std::vector<Eigen::Vector2d> corners;
            for (const Eigen::Vector2d& x : outline.vertices) corners.push_back(x + from_space<2>(place));
            parts.push_back(importers::patterns::prism_along_y(corners, -model.thickness / 2, model.thickness / 2,
                                                               block.name));
        }
        surfaces.push_back(importers::patterns::surface_of(block.name, parts));
    }
    return surfaces;
}

}  // namespace voussoir::app::commands
