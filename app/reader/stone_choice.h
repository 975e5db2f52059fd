// Which stones of a mesh file are taken, and how: keys of a mesh entry.
#pragma once

#include <string>
#include <vector>

#include "app/reader/yaml_cursor.h"
#include "importers/helper/geometry.h"

namespace voussoir::app::reader
{

/// A pattern of stones where it is written.
struct ChosenPattern {
    std::string key, pattern;  // "skip", "keystone*"
    YamlCursor written;
};

/// `skip`, `only`, `hull`, `skip_types`, `repair` and `simplify` of an entry, into the request.
/// @returns the patterns, for a fault of those that match nothing
std::vector<ChosenPattern> read_stone_choice(YamlCursor& entry, importers::helper::MeshRequest& request);

/// A fault for each pattern that no stone has the name of, with the nearest names.
void refuse_unmatched_patterns(const std::vector<ChosenPattern>& patterns,
                               const importers::helper::ImportedMesh& mesh);

/// The names of all stones of a file, those that were left out too.
std::vector<std::string> names_of_stones(const importers::helper::ImportedMesh& mesh);

/// What would help a refused stone, for the sentence of its refusal: `give hull: "keystone", or skip: "keystone"`.
std::string cure_of(const importers::helper::Stone& stone);

/// `hull` or `{parts: 12, volume_error: 2 %, triangles: 3000, stones: "boulder*"}` from a command line.
/// @param option for messages @throws InputError with every fault
importers::helper::StoneSimplification parse_simplification(const std::string& text, const std::string& option);

}  // namespace voussoir::app::reader
