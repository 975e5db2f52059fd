// What the benchmarks that rock, knock and wave share: boxes with x horizontal, z up and y the thickness.
#pragma once

#include <string>
#include <vector>

#include "app/studies/scenes/materials.h"
#include "app/studies/scenes/scene_blocks.h"
#include "app/studies/scenes/stages.h"
#include "app/studies/verify/benchmark.h"
#include "libdda/model/model.h"
#include "libdda/model/state.h"
#include "libdda/run/run.h"

namespace voussoir::app::studies::verify
{

/// Runs a scene from rest and adds its cost to `result`; says there when the run gave up.
RunReport run_scene(const scenes::StagedScene& scene, State& state, const RunObserver& observer,
                    VerifyResult& result);

/// The lean of a block towards +x: angle of its z axis from the vertical in the plane x, z [rad].
double lean_of(const Model& model, const State& state, int block);

/// The share of critical damping that the integrator itself gives to a mode: omega h / 4, or `dissipation` of it.
double own_damping(const scenes::SceneSetting& setting, double omega);

/// `base` at these time steps, with both integrators.
std::vector<scenes::SceneSetting> sweep_of(scenes::SceneSetting base, const std::vector<double>& time_steps);

}  // namespace voussoir::app::studies::verify
