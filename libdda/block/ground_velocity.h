// How the ground under a scene moves.
#pragma once

#include "libdda/model/model.h"
#include "libdda/model/stage.h"

namespace voussoir::step
{

/// The velocity that complete kinetic damping would leave: that of the ground [m/s]; where supports move
/// differently, the mean of their motions, rest among them. @param time since the stage's start [s]
Eigen::Vector3d ground_velocity(const Model& model, const Stage& stage, double time);

}  // namespace voussoir::step
