// What the readers of case files ask for, overheard by the test that holds the schema to them.
#pragma once

#include <map>
#include <set>
#include <string>

namespace voussoir::app::reader
{

struct AskedKeys {
    std::map<std::string, std::set<std::string>> keys;   // asked for, by the path of their map: "stages[0]"
    std::map<std::string, std::set<std::string>> words;  // that a value may be, by its path: "stages[0].type"
};

/// Where this thread notes what readers ask; nowhere, unless a test says where.
inline thread_local AskedKeys* asked_keys = nullptr;

}  // namespace voussoir::app::reader
