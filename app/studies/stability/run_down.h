// A block slides down a plane: the motion that several extreme scenes share.
#pragma once

#include "app/studies/stability/cell.h"
#include "libdda/model/model.h"

namespace voussoir::app::studies::stability
{

/// Block 1 of the scene slides for 1 s along x down a plane that dips by `angle` [degrees], which lies in the x-y
/// plane while gravity leans. It starts as a rigid block does: at rest with its friction mobilised. Error:
/// distance from g (sin a - mu cos a) t^2 / 2 at the end / that distance; of a block that must not slide, its
/// displacement since it stood at rest / its size.
/// @param friction coefficient
void run_down(const Model& model, double angle, double friction, double g, double time_step, CellRun& cell);

}  // namespace voussoir::app::studies::stability
