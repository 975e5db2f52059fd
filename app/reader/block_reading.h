// What the readers of meshes, boxes and patterns share while `blocks` is read.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/reader/placing.h"
#include "app/reader/stone_choice.h"
#include "app/reader/yaml_cursor.h"
#include "importers/helper/geometry.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

constexpr const char* default_group = "masonry";

/// `groups: {foundation: "abutment_*"}` or `{foundation: {lowest: 5 %}}`: one rule.
struct GroupRule {
    enum class By { name, lowest, highest, inside, touching };
    std::string group;
    YamlCursor written;
    std::string text;  // a pattern of names; of `touching` the other group
    By by = By::name;
    double reach = 0;       // of `lowest` and `highest`: m, or share of the height of the entry's stones
    bool is_share = false;  // the latter
    Eigen::Vector3d lower = Eigen::Vector3d::Zero(), upper = lower;  // m, of `inside`, user's coordinates
    bool used = false;                                               // some stone is in the group for it
};

/// `material`: one for all stones of an entry, or one for each of its groups.
struct MaterialChoice {
    std::optional<int> common;            // absent: every stone must be in a group that is named
    std::map<std::string, int> of_group;  // index into the materials
};

/// What an entry of `blocks` says beside its shape.
struct Belonging {
    YamlCursor entry;
    MaterialChoice material;
    std::string group;  // of stones that no rule fits
    std::vector<GroupRule> rules;
    std::vector<PlacedCopy> copies;  // at least one
    bool keeps_own_groups = false;   // stones that no rule fits stay in the groups of their pattern
};

/// The stones that an entry gave. Groups and materials are settled when the stones of all entries are known.
struct EntryStones {
    Belonging belonging;
    std::size_t first = 0, end = 0;  // in Model::blocks
    std::string naming;              // "blocks are named wall_base, ...": for whoever looks for their names
    std::vector<std::string> own_groups = {};  // of each stone, by its pattern; empty: it names none
};

/// A mass that a pattern rests on a stone.
struct DrawnMass {
    double mass = 0;     // kg
    Eigen::Vector3d at;  // m, model coordinates
};

/// A stone as an entry draws it, before it is placed: its parts, or outlines of a planar scene. Model coordinates,
/// m.
struct DrawnStone {
    std::string name;
    std::vector<ConvexPolyhedron> parts;
    std::vector<ConvexPolygon> outlines;
    double friction_factor = 1;  // of the block
    std::string group = {};      // by its pattern; empty: it names none
    std::vector<DrawnMass> masses = {};
};

/// An entry of `blocks` that names a mesh file.
struct MeshEntry {
    YamlCursor file;   // where it is written
    std::string name;  // as it is written
    importers::helper::MeshRequest request;
    Belonging belonging;
    std::vector<ChosenPattern> chosen;  // of skip, only, hull, ...
};

/// The extent along y of a planar scene's stones that are drawn in space, and the stone that set it.
struct DrawnDepth {
    double low = 0, high = 0;  // m, user's coordinates
    std::string stone;
};

struct BlockReading {
    const std::filesystem::path& folder;  // of the case file
    Model& model;
    Findings& findings;
    std::vector<MeshEntry> meshes;              // imported after the last entry: boxes come first in the model
    std::map<std::string, std::string> places;  // of each block name
    Eigen::Vector3d mesh_origin = Eigen::Vector3d::Zero();  // m, subtracted from what meshes gave
    std::optional<DrawnDepth> depth;                        // absent in spatial scenes
    std::vector<EntryStones> entries;
    bool is_full = false;  // an entry would have passed the bound on blocks, and a fault says so
};

/// Adds a block, still without group and material; a fault instead if its name is taken. Parts are in model
/// coordinates. A planar scene takes their outlines; stones that are no prisms along y, or of another extent along
/// y than those before them, are faults.
/// @param moments of the stone, where its parts only approximate it
void add_block(const std::string& name, const std::string& place, std::vector<ConvexPolyhedron> parts,
               BlockReading& reading, const Moments* moments = nullptr);

/// The same from outlines, for planar scenes. @param outlines (x, z) in model coordinates [m]
void add_planar_block(const std::string& name, const std::string& place, std::vector<ConvexPolygon> outlines,
                      BlockReading& reading);

/// Adds the stones of an entry in all their places. What is wrong with them becomes faults at the place of the
/// shape.
void add_stones(std::vector<DrawnStone> drawn, const YamlCursor& shape, Belonging belonging, std::string naming,
                BlockReading& reading);

/// Outlines of a stone of a planar scene that is drawn in space; empty, with a fault, when it has none.
std::vector<ConvexPolygon> outlines_of(const std::string& name, const std::string& place,
                                       const std::vector<ConvexPolyhedron>& parts, BlockReading& reading);

/// `material`, `group`, `groups` and the keys of placing. @param has_name the shape is one stone with a name of
/// its own: its group is worth a default
/// @param own_groups that its pattern puts stones into
Belonging read_belonging(YamlCursor& entry, const Model& model, bool has_name,
                         const std::vector<std::string>& own_groups = {});

