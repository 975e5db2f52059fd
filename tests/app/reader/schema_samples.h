// The schema of case files, taken apart: the keys and words it knows, and cases that use all of them.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace voussoir::app::reader
{

/// docs/case.schema.json.
nlohmann::json case_schema();

/// Paths are written without numbers and without the names a user chooses: "stages[].collapse", "materials.*".
struct SchemaWords {
    std::map<std::string, std::set<std::string>> keys;  // of the objects at a path, all alternatives together
    std::map<std::string, std::set<std::string>> deprecated;  // keys among them that are old names
    std::map<std::string, std::set<std::string>> words;       // that a value may be, if only words are allowed
};
SchemaWords words_of(const nlohmann::json& schema);

/// Cases that together hold every key and every alternative of the schema. They have the form of cases but make no
/// sense: only a block of the group "everything" and a stage "shaken" are there for others to name. @param
/// with_deprecated also the old names of keys, beside the new ones
std::vector<nlohmann::json> sample_cases(const nlohmann::json& schema, bool with_deprecated);

/// A path of the reader, "stages[3].collapse", as those of SchemaWords are written.
std::string general_path(const std::string& path);

}  // namespace voussoir::app::reader
