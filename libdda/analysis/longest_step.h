// The step that a stage whose time_step is automatic begins with.
#pragma once

#include <array>
#include <vector>

#include "libdda/analysis/modes.h"
#include "libdda/model/stage.h"

namespace voussoir
{

/// The steps there are to choose among [s], longest first.
inline constexpr std::array usual_steps{8e-3, 4e-3, 2e-3, 1e-3, 0.5e-3, 0.25e-3};

/// Where nobody sought the modes [s]: it damps vibrations up to 31 Hz within the limit.
constexpr double step_of_unknown_modes = 2e-3;

/// The longest of the usual steps in which the integrator damps what vibrates, and lengthens its periods, within
/// the limits of trust.h, and which follow the motions of the stage: a line between the accelerations at the ends
/// of a step is off in its middle by no more than a twentieth of them, both as root mean squares.
double longest_step(const NaturalModes& modes, const Stage& stage);

/// How often the step of the stage is to be halved for that of what vibrates; at most five times.
int halvings_for(const NaturalModes& modes, const Stage& stage);

/// How much work a search for modes may be beside the steps of a run [floating-point operations].
double work_worth_the_modes(const Model& model, const std::vector<Stage>& stages);

}  // namespace voussoir
