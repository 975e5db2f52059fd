// What assimp does not tell of a file, or gets wrong, read from the file's own text: units, names, turned
// instances.
#pragma once

#include "importers/mesh/formats.h"

namespace voussoir::importers::mesh
{

/// What an AMF file says beside its triangles.
struct AmfFacts {
    double metres_per_unit = 1e-3;             // a millimetre unless it says otherwise: the standard
    std::map<std::string, std::string> names;  // of objects, by id: assimp tells the id only
};

/// @throws InputError with the line when the text is not XML, the unit is unknown, an instance is turned (assimp
/// moves it instead), a mesh has several volumes (assimp keeps the first), or the constellations form no tree of a
/// reasonable size (assimp copies all of it)
AmfFacts amf_facts(const MeshSource& source);

/// The objects of a 3DS file that have meshes, in their order: assimp numbers them when the file has no key
/// frames.
std::vector<std::string> names_in_3ds(const MeshSource& source);

/// A 3DS file without its key frames: by them assimp would turn the objects away from where their coordinates are.
MeshSource without_key_frames(const MeshSource& source);

/// What the `Metric` statements of an OpenGEX file say, or its defaults.
struct OgexFacts {
    double metres_per_unit = 1;
    char up = 'z';
};
OgexFacts ogex_facts(const MeshSource& source);

}  // namespace voussoir::importers::mesh
