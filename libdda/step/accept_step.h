// The end of a step that holds.
#pragma once

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/step/work.h"

namespace voussoir::step
{

/// Brings blocks, contacts and clocks to the end of the step that was solved in `work`, books its energies in
/// `energy` and what came of it in `report`.
template <class K>
void accept_step(const Model& model, const Stage& stage, const Work<K>& work, State& state, EnergyLedger& energy,
                 StepReport& report);

}  // namespace voussoir::step
