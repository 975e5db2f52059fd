// What voussoir and its helper voussoir-cell say to each other, and the figures of `stability --json`: JSON text.
#pragma once

#include <string>
#include <vector>

#include "app/studies/stability/cell.h"
#include "app/studies/stability/runner.h"

namespace voussoir::app::studies::stability
{

/// Which cell to run, and what it may take.
struct CellRequest {
    std::string name;
    double budget = 0;       // s of processor time
    std::size_t memory = 0;  // bytes
};

std::string to_json(const CellRequest& request);

/// @throws std::exception when the text is not what to_json wrote
CellRequest cell_request_from_json(const std::string& text);

std::string to_json(const CellRun& run);

/// @throws std::exception when the text is not what to_json wrote
CellRun cell_run_from_json(const std::string& text);

/// {cells: [{name, scene, parameters: {name: value with unit}, time_step_s, outcome, reference, error, tolerance,
/// diagnosis, steps, step_cuts, iterations, cpu_time_s, ...}], engine}; error is null when the cell has none.
/// @param engine JSON text of engine_json
std::string stability_json(const std::vector<CellResult>& results, const std::string& engine);

}  // namespace voussoir::app::studies::stability
