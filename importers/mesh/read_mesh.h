// Mesh files in.
#pragma once

#include <filesystem>

#include "importers/mesh/polygon_surface.h"

namespace voussoir
{

/// What becomes one stone. A level that a format does not have is the nearest that it has.
enum class StonesBy {
    detect,  // objects, or groups where there are fewer than two objects
    file,    // everything together
    object,  // OBJ `o`, STL `solid`, 3MF and AMF objects as often as they are placed, COMPAS blocks, DXF entities
    group,   // OBJ `g`, DXF layers
    node     // glTF, COLLADA, IFC: nodes with meshes
};

struct ReadOptions {
    StonesBy stones = StonesBy::detect;  // what becomes one stone
};

/// Reads OBJ, STL, PLY, OFF, glTF and GLB, COLLADA, 3MF, AMF, 3DS, DXF, COMPAS JSON and IFC; what a file is is
/// judged by its content, not by its name. Polygons stay polygons. Coordinates are in the file's own unit and
/// axes and keep every bit that the file holds; only IFC goes through a reader of 32-bit numbers, whose `rounding`
/// is stated. Instances of one mesh are stones of their own; where a node mirrors its mesh the faces are turned,
/// so that outside stays outside.
/// @throws InputError (place: the file, for text formats with the line) when the file is missing, empty, of
/// another format, cut off, without faces, or with coordinates that are not finite or indices out of range
MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options = {});

}  // namespace voussoir
