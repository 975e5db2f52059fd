// A refinement and what it shows: the estimated error of every setting beside its cost.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/converge/estimate.h"
#include "app/studies/converge/measured_run.h"

namespace voussoir::app::studies::converge
{

enum class Varied { time_step, stiffness };

struct SeriesRow {
    ConvergeSetting setting;
    double time_step = 0;  // s, of the first dynamic stage
    RunCost cost;
    std::optional<Collapse> collapse;
    std::string failure;               // why there is no value
    std::optional<double> value;       // see value_of; none when the run failed or is not compared
    std::optional<double> error;       // -, distance from the reference
    std::optional<double> difference;  // -, to the next finer row that has a value
};

struct Series {
    Varied varied = Varied::time_step;
    Integrator integrator = Integrator::newmark;
    bool is_static = false;       // the case has no dynamic stage
    std::vector<SeriesRow> rows;  // coarse to fine
    std::optional<double> order;
    std::string no_order;             // why there is none
    std::optional<double> reference;  // value of the reference; none when no row has one
    double uncertainty = 0;           // -, of the reference
    double scale = 0;                 // what the shares are of [unit of the quantity]
    bool vanishes = false;  // the reference cannot be told from 0: shares are of the finest run, or where
                            // that is 0 of the largest
    std::vector<std::string> notes;
};

/// Fills in errors, differences, order and reference.
/// @param samples (rows); none where a run failed or is not compared
/// @param resolution a sample is known to half of it [unit of the samples]
/// @param value what stands for a sample in a table
void judge(Series& series, const std::vector<std::optional<Sample>>& samples, double resolution,
           const std::function<double(const Sample&)>& value);

/// Error and uncertainty of the reference together are within the tolerance.
bool meets(const Series& series, const SeriesRow& row, double tolerance);

/// The row with the least CPU time that meets a tolerance; null when none does.
const SeriesRow* cheapest(const Series& series, double tolerance);

/// What engineers ask of a settled answer, and of a first one.
inline constexpr double tolerances[] = {0.01, 0.05};

}  // namespace voussoir::app::studies::converge
