// Tables of two runs.
#pragma once

#include "app/report/document.h"
#include "app/report/run_record.h"

namespace voussoir::app::report
{

/// The largest displacements, drifts, openings, slips, thrusts and stresses of both, and how they differ.
Section key_figures_compared(const RunRecord& a, const RunRecord& b);

/// Stones and joints that both have, by name, those first that differ most; how many only one of them has.
Section stones_compared(const RunRecord& a, const RunRecord& b);

/// Steps, energies, run times.
Section computations_compared(const RunRecord& a, const RunRecord& b);

}  // namespace voussoir::app::report
