// Stones that are awkward by themselves.
#pragma once

#include "importers/assembly/assembly.h"

namespace voussoir::importers::assembly
{

/// Fills slivers, the largest and the smallest stone, the typical size and the extent.
void judge_shapes(Assembly& assembly);

}  // namespace voussoir::importers::assembly
