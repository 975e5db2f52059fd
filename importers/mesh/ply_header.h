// The header of a PLY file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "importers/mesh/formats.h"

namespace voussoir::importers::mesh
{

enum class PlyType { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::none;
    PlyType count = PlyType::none;  // of lists: the type of their length; of numbers: none
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    enum class Format { ascii, little_endian, big_endian } format = Format::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;  // bytes up to the first element
    int lines = 0;         // likewise
};

/// Bytes of a number of this type.
std::size_t size_of(PlyType type);

/// @throws InputError with the line of what is not understood, and when a count is more than the file can hold
PlyHeader read_ply_header(const MeshSource& source);

}  // namespace voussoir::importers::mesh
