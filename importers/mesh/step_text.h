// The text of a STEP file, of which IFC is one kind.
#pragma once

#include <string_view>

#include "importers/mesh/formats.h"

namespace voussoir::importers::mesh
{

/// Sees that a STEP file is whole: it ends as it must, its statements have the form `#7 = NAME(...);` with
/// balanced parentheses, every `#7` that is named is defined, once, and none is made of itself. The reader that
/// follows does not survive files where this is not so.
/// @throws InputError with the line of the first fault
void check_step_text(const MeshSource& source);

}  // namespace voussoir::importers::mesh
