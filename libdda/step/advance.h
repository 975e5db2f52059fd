// One time step: the function to read first.
#pragma once

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/step/workspace.h"

namespace voussoir
{

/// Advances the state by one time step of at most `time_step` [s]: finds contacts, assembles, iterates open-close,
/// judges or cuts the step, updates. On gave_up the state is untouched. Energies of the step are added to
/// `energy`.
StepReport advance(const Model& model, const Stage& stage, double time_step, State& state, EnergyLedger& energy,
                   Workspace& work);

}  // namespace voussoir
