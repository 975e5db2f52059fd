// The time steps that a case leaves to the program.
#pragma once

#include "app/case/case.h"
#include "app/reader/findings.h"

namespace voussoir::app::reader
{

/// How much work the search for modes may be in a run of this case [floating-point operations]: next to nothing
/// beside its steps, or as much as it takes where the case says so.
double most_work_of_modes(const Case& the_case);

/// Gives each dynamic stage with `time_step: auto` the longest step that leaves the vibrations of the structure,
/// as it is drawn, alone; shortened so that frames fall on its ends.
void choose_time_steps(Case& the_case, Findings& findings);

}  // namespace voussoir::app::reader
