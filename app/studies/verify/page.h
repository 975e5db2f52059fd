// docs/verification.md: the table, the diagrams and what every benchmark is, written by `voussoir verify`.
#pragma once

#include <string>
#include <vector>

#include "app/studies/verify/runner.h"

namespace voussoir::app::studies::verify
{

/// @param command how the page was made, written at its head
/// @param plots names of the benchmarks that have a diagram in `verification/NAME.png` beside the page
/// @param of_tables whether diagrams were left out, so that the page says how they are made
std::string verification_page(const std::vector<VerifyOutcome>& outcomes, const std::string& command,
                              const std::vector<std::string>& plots, bool of_tables);

}  // namespace voussoir::app::studies::verify
