// Which engine made a result: carried by every result, and asked of a run that is to go on.
#pragma once

#include <cstdint>
#include <string>

#include "libdda/compilation.h"

namespace voussoir::app::version
{

/// Whether files under version control differed from the commit when the program was built.
enum class Dirty : std::uint8_t { no, yes, unknown };

/// What this program was built from.
struct EngineVersion {
    std::string version;  // "0.2.0"
    std::string commit;   // twelve hexadecimal digits; empty where it is not known
    Dirty dirty = Dirty::unknown;
    std::string sources;  // checksum, twelve digits, of all sources that decide a number: tells dirty builds apart
    Compilation compilation;
    bool operator==(const EngineVersion&) const = default;
};

/// Of this program. The commit is that of the last build, not of the last configuration: built_from.cpp.in.
EngineVersion engine_version();

/// "0.2.0, commit 8951b6b97059 with changes, sources 0123456789ab, x86-64-v3, g++ 12.2.0, Eigen 3.4.0"
std::string in_words(const EngineVersion& engine);

/// {version, commit, dirty, sources, instruction_set, compiler, eigen} as JSON text; commit and dirty are null
/// where they are not known. @param behaviour of golden::behaviour, added where it is not empty
std::string engine_json(const std::string& behaviour = "");

/// The last lines of a study's page. @param behaviour of golden::behaviour
std::string engine_paragraph(const std::string& behaviour);

}  // namespace voussoir::app::version
