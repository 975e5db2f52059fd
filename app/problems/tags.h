// What a step is an example of, in words.
#pragma once

#include <string>
#include <vector>

#include "libdda/model/model.h"
#include "libdda/model/report.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"

namespace voussoir::app::problems
{

/// A step that was made.
struct SeenStep {
    const State& before;
    const State& after;
    const StepReport& report;
    double impact = 0, fracture = 0;  // J, in this step
};

/// Of the model: planar, deformable, bars, boundary, tied sides, ... Of the step: rest, moving, rocking, sliding,
/// reversal, sticking, landing, knocking, breaking, divided, cut.
std::vector<std::string> tags_of(const Model& model, const Stage& stage, const SeenStep& step);

}  // namespace voussoir::app::problems
