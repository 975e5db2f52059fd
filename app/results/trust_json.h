// How far a run can be trusted, for summary.json.
#pragma once

#include <string>
#include <vector>

#include "libdda/analysis/trust.h"

namespace voussoir::app::results
{

/// JSON: keys in docs/results_format.md.
std::string trust_json(const Trust& trust, const std::vector<Stage>& stages);

}  // namespace voussoir::app::results
