// Stones given by their corners and faces, as `voussoir generate` writes them.
#include "app/reader/polyhedra.h"

#include <cmath>
#include <limits>

#include "app/reader/block_reading.h"

namespace voussoir::app::reader
{
namespace
{

constexpr double planarity = 1e-5;  // share of a part's diagonal by which its corners may leave a face

/// A list of numbers from 0, each below `limit`.
std::vector<int> read_numbers(const YamlCursor& list, std::string_view what, int limit)
{
    std::vector<int> numbers;
    for (const YamlCursor& item : list.items(what)) {
        const double number = item.as_quantity(words::dimension::number, words::Range::non_negative());
        if (!(number >= 0 && number < limit && number == std::floor(number)))
            item.fault(item.found(), "must be a whole number from 0 to " + std::to_string(limit - 1));
        else
            numbers.push_back(static_cast<int>(number));
    }
    return numbers;
}

/// `{vertices: [[x, y, z], ...], faces: [[0, 1, 2], ...], glued: [0]}`.
std::optional<ConvexPolyhedron> read_part(YamlCursor& map, const std::string& name)
{
    const std::size_t faults_before = map.fault_count();
    if (!map.expect_map("a convex part {vertices: [[x, y, z], ...], faces: [[0, 1, 2], ...]}")) return {};
    const auto vertices = map.require("vertices", "corners [[x, y, z], ...]");
    const auto faces = map.require("faces", "loops of corners, counted from 0, counter-clockwise from outside");
    const auto glued = map.find("glued");
    map.reject_unknown_keys();
    if (!vertices || !faces) return {};
    std::vector<Eigen::Vector3d> points;
    for (const YamlCursor& item : vertices->items("corners [[x, y, z], ...]"))
        points.push_back(item.as_vector(words::dimension::length));
    std::vector<std::vector<int>> loops;
    for (const YamlCursor& item : faces->items("loops of corners"))
        loops.push_back(read_numbers(item, "corners of a face", static_cast<int>(points.size())));
    std::vector<bool> marks;
    if (glued) {
        marks.assign(loops.size(), false);
        for (const int face : read_numbers(*glued, "numbers of faces", static_cast<int>(loops.size())))
            marks[static_cast<std::size_t>(face)] = true;
    }
    if (map.fault_count() > faults_before) return {};
    try {
        ConvexPolyhedron part = make_convex_polyhedron(std::move(points), std::move(loops), name, planarity);
        part.glued = std::move(marks);
        return part;
    } catch (const InputError& error) {
        for (const Fault& fault : error.faults) map.fault(fault.found, fault.expected);
        return {};
    }
}

}  // namespace

std::vector<ConvexPolyhedron> read_convex_parts(const YamlCursor& list, const std::string& name)
{
    std::vector<ConvexPolyhedron> parts;
    const std::vector<YamlCursor> items = list.items("a list of convex parts {vertices, faces}");
    if (items.empty() && list.is_list()) list.fault("no part", "give at least one");
    for (YamlCursor item : items)
        if (std::optional<ConvexPolyhedron> part = read_part(item, name)) parts.push_back(std::move(*part));
    return parts;
}

void read_polyhedron(YamlCursor& entry, YamlCursor& map, BlockReading& reading)
{
    if (!map.expect_map("a polyhedron {name, parts: [{vertices, faces}]}")) return;
    const std::size_t faults_before = reading.findings.faults.size();
    DrawnStone stone;
    stone.name = map.text("name", "the block's name");
    if (const auto parts =
            map.require("parts", "convex parts, [{vertices: [[x, y, z], ...], faces: [[0, 1, 2], ...]}]"))
        stone.parts = read_convex_parts(*parts, stone.name);
    stone.friction_factor =
        map.quantity_or("friction_factor", words::dimension::number, words::Range::positive(), 1);
    if (auto mass = map.find("mass"); mass && mass->expect_map("a mass {mass, at: [x, y, z]}")) {
        DrawnMass own;
        own.mass = mass->quantity("mass", words::dimension::mass, words::Range::positive());
        const auto at = mass->require("at", "where it rests, [x, y, z]");
        own.at = at ? at->as_vector(words::dimension::length) : Eigen::Vector3d::Zero();
        mass->reject_unknown_keys();
        stone.masses.push_back(own);
    }
    map.reject_unknown_keys();
    Belonging belonging = read_belonging(entry, reading.model, true);
    entry.reject_unknown_keys();
    if (reading.findings.faults.size() > faults_before) return;
    const std::string naming = "the block is named " + stone.name;
    add_stones({std::move(stone)}, map, std::move(belonging), naming, reading);
}

}  // namespace voussoir::app::reader
