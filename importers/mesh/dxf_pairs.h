// A DXF file as pairs of a code and a value.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "importers/mesh/formats.h"

namespace voussoir::importers::mesh
{

struct DxfPair {
    int code = 0;
    std::string_view value;
    int line = 0;  // of the value
};

/// A run of pairs: `first` is the one that begins it, `end` the one after the last.
struct DxfRange {
    std::size_t first = 0, end = 0;
};

struct DxfFile {
    std::vector<DxfPair> pairs;
    std::map<std::string, DxfRange> blocks;  // by name; begins at the pair (0, BLOCK)
    DxfRange entities;
    std::optional<double> metres_per_unit;  // $INSUNITS
};

/// A name as DXF writes it: old files have "\U+65E5" for what is not plain.
std::string dxf_name(std::string_view value);

/// @throws InputError with the line where the file stops being pairs, or when it is cut off
DxfFile read_dxf_pairs(const MeshSource& source);

}  // namespace voussoir::importers::mesh
