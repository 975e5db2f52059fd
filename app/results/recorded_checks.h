// What must hold of what was read from a results file before anything is drawn or computed from it.
#pragma once

#include <string>

#include "app/results/results_reader.h"

namespace voussoir::app::results
{

/// Lists and indices fit each other. @param place the file, for faults
/// @throws InputError with the first thing that does not hold
void check_recorded(const RecordedModel& model, const std::string& place);

/// The frame has a place and a velocity for every block of the model, and joints between its blocks.
/// @throws InputError as above
void check_recorded(const RecordedFrame& frame, const RecordedModel& model, const std::string& place);

}  // namespace voussoir::app::results
