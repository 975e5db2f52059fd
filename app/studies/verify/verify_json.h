// What `voussoir verify --json` writes.
#pragma once

#include <string>
#include <vector>

#include "app/studies/verify/runner.h"

namespace voussoir::app::studies::verify
{

/// A list of {benchmark, source, quantity, rows: [{method, time_step_s, error, cpu_time_s, steps, iterations}],
/// error, tolerance, paper_error, pass}, with more beside: title, choices, note, stiffness_factor, failure,
/// orders. An error that does not exist is null.
std::string verify_json(const std::vector<VerifyOutcome>& outcomes);

}  // namespace voussoir::app::studies::verify
