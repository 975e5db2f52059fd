// The findings about an assembly in words, with what to do about each.
#pragma once

#include "importers/assembly/assembly.h"

namespace voussoir::importers::assembly
{

/// Findings, the grave ones first; none when the assembly is sound.
std::vector<AssemblyFinding> findings_in_words(const Assembly& assembly, const AssemblyOrigin& origin);

/// The joint gap to close that is certain to close gaps up to `widest` [m]: the next larger length of two digits.
double closing_width(double widest);

}  // namespace voussoir::importers::assembly
