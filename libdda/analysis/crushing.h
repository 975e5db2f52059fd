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
void note_crushing(const Model& model, const State& state, RunReport& report);

/// A warning when joints have exceeded their compressive strength: how many, and the worst of them.
std::optional<Diagnosis> crushed_warning(const RunReport& report);

}  // namespace voussoir
