// How large a case may be.
#pragma once

#include <cstddef>

// The fuzz targets are built with less: there a block takes fifty times as long.
#ifndef VOUSSOIR_MAX_BLOCKS
#define VOUSSOIR_MAX_BLOCKS 200'000
#endif

namespace voussoir::importers::patterns
{

/// Blocks of a wall, of a house and of all of a case: more are a slip of the pen, and would fill the memory before
/// the run begins.
inline constexpr std::size_t max_blocks = VOUSSOIR_MAX_BLOCKS;

}  // namespace voussoir::importers::patterns
