#include "app/studies/stability/engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/words/diagnosis_words.h"
#include "importers/process/thread_time.h"
#include "libdda/analysis/diagnosis.h"

namespace voussoir::app::studies::stability
{

namespace
{

/// Only what the run says of the worth of its figures; what it says of the scene excuses no error.
void note_warnings(const Model& model, const std::vector<Stage>& stages, const RunReport& report, CellRun& cell)
{
    for (const auto& warning : {energy_warning(report.energy), overlap_warning(report)})
        if (warning) cell.warning += (cell.warning.empty() ? "" : "; ") + words::in_words(*warning, model, stages);
}

}  // namespace

bool run_counted(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer,
                 CellRun& cell)
{
    const double start = importers::process::thread_time();
    const RunReport report = run(model, stages, state, observer);
    cell.cpu_time += importers::process::thread_time() - start;
    cell.steps += report.steps;
    cell.step_cuts += report.step_cuts;
    cell.iterations += report.open_close_iterations;
    cell.energy_residual = report.energy.relative_residual();
    cell.max_penetration = std::max(cell.max_penetration, report.max_penetration);
    if (has_no_answer(report.outcome)) cell.diagnosis = words::message_of(report, model, stages);
    note_warnings(model, stages, report, cell);
    return !has_no_answer(report.outcome);
}

std::string run_reference(const Model& model, const std::vector<Stage>& stages, State& state,
                          const RunObserver& observer)
{
    const RunReport report = run(model, stages, state, observer);
    return has_no_answer(report.outcome) ? words::message_of(report, model, stages) : "";
}

std::string cell_name(const std::string& scene, const std::vector<std::string>& parts)
{
    std::string name = scene;
    for (const std::string& part : parts) name += "/" + part;
    return name;
}

StabilityCell& add_cell(StabilityScene& scene, const std::string& label, std::vector<CellParameter> parameters,
                        double time_step, std::function<CellRun()> run)
{
    constexpr double usual_budget = 60;  // s
    StabilityCell cell;
    std::vector<std::string> parts{label};
    if (time_step > 0) parts.push_back(fmt::format("h={:g}", time_step));
    cell.name = cell_name(scene.name, parts);
    cell.scene = scene.name;
    cell.parameters = std::move(parameters);
    cell.time_step = time_step;
    cell.reference = scene.reference;
    cell.tolerance = scene.tolerance;
    cell.budget = usual_budget;
    cell.run = std::move(run);
    scene.cells.push_back(std::move(cell));
    return scene.cells.back();
}

}  // namespace voussoir::app::studies::stability
