// What the scenes that rock, knock and wave are built from: boxes with x horizontal, z up and y the thickness.
#pragma once

#include <string>
#include <vector>

#include "app/verify/benchmark.h"
#include "app/verify/scene_blocks.h"
#include "libdda/model/model.h"
#include "libdda/model/stage.h"
#include "libdda/model/state.h"
#include "libdda/run/run.h"

namespace voussoir::dynamic_scenes
{

constexpr double gravity = 9.81;  // m/s2

/// A scene ready to run.
struct Scene {
    Model model;
    std::vector<Stage> stages;
};

/// The documented default stiffness times `setting.stiffness_factor`; the rule itself when there is none.
/// Source: docs/method.md. @param compliance L_a/E_a + L_b/E_b of the blocks that are not held [m/Pa]
ContactStiffness stiffness_by_rule(const VerifySetting& setting, double compliance);

/// 2 f / compliance, f = 10 for deformable blocks and 1 for rigid ones [Pa/m].
double default_stiffness(Kinematics kinematics, double compliance);

Stage static_stage(const VerifySetting& setting, const Eigen::Vector3d& g = {0, 0, -gravity});
Stage dynamic_stage(const VerifySetting& setting, double duration, const Eigen::Vector3d& g = {0, 0, -gravity});

/// Runs a scene from rest and adds its cost to `result`; says there when the run gave up.
RunReport run_scene(const Scene& scene, State& state, const RunObserver& observer, VerifyResult& result);

/// The lean of a block towards +x: angle of its z axis from the vertical in the plane x, z [rad].
double lean_of(const Model& model, const State& state, int block);

/// The share of critical damping that the integrator itself gives to a mode: omega h / 4, or `dissipation` of it.
double own_damping(const VerifySetting& setting, double omega);

/// `base` at these time steps, with both integrators.
std::vector<VerifySetting> sweep_of(VerifySetting base, const std::vector<double>& time_steps);

}  // namespace voussoir::dynamic_scenes
