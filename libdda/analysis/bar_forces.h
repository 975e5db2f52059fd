// What bars carry: tie rods, cramps, dowels.
#pragma once

#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/state.h"

namespace voussoir
{

/// A bar in a state.
struct BarNow {
    double axial = 0;       // N, tension > 0
    double shear = 0;       // N
    double elongation = 0;  // m, along its axis since the start of the run
    double slide = 0;       // m, across it
    double yielded = 0;     // m, how far from where it was its length and place without force have gone
    bool is_out = false;    // a dowel that has left its hole
};

/// All bars of a state, in their order.
std::vector<BarNow> bars_now(const Model& model, const State& state);

/// Brings report.bars up to this state.
void note_bars(const Model& model, const State& state, RunReport& report);

}  // namespace voussoir
