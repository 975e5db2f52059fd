// Displacements of the points that a case follows, as a report counts them.
#pragma once

#include <string>
#include <vector>

#include "app/report/run_record.h"

namespace voussoir::app::report
{

struct PointHistory {
    std::vector<double> times;  // s
    std::vector<double> moved;  // m, as results::counted_from() says
};

/// @param column of histories.csv, a displacement: "crown ux [m]"
PointHistory point_history(const RunRecord& record, const std::string& column);

/// Whether a column of histories.csv is of the foot of the structure.
bool is_of_foot(const std::string& column);

}  // namespace voussoir::app::report
