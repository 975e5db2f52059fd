// What the readers of meshes, boxes and patterns share while `blocks` is read.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/reader/stone_choice.h"
#include "app/reader/yaml_cursor.h"
#include "importers/helper/geometry.h"
#include "libdda/model/model.h"

namespace voussoir::app::reader
{

constexpr const char* default_group = "masonry";

/// `groups: {foundation: "abutment_*"}`: one pattern.
struct GroupPattern {
    std::string group, pattern;
    YamlCursor written;
    bool used = false;
};

/// An entry of `blocks` that names a mesh file.
struct MeshEntry {
    YamlCursor file;   // where it is written
    std::string name;  // as it is written
    importers::helper::MeshRequest request;
    int material = 0;
    std::vector<GroupPattern> patterns;
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
};

/// Adds a block; a fault instead if its name is taken. Parts are in model coordinates. A planar scene takes their
/// outlines; stones that are no prisms along y, or of another extent along y than those before them, are faults.
/// @param moments of the stone, where its parts only approximate it
void add_block(const std::string& name, const std::string& place, const std::string& group, int material,
               std::vector<ConvexPolyhedron> parts, BlockReading& reading, const Moments* moments = nullptr);

/// The same from outlines, for planar scenes. @param outlines (x, z) in model coordinates [m]
void add_planar_block(const std::string& name, const std::string& place, const std::string& group, int material,
                      std::vector<ConvexPolygon> outlines, BlockReading& reading);

/// Outlines of a stone of a planar scene that is drawn in space; empty, with a fault, when it has none.
std::vector<ConvexPolygon> outlines_of(const std::string& name, const std::string& place,
                                       const std::vector<ConvexPolyhedron>& parts, BlockReading& reading);

/// Index of `material: name`; the only material if none is named.
int read_material_name(YamlCursor& entry, const std::vector<BlockMaterial>& materials);

/// `groups` of an entry that gives several stones.
std::vector<GroupPattern> read_group_patterns(YamlCursor& entry);

/// The group of the first pattern that matches a stone's name, and `masonry` if none does.
std::string group_of(const std::string& stone, std::vector<GroupPattern>& patterns);

/// A fault for each pattern that no stone was left for.
void refuse_unused_patterns(const std::vector<GroupPattern>& patterns, const std::string& how_stones_are_named);

/// What an entry of one block says beside its shape: `material` and `group`.
struct Belonging {
    int material = 0;
    std::string group;
};
Belonging read_belonging(YamlCursor& entry, const std::vector<BlockMaterial>& materials);

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
