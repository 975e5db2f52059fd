// How a glTF file is packed.
#pragma once

#include <string>

#include "importers/mesh/formats.h"

namespace voussoir::importers::mesh
{

struct GltfContainer {
    std::string json;
    std::string binary;  // the binary chunk of a GLB file, the first buffer
};

/// The chunks of a GLB file, or the text of a glTF file. @throws InputError when the file is cut off
GltfContainer open_gltf(const MeshSource& source);

/// What a buffer's address names: data written out in base 64, or a file beside the glTF file or below it.
/// @throws InputError when it is neither
std::string content_of_uri(const std::string& uri, const MeshSource& source);

}  // namespace voussoir::importers::mesh
