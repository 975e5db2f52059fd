// What a work-precision diagram shows of a benchmark.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/verify/diagram.h"

namespace voussoir
{

struct PlotRow {
    std::string method;
    double time_step = 0, cpu_time = 0;      // s
    std::optional<double> stiffness_factor;  // times the default
    std::optional<double> error;             // none: the run failed
};

struct PlotData {
    std::string title, source;
    std::vector<PlotRow> rows;
    double tolerance = 0;
    std::optional<double> paper_level;
    std::string paper_error;
};

/// Error against time step, against CPU time, and against contact stiffness where that was varied.
Figure work_precision(const PlotData& data);

}  // namespace voussoir
