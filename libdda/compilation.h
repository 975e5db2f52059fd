// How this library was compiled.
#pragma once

#include <string>

namespace voussoir
{

/// What the last bits of an answer depend on beside the sources: the same input gives the same bits only where all
/// of this is the same.
struct Compilation {
    std::string instruction_set;  // see instruction_set()
    std::string compiler;         // "g++ 12.2.0"
    std::string eigen;            // "3.4.0"
    bool operator==(const Compilation&) const = default;
};

Compilation compilation();

}  // namespace voussoir
