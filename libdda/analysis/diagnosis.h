// What a run that goes wrong says of itself: which blocks, the likely cause, the remedy.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Least width of every block over the directions of its faces [m]: the thickness of a slab, the shorter side of a
/// slender stone. Of glued parts the least.
std::vector<double> least_widths(const Model& model);

/// What is wrong with a step that converged, after which to go on would be nonsense: blocks deep within one
/// another, energy that nothing accounts for, places that are no numbers. @param widths least_widths(model)
/// @returns nothing when all is well
std::optional<std::string> diagnose(const Model& model, const std::vector<double>& widths, const State& state,
                                    const RunReport& report);

/// A warning when more than residual_worth_a_warning of all energy is unaccounted for.
std::optional<std::string> energy_warning(const EnergyLedger& energy);

/// Why a step that was cut to the end did not converge, and what to do. @param cuts of it
std::string explain(const Model& model, const Stage& stage, const State& state, const StepReport& step);

}  // namespace voussoir
