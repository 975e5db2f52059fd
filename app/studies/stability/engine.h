// How cells use the engine: stages at their defaults, runs that are counted.
#pragma once

#include <string>
#include <vector>

#include "app/studies/scenes/materials.h"
#include "app/studies/scenes/stages.h"
#include "app/studies/stability/cell.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/run/run.h"

namespace voussoir::app::studies::stability
{

/// Runs the stages from the state and counts into `cell`.
/// @returns whether it came to the end; else cell.diagnosis says why not. cell.warning: what the report warns of,
/// but for stones that fell or were crushed, which are results
bool run_counted(const Model& model, const std::vector<Stage>& stages, State& state, const RunObserver& observer,
                 CellRun& cell);

/// The same for what a cell is compared with: nothing is counted.
/// @returns why it gave up; empty when it did not
std::string run_reference(const Model& model, const std::vector<Stage>& stages, State& state,
                          const RunObserver& observer);

/// A name for a cell of a scene: sliding/k=1e+08/h=0.001. @param parts "k=1e+08", "h=0.001"
std::string cell_name(const std::string& scene, const std::vector<std::string>& parts);

/// Adds a cell with a budget of 60 s. @param label of its parameters, for its name; @param time_step [s], 0:
/// static
StabilityCell& add_cell(StabilityScene& scene, const std::string& label, std::vector<CellParameter> parameters,
                        double time_step, std::function<CellRun()> run);

}  // namespace voussoir::app::studies::stability
