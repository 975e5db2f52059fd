// What a work-precision diagram shows of a benchmark.
#pragma once

#include "app/plots/diagram.h"
#include "app/studies/verify/runner.h"

namespace voussoir::app::studies::verify
{

/// Error against time step, against CPU time, and against contact stiffness where that was varied. Without
/// diagrams when there is no error to draw: nothing was swept, or every count is 0.
plots::Figure work_precision(const VerifyOutcome& outcome);

/// What the default run did beside its reference; its name ends in "-run". Without diagrams when the benchmark has
/// none.
plots::Figure picture(const VerifyOutcome& outcome);

}  // namespace voussoir::app::studies::verify
