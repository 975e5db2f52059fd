// What must hold of a restart that was read from a file before a run goes on from it.
#pragma once

#include "app/results/restart_file.h"

namespace voussoir::app::results
{

/// Its state is sound, its outcome is one that there is, and no count is negative or about to overflow.
bool is_sound(const Restart& restart);

/// It stands in a stage of the case, at a time that the stage has, with a state of its model, and has damage only
/// of its blocks. An ended run has no state and fits.
bool fits(const Restart& restart, const Case& the_case);

}  // namespace voussoir::app::results
