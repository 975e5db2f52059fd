// Mesh files in.
#pragma once

#include <filesystem>

#include "importers/mesh/polygon_surface.h"

namespace voussoir
{

/// Reads OBJ, STL, PLY or OFF. One surface per object (`o`) of an OBJ file, or per group (`g`) when it has fewer
/// than two objects; one per node in the other formats. Polygons stay polygons.
///
/// assimp holds coordinates as 32-bit numbers. OBJ coordinates are therefore re-read here and keep every digit;
/// for the other formats `rounding` states the largest possible loss (zero is not claimed even where the file
/// itself holds 32-bit numbers).
/// @throws InputError (place: the file, for OBJ with lines) when the file is missing, empty, of another format,
/// not readable, holds no faces, coordinates that are not finite, or indices out of range
MeshFile read_mesh(const std::filesystem::path& file);

}  // namespace voussoir
