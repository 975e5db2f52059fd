// When a structure begins to move as gravity turns or grows.
#pragma once

#include <string>
#include <vector>

#include "app/report/run_record.h"

namespace voussoir::app::report
{

/// Gravity when the first joint opened or slid by 0.1 mm more than as gravity began to turn or grow in a stage, as
/// a row of key results; empty where it does neither.
std::vector<std::string> onset_row(const RunRecord& record);

}  // namespace voussoir::app::report
