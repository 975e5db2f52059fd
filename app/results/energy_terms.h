// The energy ledger as a list of named columns.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "libdda/model/report.h"

namespace voussoir::app::results
{

/// Every term of the ledger with its name in the files ("friction_J") [J], in a fixed order; residual_J last.
std::vector<std::pair<std::string, double>> energy_terms(const EnergyLedger& energy);

}  // namespace voussoir::app::results
