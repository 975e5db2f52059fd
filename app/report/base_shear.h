// What the structure exerts on its supports sideways.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/run_record.h"

namespace voussoir::app::report
{

/// The weight of all stones that are no support, under the gravity that the last stage comes to [N].
double weight_of(const RunRecord& record);

/// The largest base shear over the stored moments, of the weight; nothing without weight or supports.
std::optional<Peak> base_shear_of(const RunRecord& record);

/// The same as a row of key results; empty where there is none.
std::vector<std::string> base_shear_row(const RunRecord& record);

}  // namespace voussoir::app::report