/// `groups` of an entry.
std::vector<GroupRule> read_group_rules(YamlCursor& entry, Kinematics kinematics);

/// Puts every block into the group of the first rule of its entry that fits it, and gives it its material. A rule
/// that fits no stone is a fault. Rules by touch come last: they take what the others left.
void settle_groups(BlockReading& reading);

/// The blocks that touch each block with a part of a face, as the engine's contact search sees the stones at rest.
std::vector<std::vector<int>> neighbours_of(const Model& model);

/// `{box: {name, lower, upper}}`: adds the block. Corners [x, y, z]; in planar scenes [x, z] will do.
void read_box(YamlCursor& entry, YamlCursor& box, BlockReading& reading);

/// A box of a planar scene with corners [x, z].
void read_flat_box(YamlCursor& entry, YamlCursor& box, BlockReading& reading);

/// `{polygon: {name, corners: [[x, z], ...]}}`: adds the block, in planar scenes.
void read_polygon(YamlCursor& entry, YamlCursor& polygon, BlockReading& reading);

/// `{wall: {length, height, thickness, block, ...}}`: adds its blocks; in planar scenes one that runs along x.
void read_wall(YamlCursor& entry, YamlCursor& wall, BlockReading& reading);

/// `{house: {length, width, height, wall_thickness, block, ...}}`: adds its blocks.
void read_house(YamlCursor& entry, YamlCursor& house, BlockReading& reading);

/// `{arch: {span, rise, thickness, voussoirs, ...}}`: adds its stones, in planar scenes too.
void read_arch(YamlCursor& entry, YamlCursor& arch, BlockReading& reading);

/// `{bridge: {spans, span, thickness, voussoirs, width, block, ...}}`: adds its stones.
void read_bridge(YamlCursor& entry, YamlCursor& bridge, BlockReading& reading);

/// `{tower: {plan, width, block, storeys: [...]}}`: adds its stones.
void read_tower(YamlCursor& entry, YamlCursor& tower, BlockReading& reading);

/// `{polyhedron: {name, parts: [{vertices, faces, glued}], friction_factor, mass}}`: adds the block.
void read_polyhedron(YamlCursor& entry, YamlCursor& polyhedron, BlockReading& reading);

/// `{rock: {outline, width, sets: [{dip, dip_direction, spacing, ...}]}}`: adds its blocks.
void read_rock(YamlCursor& entry, YamlCursor& rock, BlockReading& reading);

/// `{column: {height, diameter, drums, ...}}`, `{temple_front: {columns, spacing, ...}}`.
void read_column(YamlCursor& entry, YamlCursor& column, BlockReading& reading);
void read_temple_front(YamlCursor& entry, YamlCursor& front, BlockReading& reading);

/// `{dome: {...}}`, `{barrel_vault: {...}}`, `{cross_vault: {...}}`: stones that share their joints.
void read_dome(YamlCursor& entry, YamlCursor& dome, BlockReading& reading);
void read_barrel_vault(YamlCursor& entry, YamlCursor& vault, BlockReading& reading);
void read_cross_vault(YamlCursor& entry, YamlCursor& vault, BlockReading& reading);

/// `{gate: {...}}`, `{buttress: {...}}`, `{flying_buttress: {...}}`, `{steps: {...}}`, `{obelisk: {...}}`,
/// `{pinnacle: {...}}`.
void read_gate(YamlCursor& entry, YamlCursor& gate, BlockReading& reading);
void read_buttress(YamlCursor& entry, YamlCursor& buttress, BlockReading& reading);
void read_flying_buttress(YamlCursor& entry, YamlCursor& buttress, BlockReading& reading);
void read_steps(YamlCursor& entry, YamlCursor& steps, BlockReading& reading);
void read_obelisk(YamlCursor& entry, YamlCursor& obelisk, BlockReading& reading);
void read_pinnacle(YamlCursor& entry, YamlCursor& pinnacle, BlockReading& reading);

/// `{soil: {layers: [...], width, highest_frequency, ...}}`: adds layered ground, and the materials of its layers.
void read_soil(YamlCursor& entry, YamlCursor& soil, BlockReading& reading);

/// `{mesh: file}`: adds to reading.meshes.
void read_mesh(YamlCursor& entry, const YamlCursor& file, BlockReading& reading);

/// `thickness` of a planar scene, if the case gives it; a fault in a spatial one.
std::optional<double> read_thickness(YamlCursor& top, Kinematics kinematics);

/// Gives a planar scene, read as a slice of 1 m, its thickness: by default the extent of the drawn stones along y,
/// and 1 m when none is drawn in space.
void settle_thickness(const YamlCursor& top, std::optional<double> thickness, BlockReading& reading);

/// Imports all meshes at once and adds their stones; does nothing if there is none.
void import_meshes(BlockReading& reading);

}  // namespace voussoir::app::reader
