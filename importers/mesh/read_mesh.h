// Mesh files in.
#pragma once

#include <filesystem>

#include "importers/mesh/mesh_formats.h"
#include "importers/mesh/polygon_surface.h"

namespace voussoir::importers::mesh
{

/// What becomes one stone. A level that a format does not have is the nearest that it has.
enum class StonesBy {
    detect,  // objects, or groups where there are fewer than two objects
    file,    // everything together
    object,  // OBJ `o`, STL `solid`, 3MF objects as often as they are placed, COMPAS blocks, DXF entities
    group,   // OBJ `g`, DXF layers
    node     // glTF, COLLADA, and all that assimp reads: nodes with meshes
};

/// How a mesh file is read.
struct ReadOptions {
    StonesBy stones = StonesBy::detect;         // what becomes one stone
    MeshReader reader = MeshReader::automatic;  // ours where there is one
};

/// Reads all of mesh_formats(); the format is detected from the content, and from the name only where the content
/// does not tell. Polygons stay polygons. Coordinates are in the file's own unit and axes and keep every bit that
/// the file holds, unless assimp reads it: then they go through 32-bit numbers, whose `rounding` is stated.
/// Instances of one mesh are stones of their own; where a node mirrors its mesh the faces are turned, so that
/// outside stays outside. assimp does not survive every damaged file: what is not trusted is read in the child
/// process of importers/helper.
/// @throws InputError (place: the file, for text formats with the line) when the file is missing, empty, of
/// another format than the reader that is asked for reads, cut off, without faces, or with coordinates that are
/// not finite or indices out of range
MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace voussoir::importers::mesh
