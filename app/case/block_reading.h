// What the readers of meshes and boxes share while `blocks` is read.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/case/yaml_cursor.h"
#include "app/geometry/geometry.h"
#include "libdda/model/model.h"

namespace voussoir
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
    MeshRequest request;
    int material = 0;
    std::vector<GroupPattern> patterns;
};

struct BlockReading {
    const std::filesystem::path& folder;  // of the case file
    Model& model;
    Findings& findings;
    std::vector<MeshEntry> meshes;              // imported after the last entry: boxes come first in the model
    std::map<std::string, std::string> places;  // of each block name
};

/// Adds a block; a fault instead if its name is taken. Parts are in model coordinates.
void add_block(const std::string& name, const std::string& place, const std::string& group, int material,
               std::vector<ConvexPolyhedron> parts, BlockReading& reading);

/// Index of `material: name`; the only material if none is named.
int read_material_name(YamlCursor& entry, const std::vector<BlockMaterial>& materials);

/// `{box: {name, lower, upper}}`: adds the block.
void read_box(YamlCursor& entry, YamlCursor& box, BlockReading& reading);

/// `{mesh: file}`: adds to reading.meshes.
void read_mesh(YamlCursor& entry, const YamlCursor& file, BlockReading& reading);

/// Imports all meshes at once and adds their stones; does nothing if there is none.
void import_meshes(BlockReading& reading);

}  // namespace voussoir
