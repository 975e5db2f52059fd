// Which format a file has: by its content where that tells, else by its name.
#pragma once

#include <string>

#include "importers/mesh/formats.h"

namespace voussoir::importers::mesh
{

enum class Kind { unknown, obj, stl, ply, off, gltf, compas, collada, archive, dxf, ifc, assimp };

struct FileKind {
    Kind kind = Kind::unknown;
    std::string extension;  // of the format, as assimp knows it; empty for what it does not read
    friend bool operator==(const FileKind&, const FileKind&) = default;
};

FileKind kind_by_content(std::string_view bytes);
FileKind kind_by_name(const std::filesystem::path& path);

/// Refuses what cannot be read but is met often, by how it begins. @throws InputError
void refuse_known_strangers(const MeshSource& source);

}  // namespace voussoir::importers::mesh
