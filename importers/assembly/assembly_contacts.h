// Which stones touch, and which only nearly.
#pragma once

#include <vector>

#include "importers/assembly/assembly.h"

namespace voussoir::importers::assembly
{

/// Fills contacts and gaps of an assembly whose stones are there.
void find_contacts_and_gaps(Assembly& assembly);

}  // namespace voussoir::importers::assembly
