// The verification table in words, for a terminal.
#pragma once

#include <string>
#include <vector>

#include "app/studies/verify/runner.h"

namespace voussoir::app::studies::verify
{

/// The line above the table.
std::string table_head();

/// One benchmark: paper's error, ours, tolerance, time step, CPU seconds per simulated second, pass; under it the
/// reason where there is no error, and what else the run showed.
std::string table_line(const VerifyOutcome& outcome);

/// The rows of a sweep and the observed orders of convergence; empty without a sweep.
std::string sweep_lines(const VerifyOutcome& outcome);

}  // namespace voussoir::app::studies::verify
