// Runs cells, each in a process of its own under a budget of time and memory, and judges what comes back.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/studies/stability/cell.h"

namespace voussoir::app::studies::stability
{

enum class CellOutcome {
    passed,   // within its tolerance
    refused,  // before step one, with a reason
    stopped,  // the run gave up and said why
    warned,   // came to its end beyond its tolerance, and the run said that it should not be trusted
    wrong,    // came to its end beyond its tolerance in silence: the outcome that must not be
    crash,    // its process died
    timeout,  // beyond its budget
};
std::string_view name_of(CellOutcome outcome);

/// wrong, crash, timeout.
bool is_failure(CellOutcome outcome);

/// passed, warned, wrong: it came to its end.
bool has_error(CellOutcome outcome);

/// A cell and what became of it.
struct CellResult {
    StabilityCell cell;
    CellOutcome outcome = CellOutcome::passed;
    std::string diagnosis;  // why, unless it passed
    CellRun run;            // empty after a crash or a timeout
};

struct CellLimits {
    std::size_t memory = std::size_t{2} << 30;  // bytes, of a cell's process
    double waiting = 6;                         // times the budget: wall time after which a cell is ended
};

/// Runs one cell in this process. What it throws as InputError is a refusal.
CellRun run_here(const StabilityCell& cell);

/// What became of a run that came back.
CellOutcome judge(const StabilityCell& cell, const CellRun& run);

/// Runs one cell in a process of its own, the helper program voussoir-cell beside this one.
CellResult run_apart(const StabilityCell& cell, const CellLimits& limits);

/// Runs all cells, `jobs` at a time. @param done called after each, one call at a time
/// @returns in the order of the cells
std::vector<CellResult> run_cells(const std::vector<StabilityCell>& cells, int jobs,
                                  const std::function<void(const CellResult&)>& done);

}  // namespace voussoir::app::studies::stability
