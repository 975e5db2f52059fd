// The verdict on a structure, for summary.json.
#pragma once

#include <string>

#include "libdda/model/model.h"
#include "libdda/model/verdict.h"

namespace voussoir::app::results
{

/// JSON: keys in docs/results_format.md.
std::string verdict_json(const Verdict& verdict, const Model& model);

}  // namespace voussoir::app::results
