// A case in words: for `run` before it starts and for `check`.
#pragma once

#include "app/case/case.h"
#include "importers/helper/geometry.h"

namespace voussoir::app::commands
{

/// What is there, what is left out, defaults that were taken, motions and warnings; to standard output.
void print_case(const Case& the_case);

/// Every repair of every stone; the warnings of the case have one line for each kind.
void print_repairs(const importers::helper::Geometry& geometry);

/// The materials and joint laws.
void print_materials(const Model& model);

}  // namespace voussoir::app::commands
