// Judges a run that is under way: what is wrong with it, and which blocks have to do with it.
#pragma once

#include <optional>

#include "libdda/analysis/overlaps.h"
#include "libdda/model/diagnosis.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// What is wrong with a step that converged, after which to go on would be nonsense: blocks deep within one
/// another (as noted in the report), energy that nothing accounts for or that contacts made when they were found
/// anew, places that are no numbers. @returns nothing when all is well
std::optional<Diagnosis> diagnose(const Model& model, const State& state, const RunReport& report);

/// Why a run cannot begin: two blocks that overlap as drawn by more than deepest_share of the thinner one's width.
std::optional<Diagnosis> start_diagnosis(const std::vector<DrawnOverlap>& overlaps);

/// A warning when more than residual_worth_a_warning of all energy is unaccounted for, or came from contacts found
/// anew.
std::optional<Diagnosis> energy_warning(const EnergyLedger& energy);

/// A warning when blocks were so far within one another that the answer depends on the contacts' softness.
std::optional<Diagnosis> overlap_warning(const RunReport& report);

/// A warning when a dynamic stage is about to give the ground another velocity from one moment to the next: the
/// stage before it left the ground moving, or a motion does not start from rest. @param state at its start
std::optional<Diagnosis> ground_jump_warning(const Model& model, const Stage& stage, const State& state);

/// Why a step that was cut to the end did not converge. @param state at its start
Diagnosis explain(const Stage& stage, const State& state, const StepReport& step);

}  // namespace voussoir
