#include "app/studies/stability/runner.h"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "app/studies/stability/cell_wire.h"
#include "app/words/figures_in_words.h"
#include "importers/process/child_process.h"
#include "libdda/errors.h"

namespace voussoir::app::studies::stability
{

namespace
{

constexpr double max_excused = 10;  // times the tolerance, as runs stop themselves at ten times what they warn of

}  // namespace

std::string_view name_of(CellOutcome outcome)
{
    switch (outcome) {
        case CellOutcome::passed:
            return "passed";
        case CellOutcome::refused:
            return "refused";
        case CellOutcome::stopped:
            return "stopped";
        case CellOutcome::warned:
            return "warned";
        case CellOutcome::wrong:
            return "wrong";
        case CellOutcome::crash:
            return "crash";
        case CellOutcome::timeout:
            break;
    }
    return "timeout";
}

bool is_failure(CellOutcome outcome)
{
    return outcome == CellOutcome::wrong || outcome == CellOutcome::crash || outcome == CellOutcome::timeout;
}

bool has_error(CellOutcome outcome)
{
    return outcome == CellOutcome::passed || outcome == CellOutcome::warned || outcome == CellOutcome::wrong;
}

CellRun run_here(const StabilityCell& cell)
{
    try {
        return cell.run();
    } catch (const InputError& error) {
        CellRun refused;
        for (const Fault& fault : error.faults)
            refused.refusal += (refused.refusal.empty() ? "" : "; ") + to_sentence(fault);
        return refused;
    }
}

CellOutcome judge(const StabilityCell& cell, const CellRun& run)
{
    if (!run.refusal.empty()) return CellOutcome::refused;
    if (!run.diagnosis.empty()) return CellOutcome::stopped;
    if (run.error <= cell.tolerance) return CellOutcome::passed;  // NaN is not
    // A warning says that figures are rough, not that anything goes; nor does it excuse a run that has none.
    const bool excused = run.error <= max_excused * cell.tolerance && !run.warning.empty();
    return excused ? CellOutcome::warned : CellOutcome::wrong;
}

namespace
{

std::string why(const StabilityCell& cell, CellOutcome outcome, const CellRun& run)
{
    if (outcome == CellOutcome::refused) return run.refusal;
    if (outcome == CellOutcome::stopped) return run.diagnosis;
    if (outcome == CellOutcome::passed) return "";
    const std::string said = run.warning.empty() ? "" : "; it warned: " + run.warning;
    if (!std::isfinite(run.error)) return "it ended without an answer: " + run.note + said;
    return fmt::format("error {} is beyond {}", words::error_in_words(run.error),
                       words::error_in_words(cell.tolerance)) +
           said;
}

}  // namespace

CellResult run_apart(const StabilityCell& cell, const CellLimits& limits)
{
    constexpr std::size_t max_output = std::size_t{1} << 20;  // bytes
    const importers::process::ChildAnswer answer = importers::process::ask_child(
        importers::process::helper_folder() / "voussoir-cell",
        to_json(CellRequest{cell.name, cell.budget, limits.memory}), limits.waiting * cell.budget, max_output);
    CellResult result;
    result.cell = cell;
    if (!answer.failure.empty()) {
        result.outcome = answer.out_of_time ? CellOutcome::timeout : CellOutcome::crash;
        result.diagnosis = answer.failure;
        return result;
    }
    try {
        result.run = cell_run_from_json(answer.output);
    } catch (const std::exception& error) {
        result.outcome = CellOutcome::crash;
        result.diagnosis = std::string("its answer is invalid: ") + error.what();
        return result;
    }
    result.outcome = judge(cell, result.run);
    result.diagnosis = why(cell, result.outcome, result.run);
    return result;
}

std::vector<CellResult> run_cells(const std::vector<StabilityCell>& cells, int jobs,
                                  const std::function<void(const CellResult&)>& done)
{
    std::vector<CellResult> results(cells.size());
    std::atomic<std::size_t> next{0};
    std::mutex telling;
    const auto work = [&] {
        for (std::size_t i = next++; i < cells.size(); i = next++) {
            results[i] = run_apart(cells[i], {});
            const std::lock_guard<std::mutex> lock(telling);
            done(results[i]);
        }
    };
    std::vector<std::jthread> others;
    for (int k = 1; k < jobs; ++k) others.emplace_back(work);
    work();
    others.clear();  // joins
    return results;
}

}  // namespace voussoir::app::studies::stability
