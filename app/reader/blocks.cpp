#include "app/reader/blocks.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/reader/block_reading.h"
#include "app/reader/local_origin.h"
#include "app/reader/overlaps.h"
#include "app/words/nearest_word.h"
#include "importers/patterns/max_blocks.h"

namespace voussoir::app::reader
{
namespace
{

/// @param without_mesh number of blocks, the first ones, that came from no mesh
void refuse_overlaps(BlockReading& reading, std::size_t without_mesh)
{
    std::vector<Block>& blocks = reading.model.blocks;
    const std::vector<BlockOverlap> overlaps = find_overlaps(blocks, without_mesh);
    for (const BlockOverlap& overlap : overlaps) {
        if (overlap.depth <= reading.model.fit_tolerance) continue;
        const std::string& name_b = blocks[overlap.block_b].name;
        reading.findings.faults.push_back(
            {reading.places.at(name_b) + ": " + blocks[overlap.block_a].name + " and " + name_b,
             fmt::format("overlap by {:.3g} m", overlap.depth),
             reading.model.fit_tolerance > 0
                 ? fmt::format("stones may overlap by the fit_tolerance of {:.3g} m", reading.model.fit_tolerance)
                 : "stones may touch but not overlap"});
    }
    if (overlaps.size() < max_overlaps) return;
    reading.findings.faults.push_back({reading.findings.file, "more than 1000 pairs of stones overlap",
                                       "the stones appear to lie at the same position"});
    blocks.clear();  // a certificate of them would have a contact for every pair
}

/// Groups are those of the stones as drawn, overlaps those of the stones as the run begins with them.
void settle_groups_and_places(const std::vector<InitialEntry>& initial_state, BlockReading& reading,
                              std::size_t without_mesh)
{
    const bool turns = std::any_of(initial_state.begin(), initial_state.end(),
                                   [](const InitialEntry& entry) { return entry.turn.has_value(); });
    // Rules by touch look at the stones as drawn, but not at a heap of them at one position.
    if (!turns || find_overlaps(reading.model.blocks, without_mesh).size() == max_overlaps)
        refuse_overlaps(reading, without_mesh);
    settle_groups(reading);
    turn_blocks(initial_state, reading.model);
    if (turns && reading.findings.faults.empty()) refuse_overlaps(reading, without_mesh);
}

/// Sizes and densities that are numbers can still have a mass that is none.
void refuse_infinite_masses(BlockReading& reading)
{
    if (!reading.findings.faults.empty()) return;  // a missing density would be found again in every block
    const Model& model = reading.model;
    for (std::size_t b = 0; b < model.blocks.size(); ++b) {
        const Block& block = model.blocks[b];
        const double mass = model.mass(static_cast<int>(b)), volume = block.moments.volume;
        const bool is_number = mass > 0 && volume > 0 && std::isfinite(mass) && std::isfinite(volume) &&
                               block.moments.centroid.allFinite() &&
                               model.mass_second(static_cast<int>(b)).allFinite();
        if (is_number) continue;
        reading.findings.faults.push_back({reading.places.at(block.name) + ": " + block.name,
                                           fmt::format("a volume of {:g} m3 and a mass of {:g} kg", volume, mass),
                                           "check its size, position and density"});
        return;
    }
}

/// A fault, and false, if the name is taken.
bool take_name(const std::string& name, const std::string& place, BlockReading& reading)
{
    const auto [known, is_new] = reading.places.emplace(name, place);
    if (!is_new)
        reading.findings.faults.push_back(
            {place, "a second block named " + name, "the first one is at " + known->second});
    return is_new;
}

/// What a block can be given as, and who reads it.
struct ShapeReader {
    const char* key;
    void (*read)(YamlCursor& entry, YamlCursor& shape, BlockReading& reading);
};
constexpr std::array<ShapeReader, 22> shape_readers = {{
    {"mesh", [](YamlCursor& entry, YamlCursor& file, BlockReading& to) { read_mesh(entry, file, to); }},
    {"box", read_box},
    {"polygon", read_polygon},
    {"wall", read_wall},
    {"house", read_house},
    {"arch", read_arch},
    {"bridge", read_bridge},
    {"tower", read_tower},
    {"column", read_column},
    {"temple_front", read_temple_front},
    {"dome", read_dome},
    {"barrel_vault", read_barrel_vault},
    {"cross_vault", read_cross_vault},
    {"gate", read_gate},
    {"buttress", read_buttress},
    {"flying_buttress", read_flying_buttress},
    {"steps", read_steps},
    {"obelisk", read_obelisk},
    {"pinnacle", read_pinnacle},
    {"rock", read_rock},
    {"polyhedron", read_polyhedron},
    {"soil", read_soil},
}};

/// "mesh, box, ... and house".
std::string shape_names(const char* last)
{
    std::string names;
    for (std::size_t i = 0; i < shape_readers.size(); ++i) {
        if (i > 0) names += i + 1 < shape_readers.size() ? ", " : std::string(" ") + last + " ";
        names += shape_readers[i].key;
    }
    return names;
}

void read_entry(YamlCursor& entry, BlockReading& reading)
{
    if (!entry.expect_map("a block {mesh: file}, {box: {...}} or {PATTERN: {...}}: " + shape_names("or"))) return;
    const ShapeReader* chosen = nullptr;
    std::optional<YamlCursor> shape;
    int shapes = 0;
    for (const ShapeReader& reader : shape_readers) {
        std::optional<YamlCursor> found = entry.find(reader.key);
        if (!found) continue;
        ++shapes;
        chosen = &reader;
        shape = std::move(found);
    }
    if (shapes == 1) {
        try {
            return chosen->read(entry, *shape, reading);
        } catch (const InputError& error) {  // of a shape that knows nothing of the file it is written in
            for (const Fault& fault : error.faults) entry.fault(fault.place + ": " + fault.found, fault.expected);
            return;
        }
    }
    entry.fault(shapes == 0 ? "no " + shape_names("or") : "more than one of " + shape_names("and"),
                "give one of them");
}

}  // namespace

void add_block(const std::string& name, const std::string& place, std::vector<ConvexPolyhedron> parts,
               BlockReading& reading, const Moments* moments)
{
    Model& model = reading.model;
    if (is_planar(model.kinematics)) {
        std::vector<ConvexPolygon> outlines = outlines_of(name, place, parts, reading);
        if (!outlines.empty()) add_planar_block(name, place, std::move(outlines), reading);
    } else if (take_name(name, place, reading)) {
        const Moments own = moments != nullptr ? *moments : moments_of(parts);
        model.blocks.push_back(make_block(name, 0, 0, std::move(parts), own));
    }
}

void add_planar_block(const std::string& name, const std::string& place, std::vector<ConvexPolygon> outlines,
                      BlockReading& reading)
{
    Model& model = reading.model;
    if (take_name(name, place, reading))
        model.blocks.push_back(make_planar_block(name, 0, 0, std::move(outlines), model.thickness));
}

std::vector<std::string> read_blocks(YamlCursor& top, const std::filesystem::path& folder,
                                     const std::vector<InitialEntry>& initial_state, Model& model,
                                     Findings& findings)
{
    const std::optional<double> thickness = read_thickness(top, model.kinematics);
    std::optional<YamlCursor> section = top.require("blocks", "the stones, [{mesh: stones.obj}]");
    if (!section) return {};
    BlockReading reading{folder, model, findings, {}, {}, Eigen::Vector3d::Zero(), {}, {}};
    std::vector<YamlCursor> entries = section->items("a list of meshes, boxes, polygons and patterns");
    if (entries.empty() && section->is_list())
        section->fault("no block", "give at least one mesh, box, polygon or pattern");
    const auto are_too_many = [&](YamlCursor& where) {
        if (model.blocks.size() <= importers::patterns::max_blocks && !reading.is_full) return false;
        if (!reading.is_full)
            where.fault(fmt::format("more than {} blocks", importers::patterns::max_blocks),
                        "give larger blocks or fewer walls");
        model.blocks.clear();  // they have no groups yet, and nobody is to look at them
        return true;
    };
    for (YamlCursor& entry : entries) {
        read_entry(entry, reading);
        if (are_too_many(entry)) return {};
    }
    const std::size_t without_mesh = model.blocks.size();
    import_meshes(reading);
    if (are_too_many(*section)) return {};
    settle_origin(reading);
    settle_thickness(top, thickness, reading);
    settle_groups_and_places(initial_state, reading, without_mesh);
    refuse_infinite_masses(reading);
    std::vector<std::string> files;
    for (const MeshEntry& mesh : reading.meshes) files.push_back(mesh.name);
    return files;
}

}  // namespace voussoir::app::reader
