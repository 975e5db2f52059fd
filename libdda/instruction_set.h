// For which machines the engine was compiled.
#pragma once

#include <string_view>

namespace voussoir
{

/// The instruction set the engine was compiled for: "x86-64" or, with AVX2 and FMA, "x86-64-v3"; "native" on other
/// processors. An installed engine is there for both, and the loader takes the best one that the machine can run.
/// Runs of the same instruction set have the same bits; those of two agree up to rounding.
std::string_view instruction_set();

}  // namespace voussoir
