// Joints whose edge stress exceeds the strength of their stones. No block breaks: the exceedance is a result.
#pragma once

#include <optional>

#include "libdda/model/diagnosis.h"
#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Whether any material has a compressive strength to judge by.
bool has_compressive_strength(const Model& model);

/// Updates report.crushed from the joints of the state: see JointResultant::edge_stress.
/// @param elapsed of the dynamic step that led to it [s]; 0 at the end of a static stage
void note_crushing(const Model& model, const State& state, double elapsed, RunReport& report);

/// s: the force of an impact between stiff stones lasts as long as the time step, and its size depends on it.
constexpr double longest_impact = 0.02;

/// Above the strength at rest, or for longer than an impact lasts: what a warning is about.
bool is_lasting(const CrushedJoint& joint);

/// A warning when joints have exceeded their compressive strength for longer than impacts last: how many, and the
/// one that did so for longest.
std::optional<Diagnosis> crushed_warning(const RunReport& report);

}  // namespace voussoir
