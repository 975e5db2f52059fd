// How this library was compiled.
#pragma once

#include <string>
#include <string_view>

namespace voussoir
{

/// What the last bits of an answer depend on beside the sources: the same input gives the same bits only where all
/// of this is the same.
struct Compilation {
    std::string_view instruction_set;  // "x86-64", "x86-64-v3", ...
    std::string compiler;              // "g++ 12.2.0"
    std::string eigen;                 // "3.4.0"
};

Compilation compilation();

}  // namespace voussoir
