// Joints whose edge stress exceeds the strength of their stones. No block breaks: the exceedance is a result.
#pragma once

#include <string>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// Whether any material has a compressive strength to judge by.
bool has_compressive_strength(const Model& model);

/// Updates report.crushed from the joints of the state: see JointResultant::edge_stress.
void note_crushing(const Model& model, const State& state, RunReport& report);

/// "3 joints exceed their compressive strength, worst ...". @returns empty when none does
std::string crushed_in_words(const Model& model, const RunReport& report);

}  // namespace voussoir
