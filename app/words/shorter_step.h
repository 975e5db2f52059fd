// Remedies in numbers: how short a time step is to be.
#pragma once

#include <string>
#include <vector>

#include "libdda/model/stage.h"

namespace voussoir::app::words
{

/// A figure of one digit that is no larger.
double rounded_down(double value);

/// "time_step: 1 ms", so many times that of the stage; where steps follow their error, which is of third order,
/// "step_error: 0.01 mm".
std::string shorter_step(const Stage& stage, double factor);

/// The dynamic stage with the longest time step; none: the first stage, or nothing where there is none at all.
const Stage* longest_step(const std::vector<Stage>& stages);

}  // namespace voussoir::app::words
