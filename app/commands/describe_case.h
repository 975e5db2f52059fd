// A case in words: for `run` before it starts and for `check`.
#pragma once

#include "app/case/case.h"

namespace voussoir::app::commands
{

/// What is there, what is left out, defaults that were taken, motions and warnings; to standard output.
void print_case(const Case& the_case);

/// The materials and joint laws.
void print_materials(const Model& model);

}  // namespace voussoir::app::commands
